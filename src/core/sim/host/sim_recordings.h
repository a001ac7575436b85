// The recordings of a simulation: every step between two commands, and the recorded steps of its history.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/run/command.h"
#include "core/run/event.h"
#include "core/run/frame.h"
#include "core/run/history/step_history.h"
#include "core/run/recording/run_recorder.h"
#include "core/sim/host/recording_journal.h"
#include "core/sim/simulator.h"

namespace taxel {

/// Memory at which a recording ends [bytes]. A fingertip with twelve taxels reaches it after 15 minutes of steps of 1
/// ms.
inline constexpr std::size_t kMaxRecordedBytes = std::size_t{1} << 29;

/// The rows of a recording with their scene.
struct EndedRecording {
  Recording recording;
  std::shared_ptr<const SimScene> scene;
  std::string note;                                     ///< a remark for the user; may be empty
  std::unique_ptr<RecordingJournal> journal = nullptr;  ///< journal to remove when the rows are written; may be null
};

/// A recording that is being made, of all steps, whatever the limits of the history are.
class LiveRecording {
 public:
  /// `errors`, which may be null, measures the error bars of each row.
  LiveRecording(std::shared_ptr<const SimScene> scene, std::string file, std::shared_ptr<ErrorBarSource> errors)
      : scene_(std::move(scene)), file_(std::move(file)), recorder_(*scene_, std::move(errors)) {}

  /// Writes the rows to disk from now on.
  void keep_in(std::unique_ptr<RecordingJournal> journal) { journal_ = std::move(journal); }
  /// Returns once why the journal could not be written, or an empty text. Its rows so far stay on the disk, and each
  /// further step tries to write those that are missing.
  [[nodiscard]] std::string consume_failure() { return std::exchange(failure_, ""); }

  /// Adds a row. Throws Error if its error bars cannot be measured: then no row is added.
  void follow(const StepView& view, const Pose& mocap);
  /// Forgets all steps after `step`, from which the simulation continues.
  void go_back_to(std::uint64_t step);
  [[nodiscard]] bool full() const { return recorder_.bytes() >= kMaxRecordedBytes; }
  [[nodiscard]] bool empty() const { return recorder_.recording().rows.empty(); }
  [[nodiscard]] RecordingState state() const;
  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] EndedRecording end(const std::string& why) {
    return {recorder_.take(), scene_, why, std::move(journal_)};
  }

 private:
  template <class Write>
  void keep(const Write& write);

  std::shared_ptr<const SimScene> scene_;
  std::string file_;
  RunRecorder recorder_;
  std::unique_ptr<RecordingJournal> journal_;
  std::string failure_;
  bool has_failed_ = false;
  std::uint64_t first_step_ = 0;  // number of the first recorded step, if there is one
};

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
