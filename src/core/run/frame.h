// What a viewer needs of one simulation step, free of MuJoCo: everything drawn in one frame comes from one SimFrame.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/run/history/breakpoints.h"
#include "core/run/history/lanes.h"
#include "core/run/step.h"
#include "core/run/step_cost.h"
#include "core/run/trace.h"

namespace taxel {

/// The latest steps, any of which can be shown again.
struct HistoryState {
  std::uint64_t first = 0, last = 0;  ///< steps that are kept
  std::size_t steps = 0;              ///< how many those are
  std::size_t bytes = 0;              ///< memory that they take
  double step_seconds = 0;            ///< mean wall time that recording one of the latest steps took [s]
  StepHistoryLimits limits;
  std::shared_ptr<const HistoryLanes> lanes;  ///< all of them, up to the newest or a little before; never null
};

/// The result of a RecallCommand.
struct RecalledSteps {
  std::uint64_t number = 0;    ///< RecallCommand::number
  std::vector<StepPtr> steps;  ///< requested steps that the history still holds
};

/// The scene was written to a file, or could not be.
struct SavedScene {
  std::uint64_t number = 0;  ///< counts
  std::string file, error;   ///< error empty: it was
};

/// Every step that is made is kept, whatever the history holds.
struct RecordingState {
  bool on = false;
  std::size_t steps = 0, bytes = 0;  ///< so far; the memory that they take
  double seconds = 0;                ///< simulated
};

/// A recording was written, or could not be: then it is kept until it is, or another one begins.
struct WrittenRecording {
  std::uint64_t number = 0;  ///< counts
  std::string file, error;   ///< error empty: it was
  std::size_t rows = 0;
  std::string note;   ///< what the user should know of it; may be empty
  bool kept = false;  ///< WriteRecordingCommand writes it elsewhere
};

/// A step, with the state of the simulation around it.
struct SimFrame : Step {
  bool playing = false;
  double speed = 1.0;                     ///< wanted, in multiples of real time
  double measured_speed = 0;              ///< reached lately
  ControlValues controls;                 ///< of scene->controls
  std::optional<PerturbShown> perturbed;  ///< none while a step of the past is shown
  std::shared_ptr<const Trace> trace;     ///< copied when a row is added, at most 30 times a second
  std::vector<std::string> warnings;  ///< all that the sensors have to say about the scene, as Simulator::warnings()
  double step_seconds = 0;            ///< mean wall time of one of the latest steps [s]; 0: none was made
  std::vector<StepCost> costs;        ///< of the latest steps that were made, oldest first
  bool recorded = false;              ///< a step of the past is shown; the newest is history.last
  std::shared_ptr<const SimScene> simulated;  ///< of the newest step: another than `scene` where its layout changed
  HistoryState history;
  /// The previous step, after a FollowStepBeforeCommand, while the simulation does not run by itself and if the history
  /// holds the step. Otherwise null.
  StepPtr before;
  std::shared_ptr<const RecalledSteps> recalled;  ///< last; null: none were asked for
  Breakpoints breakpoints;
  std::optional<Stop> stop;        ///< the breakpoint that was met, until the simulation goes on
  std::uint64_t runs = 0;          ///< times that the simulation began at its start
  std::uint64_t commands = 0;      ///< executed so far
  std::uint64_t loads = 0;         ///< scenes asked for so far, whether built or refused
  std::uint64_t replacements = 0;  ///< likewise models to replace
  SavedScene saved;                ///< last
  RecordingState recording;
  WrittenRecording written;  ///< last
  bool failed = false;       ///< `error` is the simulation's own: it goes on only from an earlier step, or the start
  std::string error;         ///< why the simulation stopped, or the last scene or model was refused; empty: fine
};
using SimFramePtr = std::shared_ptr<const SimFrame>;

}  // namespace taxel
