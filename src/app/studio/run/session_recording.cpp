// What the simulation records, and where it goes.
#include <fmt/format.h>

#include <filesystem>

#include "app/studio/run/session.h"

namespace taxel::studio {

void Session::record(bool on, const std::string& file) {
  if (!runs_or_refuses()) return;
  on ? tell(RecordCommand{file}) : tell(EndRecordingCommand{});
}

void Session::write_recording(const std::string& file) {
  tell(WriteRecordingCommand{file});
}

void Session::export_recording(const std::string& file) {
  if (runs_or_refuses()) tell(ExportHistoryCommand{file, loop_});
}

void Session::tell_written(const RecordingWritten& written, SessionNews& news) {
  const std::string note = written.note.empty() ? "" : ": " + written.note;
  if (written.error.empty()) {
    const std::string where = std::filesystem::absolute(written.file).string();
    news.messages.emplace_back(note.empty() ? Severity::note : Severity::warning,
                               fmt::format("Recorded {} steps in {}{}", written.rows, where, note));
  } else {
    news.messages.emplace_back(Severity::error, written.error + note);
    if (written.kept) news.unwritten = written.error;
  }
}

}  // namespace taxel::studio
