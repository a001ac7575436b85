// A frame: one step with the state of the simulation around it. Everything drawn at one time comes from one SimFrame.
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

/// The recorded steps, each of which can be displayed again.
struct HistoryState {
  std::uint64_t first = 0, last = 0;  ///< range of the recorded steps
  std::size_t steps = 0;              ///< number of recorded steps
  std::size_t bytes = 0;              ///< memory that the recorded steps take
  double step_seconds = 0;            ///< mean wall time of recording a step, over the latest steps [s]
  StepHistoryLimits limits;
  /// Rows of the recorded steps; the newest rows may be missing. Never null.
  std::shared_ptr<const HistoryLanes> lanes;
};

/// The result of a RecallCommand.
struct RecalledSteps {
  std::uint64_t number = 0;    ///< RecallCommand::number
  std::vector<StepPtr> steps;  ///< requested steps that the history still holds
};

/// The result of a SaveSceneCommand.
struct SavedScene {
  std::uint64_t number = 0;  ///< number of results so far
  std::string file, error;   ///< the error is empty if the file was written
};

/// The recording that is being made. It holds every step, whatever the limits of the history are.
struct RecordingState {
  bool on = false;
  std::size_t steps = 0, bytes = 0;  ///< number of recorded steps, and the memory that they take
  double seconds = 0;                ///< simulated time
};

/// The result of writing a recording. A recording that could not be written is retained until another one begins.
struct WrittenRecording {
  std::uint64_t number = 0;  ///< number of results so far
  std::string file, error;   ///< the error is empty if the file was written
  std::size_t rows = 0;      ///< number of written rows
  std::string note;          ///< a remark for the user; may be empty
  bool kept = false;         ///< the recording is retained; WriteRecordingCommand writes it elsewhere
};

/// A step, with the state of the simulation around it.
struct SimFrame : Step {
  bool playing = false;
  double speed = 1.0;                     ///< requested speed, in multiples of real time
  double measured_speed = 0;              ///< speed over the latest half second
  ControlValues controls;                 ///< values of scene->controls
  std::optional<PerturbShown> perturbed;  ///< empty while a recorded step is displayed
  std::shared_ptr<const Trace> trace;     ///< copied when a row is added, at most 30 times per second
  std::vector<std::string> warnings;      ///< Simulator::warnings(), and failures of the recording
  double step_seconds = 0;                ///< mean wall time of the latest steps [s]; 0 before the first step
  std::vector<StepCost> costs;            ///< costs of the latest steps, oldest first
  bool recorded = false;                  ///< a recorded step is displayed; the newest step is history.last
  /// Scene of the newest step; differs from `scene` if a later step has another layout.
  std::shared_ptr<const SimScene> simulated;
  HistoryState history;
  /// The previous step, after a FollowStepBeforeCommand, while the simulation does not run by itself and if the history
  /// holds the step. Otherwise null.
  StepPtr before;
  std::shared_ptr<const RecalledSteps> recalled;  ///< latest result; null before the first RecallCommand
  Breakpoints breakpoints;
  std::optional<Stop> stop;        ///< event that stopped the simulation; empty when the simulation continues
  std::uint64_t runs = 0;          ///< number of runs that were started
  std::uint64_t commands = 0;      ///< number of executed commands
  std::uint64_t loads = 0;         ///< number of executed load commands, successful or refused
  std::uint64_t replacements = 0;  ///< number of executed ReplaceModelCommands, successful or refused
  SavedScene saved;                ///< latest result
  RecordingState recording;
  WrittenRecording written;  ///< latest result
  bool failed = false;       ///< the simulation failed; it continues only from an earlier step or the start
  /// Why the simulation failed, or why the latest scene or model was refused. Empty without an error.
  std::string error;

  [[nodiscard]] StepId id() const { return {runs, step, scene ? scene->model_edition : 0}; }
};
using SimFramePtr = std::shared_ptr<const SimFrame>;

}  // namespace taxel
