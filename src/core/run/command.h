// What a viewer may ask of the simulation; executed between two steps, in order.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/document/scenario/scenario.h"
#include "core/run/controls.h"
#include "core/run/history/breakpoints.h"
#include "core/run/history/lanes.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

struct PlayCommand {};
struct PauseCommand {};
struct StepCommand {
  int steps = 1;
};
struct ResetCommand {};
struct SpeedCommand {
  double factor = 1.0;
};  ///< multiples of real time
struct LoadScenarioCommand {
  SensorModelPtr model;
  Scenario scenario;
};
/// The sensors that read by `replaced` read by `model` from now on: the state stays as it is, and its readings are made
/// anew. Nothing happens where no sensor does.
struct ReplaceModelCommand {
  SensorModelPtr replaced, model;
};
/// MJCF with its own sensors, and layouts attached to others of its geoms.
struct LoadSceneCommand {
  std::string file;
  std::vector<SceneAttachment> attachments = {};
};
/// Writes the scene that runs, with all its sensors declared, as an MJCF file; what it needs beside it, in a folder of
/// the same name. SimFrame::saved tells of it.
struct SaveSceneCommand {
  std::string file;
};
/// Pauses, and shows a step of the history, or the nearest that is kept. Where the simulation runs on, it does so from
/// that step, and what came after it is forgotten.
struct ScrubCommand {
  std::uint64_t step = 0;
};
/// Whether frames carry the step before the one that they show.
struct FollowStepBeforeCommand {
  bool on = false;
};
/// SimFrame::recalled gets these steps of the history; nothing else changes.
struct RecallCommand {
  std::uint64_t number = 0;  ///< told in the answer
  std::vector<std::uint64_t> steps;
};
struct BreakpointsCommand {
  Breakpoints breakpoints;
};
struct StepHistoryLimitsCommand {
  StepHistoryLimits limits;
};
/// Nothing happens while a step of the past is shown. What is set between two steps is no step: the recorded ones stay
/// as they were, and the next one goes on from it.
struct EditSceneCommand {
  SceneEdit edit;
};
/// The run begins anew, at a keyframe of the scene; pauses.
struct LoadKeyframeCommand {
  int keyframe = 0;
};
/// Every step is kept from now on. Nothing happens where one runs already. It ends by EndRecordingCommand, with the
/// run, where another layout reads, and where it takes kMostRecordedBytes; then it is written.
struct RecordCommand {
  std::string file;  ///< as write_recording() takes it
};
struct EndRecordingCommand {};
/// Writes a recording that could not be written where it was to be.
struct WriteRecordingCommand {
  std::string file;
};
/// Writes what the history holds, of all steps or of these, that the layout of the last one read.
struct ExportHistoryCommand {
  std::string file;
  std::optional<StepRange> steps = {};
};
struct QuitCommand {};

using SimCommand =
    std::variant<PlayCommand, PauseCommand, StepCommand, ResetCommand, SpeedCommand, LoadScenarioCommand,
                 ReplaceModelCommand, LoadSceneCommand, SaveSceneCommand, ScrubCommand, FollowStepBeforeCommand,
                 RecallCommand, BreakpointsCommand, StepHistoryLimitsCommand, EditSceneCommand, LoadKeyframeCommand,
                 RecordCommand, EndRecordingCommand, WriteRecordingCommand, ExportHistoryCommand, QuitCommand>;

}  // namespace taxel
