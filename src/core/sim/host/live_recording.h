// Steps that are recorded while the simulation runs, however few of them the history holds.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "core/run/frame.h"
#include "core/run/recording/run_recorder.h"
#include "core/sim/host/recording_journal.h"

namespace taxel {

/// A recording ends where it takes so much memory; a fingertip of twelve taxels has filled it after a quarter of an
/// hour at 1 ms.
inline constexpr std::size_t kMostRecordedBytes = std::size_t{1} << 29;

/// Rows, and the scene that they are of.
struct EndedRecording {
  Recording recording;
  std::shared_ptr<const SimScene> scene;
  std::string note;                                     ///< what the user should know of it; may be empty
  std::unique_ptr<RecordingJournal> journal = nullptr;  ///< to be removed when the rows are written; may be null
};

class LiveRecording {
 public:
  LiveRecording(std::shared_ptr<const SimScene> scene, std::string file)
      : scene_(std::move(scene)), file_(std::move(file)), recorder_(*scene_) {}

  /// Keeps the rows on disk from now on.
  void keep_in(std::unique_ptr<RecordingJournal> journal) { journal_ = std::move(journal); }
  /// Returns why the journal could not be written, once; empty if it could. It is given up then.
  [[nodiscard]] std::string consume_failure() { return std::exchange(failure_, ""); }

  void follow(const StepView& view, const Pose& mocap);
  /// The simulation goes on from `step`: what was recorded after it has not been.
  void go_back_to(std::uint64_t step);
  [[nodiscard]] bool full() const { return recorder_.bytes() >= kMostRecordedBytes; }
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
  std::uint64_t first_step_ = 0;  ///< recorded, where it is not empty()
};

}  // namespace taxel
