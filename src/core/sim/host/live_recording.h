// A recording of all steps while the simulation runs, whatever the limits of the history are.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "core/run/frame.h"
#include "core/run/recording/run_recorder.h"
#include "core/sim/host/recording_journal.h"

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

/// A recording that is being made.
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

}  // namespace taxel
