// The recordings of a simulation: every step between two commands, and the recorded steps of its history.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "core/run/command.h"
#include "core/run/event.h"
#include "core/run/history/step_history.h"
#include "core/sim/host/live_recording.h"
#include "core/sim/simulator.h"

namespace taxel {

/// Makes and writes the recordings of one simulation. `simulator` is null while no scene is loaded. No function throws.
class SimRecordings {
 public:
  /// `report` is called with RecordingWritten, and with Warned if a recording has no journal.
  explicit SimRecordings(std::function<void(SimReport)> report) : report_(std::move(report)) {}

  /// Sets the folder for the journals of later recordings; empty for recordings in memory only.
  void set_journal_folder(const std::string& folder) { journal_folder_ = folder; }

  /// Begins a recording for `file`. Does nothing while a recording is being made. Never throws: a recording without a
  /// journal gets a warning instead.
  void begin(const RecordCommand& command, const Simulator* simulator);
  /// Adds the latest step to the recording, if there is one. Ends the recording at kMaxRecordedBytes, and if the error
  /// bars of the step cannot be measured.
  void follow(const StepView& view, const Simulator& simulator);
  /// Forgets all recorded steps after `step`, from which the simulation continues.
  void go_back_to(std::uint64_t step);
  /// Ends and writes the recording, if there is one. `reason` is empty, or completes "it ended because".
  void end(const std::string& reason, const Simulator* simulator);
  /// Writes the recording that could not be written, if there is one, to another file.
  void write_again(const std::string& file, const Simulator* simulator);
  /// Writes recorded steps of the history. Never throws: fill_frame() reports an error.
  void export_history(const ExportHistoryCommand& command, const StepHistory& history, const Simulator* simulator);

  /// Returns the state of the recording that is being made.
  [[nodiscard]] RecordingState state() const { return recording_ ? recording_->state() : RecordingState{}; }

 private:
  void begin_journal();
  void warn(const std::string& failure);
  void write(EndedRecording ended, const std::string& file, const Simulator* simulator);

  std::optional<LiveRecording> recording_;   // recording that is being made
  std::optional<EndedRecording> unwritten_;  // ended recording that could not be written
  std::function<void(SimReport)> report_;
  std::string journal_folder_;
  int journals_ = 0;  // number of journals begun
};

}  // namespace taxel
