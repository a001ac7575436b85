#include "core/sim/host/sim_recordings.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/os/process.h"
#include "core/sim/compare/error_bars.h"
#include "core/sim/host/write_recording.h"

namespace taxel {

template <class Write>
void LiveRecording::keep(const Write& write) {
  if (!journal_) return;
  try {
    write(*journal_);
  } catch (const Error& error) {
    if (!std::exchange(has_failed_, true)) failure_ = error.what();
  }
}

void LiveRecording::follow(const StepView& view, const Pose& mocap) {
  if (empty()) first_step_ = view.step;
  recorder_.follow(view, mocap, true);
  keep([this](RecordingJournal& journal) { journal.follow(recorder_.recording()); });
}

void LiveRecording::go_back_to(std::uint64_t step) {
  recorder_.cut_after(step < first_step_ ? 0 : static_cast<std::size_t>(step - first_step_ + 1));
  keep([this](RecordingJournal& journal) { journal.cut_to(recorder_.recording()); });
}

RecordingState LiveRecording::state() const {
  const std::size_t steps = recorder_.recording().rows.size();
  return {true, steps, recorder_.bytes(), static_cast<double>(steps) * scene_->timestep};
}

namespace {

/// Throws Error if the scene has no sensor, or a sensor with preview samples.
void expect_polished(const SimScene& scene, const std::string& file) {
  if (scene.sensors.empty()) throw Error(file, "there is no sensor to record");
  for (const SensorModelPtr& sensor : scene.sensors)
    if (sensor->quality == SampleQuality::preview)
      throw Error(file, "is not recorded: the samples are a preview's, which are still to be polished");
}

/// Returns the source of error bars of a scene, or null if none are wanted or no sensor has error bars.
std::shared_ptr<ErrorBarSource> error_bars_of(const std::shared_ptr<const SimScene>& scene, bool wanted) {
  if (!wanted) return nullptr;
  auto bars = std::make_shared<ErrorBars>(scene);
  for (std::size_t s = 0; s < scene->sensors.size(); ++s)
    if (bars->missing(s).empty()) return bars;
  return nullptr;
}

}  // namespace

void SimRecordings::begin(const RecordCommand& command, const Simulator* simulator) {
  if (recording_) return;
  const std::string& file = command.file;
  try {
    if (simulator == nullptr) throw Error(file, "there is no simulation to record");
    expect_polished(*simulator->scene(), file);
    unwritten_.reset();
    recording_.emplace(simulator->scene(), file, error_bars_of(simulator->scene(), command.error_bars));
    begin_journal();
  } catch (const Error& refusal) {
    report_(RecordingWritten{file, refusal.what(), 0, ""});
  }
}

/// Begins the journal of the recording. If it cannot be written, the recording stays in memory, with a warning.
void SimRecordings::begin_journal() {
  if (journal_folder_.empty()) return;
  const std::string target = std::filesystem::absolute(recording_->file()).string();
  const std::string name = fmt::format("{}-{}", os::process_id(), ++journals_);
  try {
    make_folder(journal_folder_);
    recording_->keep_in(std::make_unique<RecordingJournal>(std::filesystem::path(journal_folder_) / name, target));
  } catch (const Error& failure) {
    warn(failure.what());
  }
}

void SimRecordings::warn(const std::string& failure) {
  report_(Warned{fmt::format("The recording is in memory only: {}", failure)});
}

void SimRecordings::follow(const StepView& view, const Simulator& simulator) {
  if (!recording_) return;
  try {
    recording_->follow(view, simulator.mocap_pose());
  } catch (const Error& error) {
    return end(fmt::format("the error bars cannot be measured: {}", error.message()), &simulator);
  }
  if (const std::string failure = recording_->consume_failure(); !failure.empty()) warn(failure);
  if (recording_->full()) end(fmt::format("it takes {} MiB of memory", kMaxRecordedBytes >> 20U), &simulator);
}

void SimRecordings::go_back_to(std::uint64_t step) {
  if (recording_) recording_->go_back_to(step);
}

void SimRecordings::end(const std::string& reason, const Simulator* simulator) {
  if (!recording_) return;
  const std::string file = recording_->file();
  EndedRecording ended = recording_->end(reason.empty() ? "" : "it ended because " + reason);
  recording_.reset();
  write(std::move(ended), file, simulator);
}

void SimRecordings::write_again(const std::string& file, const Simulator* simulator) {
  if (unwritten_) write(std::move(*unwritten_), file, simulator);
}

/// Writes a recording. If it cannot be written, the recording is retained in unwritten_.
void SimRecordings::write(EndedRecording ended, const std::string& file, const Simulator* simulator) {
  RecordingWritten written{file, "", ended.recording.rows.size(), ended.note};
  try {
    if (ended.recording.rows.empty()) throw Error(file, "is not written: no step was made while it was recorded");
    const bool of_this_scene = simulator != nullptr && simulator->scene() == ended.scene;
    write_recording(file, ended.recording, of_this_scene ? simulator : nullptr);
    if (ended.journal) ended.journal->remove();
    unwritten_.reset();
  } catch (const std::exception& e) {
    written.error = e.what();
    written.kept = !ended.recording.rows.empty();
    if (!written.kept && ended.journal) ended.journal->remove();
    if (written.kept) unwritten_ = std::move(ended);
  }
  report_(std::move(written));
}

void SimRecordings::export_history(const ExportHistoryCommand& command, const StepHistory& history,
                                   const Simulator* simulator) {
  RecordingWritten written{command.file, "", 0, ""};
  try {
    if (simulator == nullptr || history.empty()) throw Error(command.file, "is not written: nothing was simulated");
    const StepRange all{std::max<std::uint64_t>(history.first(), 1), history.last()};  // 0: before the first step
    const StepRange asked = command.steps.value_or(all);
    const StepRange range{std::max(asked.first, all.first), std::min(asked.last, all.last)};
    if (range.first > range.last) throw Error(command.file, "is not written: the history has no step there");
    Step step;
    history.fill_step(range.last, step);
    const std::shared_ptr<const SimScene> scene = step.scene;
    expect_polished(*scene, command.file);
    RunRecorder recorder(*scene, error_bars_of(scene, command.error_bars));
    for (std::uint64_t number = range.first; number <= range.last; ++number) {
      history.fill_step(number, step);
      if (step.scene != scene) continue;
      const std::vector<Pose> mocaps = simulator->controls_of(history.state(number)).mocaps;
      recorder.follow(view_of(step), mocaps.empty() ? Pose{} : mocaps.front(), true);
    }
    const Recording& made = recorder.recording();
    write_recording(command.file, made, scene == simulator->scene() ? simulator : nullptr);
    written.rows = made.rows.size();
    if (const std::size_t others = range.last - range.first + 1 - made.rows.size(); others > 0)
      written.note = fmt::format("{} earlier steps were read by another layout and are left out", others);
  } catch (const std::exception& e) {
    written.error = e.what();
  }
  report_(std::move(written));
}

}  // namespace taxel
