// Recordings of the simulation's thread: every step between two commands, and the steps of the history.
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/sim/host/sim_thread_impl.h"
#include "core/sim/host/write_recording.h"

namespace taxel {
namespace {

/// Throws Error if the scene has no sensor, or a sensor with preview samples.
void expect_polished(const SimScene& scene, const std::string& file) {
  if (scene.sensors.empty()) throw Error(file, "there is no sensor to record");
  for (const SensorModelPtr& sensor : scene.sensors)
    if (sensor->quality == SampleQuality::preview)
      throw Error(file, "is not recorded: the samples are a preview's, which are still to be polished");
}

}  // namespace

/// Executes a command about recordings. Returns false for other commands.
bool SimThread::Impl::execute_on_recording(const SimCommand& command) {
  if (const auto* record = std::get_if<RecordCommand>(&command)) {
    begin_recording(record->file);
  } else if (std::holds_alternative<EndRecordingCommand>(command)) {
    end_recording("");
  } else if (const auto* again = std::get_if<WriteRecordingCommand>(&command)) {
    if (unwritten) write(std::move(*unwritten), again->file);
  } else if (const auto* past = std::get_if<ExportHistoryCommand>(&command)) {
    export_history(*past);
  } else {
    return false;
  }
  return true;
}

void SimThread::Impl::begin_recording(const std::string& file) {
  if (recording) return;
  try {
    if (simulator == nullptr) throw Error(file, "there is no simulation to record");
    expect_polished(*simulator->scene(), file);
    unwritten.reset();
    recording.emplace(simulator->scene(), file);
    begin_journal();
  } catch (const Error& refusal) {
    written = {written.number + 1, file, refusal.what(), 0, "", false};
  }
}

/// Begins the journal of the recording. If it cannot be written, the recording stays in memory, with a warning.
void SimThread::Impl::begin_journal() {
  journal_failure.clear();
  std::string folder;
  {
    const std::scoped_lock lock(mutex);
    folder = journal_folder;
  }
  if (folder.empty()) return;
  const std::string target = std::filesystem::absolute(recording->file()).string();
  const std::string name = fmt::format("{}-{}", ::getpid(), ++journals);
  try {
    make_folder(folder);
    recording->keep_in(std::make_unique<RecordingJournal>(std::filesystem::path(folder) / name, target));
  } catch (const Error& failure) {
    journal_failure = fmt::format("The recording is in memory only: {}", failure.what());
  }
}

void SimThread::Impl::end_recording(const std::string& why) {
  if (!recording) return;
  const std::string file = recording->file();
  EndedRecording ended = recording->end(why.empty() ? "" : "it ended because " + why);
  recording.reset();
  changed = true;
  write(std::move(ended), file);
}

void SimThread::Impl::record_step() {
  if (!recording) return;
  recording->follow(view, {simulator->mocap_quat(), simulator->mocap_pos()});
  if (const std::string why = recording->consume_failure(); !why.empty())
    journal_failure = fmt::format("The recording is in memory only: {}", why);
  if (recording->full()) end_recording(fmt::format("it takes {} MiB of memory", kMaxRecordedBytes >> 20U));
}

/// Writes a recording. If it cannot be written, the recording is retained in `unwritten`.
void SimThread::Impl::write(EndedRecording ended, const std::string& file) {
  written = {written.number + 1, file, "", ended.recording.rows.size(), ended.note, false};
  try {
    if (ended.recording.rows.empty()) throw Error(file, "is not written: no step was made while it was recorded");
    const bool of_this_scene = simulator != nullptr && simulator->scene() == ended.scene;
    write_recording(file, ended.recording, of_this_scene ? simulator.get() : nullptr);
    if (ended.journal) ended.journal->remove();
    unwritten.reset();
  } catch (const std::exception& e) {
    written.error = e.what();
    written.kept = !ended.recording.rows.empty();
    if (!written.kept && ended.journal) ended.journal->remove();
    if (written.kept) unwritten = std::move(ended);
  }
}

void SimThread::Impl::export_history(const ExportHistoryCommand& command) {
  written = {written.number + 1, command.file, "", 0, "", false};
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
    RunRecorder recorder(*scene);
    for (std::uint64_t number = range.first; number <= range.last; ++number) {
      history.fill_step(number, step);
      if (step.scene != scene) continue;
      recorder.follow(view_of(step), simulator->mocap_in(history.state(number)), true);
    }
    const Recording& made = recorder.recording();
    write_recording(command.file, made, scene == simulator->scene() ? simulator.get() : nullptr);
    written.rows = made.rows.size();
    if (const std::size_t others = range.last - range.first + 1 - made.rows.size(); others > 0)
      written.note = fmt::format("{} earlier steps were read by another layout and are left out", others);
  } catch (const std::exception& e) {
    written.error = e.what();
  }
}

}  // namespace taxel
