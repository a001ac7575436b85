// Commands to the simulation. They are carried out in order, between two steps.
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
#include "core/run/lead.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

struct PlayCommand {};
struct PauseCommand {};
struct StepCommand {
  int steps = 1;
};
struct ResetCommand {};
/// Sets the speed, in multiples of real time.
struct SpeedCommand {
  double factor = 1.0;
};
struct LoadScenarioCommand {
  SensorModelPtr model;
  Scenario scenario;
};
/// Replaces the model of all sensors that use `replaced`. The state stays as it is, and the sensors read it again. Does
/// nothing if no sensor uses `replaced`.
struct ReplaceModelCommand {
  SensorModelPtr replaced, model;
};
/// Loads an MJCF file with its own sensors, and attaches layouts to other geoms of it. The run starts at the keyframe
/// of `lead`, and the files of `lead` lead it.
struct LoadSceneCommand {
  std::string file;
  std::vector<SceneAttachment> attachments = {};
  LeadRequest lead = {};
  bool keeps_controls = false;  ///< actuators start with the controls of the loaded scene
};
/// Writes the loaded scene as an MJCF file that declares all its sensors: the file on disk with additions for the
/// attached layouts. If that is not possible, writes the whole scene again, and the files that it needs into a folder
/// of the same name. The reply is SceneSaved, whose note says so.
struct SaveSceneCommand {
  std::string file;
};
/// Lets the sensors that a scene's file declares on `geoms` read a layout file, which exists: the names are written
/// into `scene` or the files that it includes. The reply is SceneSaved.
struct NameLayoutCommand {
  std::string scene;
  std::vector<std::string> geoms;
  std::string layout;
};
/// Pauses and displays a recorded step, or the nearest recorded one. When the simulation continues, it continues from
/// the displayed step and discards all later steps.
struct ScrubCommand {
  std::uint64_t step = 0;
};
/// Whether frames have the previous step in SimFrame::before.
struct FollowStepBeforeCommand {
  bool on = false;
};
/// Requests recorded steps. The reply is StepsRecalled with the same `asker`. Nothing else changes.
struct RecallCommand {
  std::vector<std::uint64_t> steps;
  int asker = 0;  ///< number by which the sender knows its reply
};
struct BreakpointsCommand {
  Breakpoints breakpoints;
};
struct StepHistoryLimitsCommand {
  StepHistoryLimits limits;
};
/// Edits the present state, without making a step. The recorded steps stay as they are, and the next step begins from
/// the edited state. Does nothing while a recorded step is displayed.
struct EditSceneCommand {
  SceneEdit edit;
};
/// Pauses and starts a new run from a keyframe of the scene.
struct LoadKeyframeCommand {
  int keyframe = 0;
};
/// Starts a recording of every step. Does nothing while a recording is being made. The recording ends and is written
/// at EndRecordingCommand, at the end of the run, when another layout reads, or at kMaxRecordedBytes.
struct RecordCommand {
  std::string file;         ///< path for write_recording()
  bool error_bars = false;  ///< whether the rows get error bars, measured in each step
};
struct EndRecordingCommand {};
/// Writes a recording that could not be written to its own file.
struct WriteRecordingCommand {
  std::string file;
};
/// Writes recorded steps of the history that have the layout of the last one of them.
struct ExportHistoryCommand {
  std::string file;
  std::optional<StepRange> steps = {};  ///< all steps if empty
  bool error_bars = false;              ///< whether the rows get error bars
};
struct QuitCommand {};

using SimCommand = std::variant<PlayCommand, PauseCommand, StepCommand, ResetCommand, SpeedCommand, LoadScenarioCommand,
                                ReplaceModelCommand, LoadSceneCommand, SaveSceneCommand, NameLayoutCommand,
                                ScrubCommand, FollowStepBeforeCommand, RecallCommand, BreakpointsCommand,
                                StepHistoryLimitsCommand, EditSceneCommand, LoadKeyframeCommand, RecordCommand,
                                EndRecordingCommand, WriteRecordingCommand, ExportHistoryCommand, QuitCommand>;

}  // namespace taxel
