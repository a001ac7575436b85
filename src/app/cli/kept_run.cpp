#include "app/cli/kept_run.h"

#include <fmt/format.h>

#include <filesystem>

#include "core/base/error.h"

namespace taxel::cli {

KeptRun::KeptRun(const std::string& out, Console& console) : console_(console) {
  if (out.empty()) return;
  const std::filesystem::path base = std::filesystem::path(out) / "unfinished";
  try {
    if (const std::optional<LeftRecording> left = read_recording_journal(base)) {
      const std::string written = write_left_recording(*left).string();
      console.warn(fmt::format("{}: an earlier run was killed: its {} rows are in {}", out, left->recording.rows.size(),
                               written));
    }
    journal_ = std::make_unique<RecordingJournal>(base, std::filesystem::absolute(out).lexically_normal().string());
  } catch (const Error& error) {
    console.warn(fmt::format("rows are in memory only until the run ends: {}", error.what()));
  }
}

KeptRun::~KeptRun() {
  if (journal_) journal_->remove();
}

void KeptRun::follow(const Recording& recording) {
  if (!journal_) return;
  try {
    journal_->follow(recording);
  } catch (const Error& error) {
    console_.warn(fmt::format("rows are in memory only until the run ends: {}", error.what()));
    journal_->remove();
    journal_.reset();
  }
}

}  // namespace taxel::cli
