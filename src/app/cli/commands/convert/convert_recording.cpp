#include "app/cli/commands/convert/convert_recording.h"

#include <fmt/format.h>

#include <filesystem>
#include <vector>

#include "app/cli/report_writer.h"
#include "app/version/version.h"
#include "core/base/files.h"
#include "core/run/mcap/run_notes.h"
#include "core/run/recording/npz.h"
#include "core/run/recording/tactile_state.h"
#include "core/sim/host/recording_journal.h"
#include "core/sim/host/write_recording.h"

namespace taxel::cli {
namespace {

namespace fs = std::filesystem;

struct RecordingReport {
  std::string in, out, format;
  const Recording& recording;
  std::vector<std::string> notes;

  void visit(ReportWriter& w) const {
    w("input", in);
    w("file", out);
    w("format", format);
    w("rows", recording.rows.size());
    w.list("sensors", recording.sensors, [](ReportWriter& one, const RecordedSensor& sensor) {
      one("geom", sensor.geom);
      one("taxels", sensor.taxel_ids.size());
      one("unit", sensor.reading_unit);
    });
    w("notes", notes);
  }
  [[nodiscard]] std::string text() const {
    std::size_t taxels = 0;
    for (const RecordedSensor& sensor : recording.sensors) taxels += sensor.taxel_ids.size();
    std::string text = fmt::format("{}: {} rows of {} taxel{} ({})\n", out, recording.rows.size(), taxels,
                                   taxels == 1 ? "" : "s", format);
    for (const std::string& note : notes) text += "note: " + note + "\n";
    return text;
  }
};

/// Returns the archive of a run. Throws Error if the input is no run.
fs::path archive_of_run(const std::string& in) {
  const fs::path file = recording_file(in);
  std::error_code ignored;
  if (fs::is_directory(in, ignored) && !fs::exists(file, ignored))
    throw Error(in, "is no recorded run: it has no readings.npz");
  if (!fs::is_directory(in, ignored) && read_start(file, 2) != "PK" && fs::exists(file, ignored))
    throw Error(in, "is no recorded run: name the folder of a run, or its readings.npz");
  return file;
}

}  // namespace

bool is_recording_output(const std::string& out) {
  return out.ends_with(".mcap") || out.ends_with(".jsonl");
}

bool is_unfinished_run(const std::string& in) {
  return in.ends_with(".rows");
}

void convert_unfinished_run(const std::string& in, const std::string& out, Console& console) {
  std::error_code ignored;
  if (!fs::exists(in, ignored)) throw Error(in, "no such file");
  const std::optional<LeftRecording> left = read_recording_journal(fs::path(in).replace_extension());
  if (!left) throw Error(in, "holds no complete row of a run that has ended");
  write_recording(out, left->recording, nullptr);
  print_report(console, RecordingReport{in, out, "readings", left->recording, {}});
}

void convert_recording(const std::string& in, const std::string& out, Console& console) {
  const fs::path file = archive_of_run(in);
  const Recording recording = read_recording(file);
  RecordingReport report{in, out, "", recording, {}};
  if (out.ends_with(".mcap")) {
    report.format = "MCAP of ROS 2 messages";
    RunNotes notes = file.filename() == "readings.npz" ? read_run_notes(file.parent_path()) : RunNotes{};
    if (notes.file_name.empty()) {
      notes.program = "taxel " + versions().taxel;
      report.notes.emplace_back(
          "no sweep.json or scenario.json is next to the recording: the file has the version of "
          "this program, and no scenario");
    }
    write_mcap(out, recording, notes);
  } else {
    report.format = "messages of tactile_msgs/TactileState";
    write_file_atomically(out, tactile_states(recording));
  }
  print_report(console, report);
}

}  // namespace taxel::cli
