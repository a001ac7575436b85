// Events of a simulation: replies to commands, and changes that the simulation reports by itself.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/run/frame.h"

namespace taxel {

/// Number of a command: 1, 2, ... in the order in which commands are sent to a simulation. 0 is no command.
using CommandId = std::uint64_t;

/// A command was carried out that has no other result.
struct Done {};
/// A scene or a model was refused. The previous one stays.
struct Refused {
  std::string why;
};
/// A scene was loaded and is paused.
struct SceneLoaded {};
/// The model of at least one sensor was replaced.
struct ModelReplaced {};
/// The result of a SaveSceneCommand or a NameLayoutCommand.
struct SceneSaved {
  std::string file, error;  ///< the error is empty if the file was written
  std::string note = {};    ///< a remark for the user; may be empty
};
/// The result of writing a recording. A recording that could not be written is retained until another one begins.
struct RecordingWritten {
  std::string file, error;  ///< the error is empty if the file was written
  std::size_t rows = 0;     ///< number of written rows
  std::string note;         ///< a remark for the user; may be empty
  bool kept = false;        ///< the recording is retained; WriteRecordingCommand writes it elsewhere
};
/// The result of a RecallCommand: the requested steps that the history still holds.
struct StepsRecalled {
  std::vector<StepPtr> steps;
  int asker = 0;  ///< RecallCommand::asker
};
/// A run was started, from the beginning or from a keyframe.
struct RunStarted {
  std::uint64_t run = 0;  ///< number of the run, as SimFrame::runs
};
/// A breakpoint stopped the simulation.
struct Stopped {
  Stop stop;
  std::shared_ptr<const SimScene> scene;  ///< scene of the step that stopped the simulation
};
/// The simulation reached the end of the scenario.
struct Finished {};
/// The simulation failed.
struct Failed {
  std::string why;
};
/// A sensor or the recording has a remark about the loaded scene. Each text is reported once per scene.
struct Warned {
  std::string text;
};

using SimReport = std::variant<Done, Refused, SceneLoaded, ModelReplaced, SceneSaved, RecordingWritten, StepsRecalled,
                               RunStarted, Stopped, Finished, Failed, Warned>;

/// One report. Each command that is carried out has at least one.
struct SimEvent {
  CommandId reply_to = 0;  ///< command that caused the event, or 0 for a step in real time
  SimReport what;
};

/// The replies of a simulation since they were taken last.
struct SimReplies {
  SimFramePtr frame;             ///< newest frame, which includes the effect of all events, or null
  std::vector<SimEvent> events;  ///< all events, in order
};

}  // namespace taxel
