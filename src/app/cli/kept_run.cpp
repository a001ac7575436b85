#include "app/cli/kept_run.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "app/cli/signals.h"

namespace taxel::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBase = "unfinished";

}  // namespace

KeptRun::KeptRun(const std::string& out, Console& console) : out_(out), console_(console) {
  if (out.empty()) return;
  const fs::path base = fs::path(out) / kBase;
  const std::string target = fs::absolute(out).lexically_normal().string();
  try {
    if (std::optional<LeftRecording> left = read_recording_journal(base)) {
      left->target = target;  // the journal may come from elsewhere and name any path
      const std::string written = write_left_recording(*left).string();
      console.warn(fmt::format("{}: an earlier run was killed: its {} rows are in {}", out, left->recording.rows.size(),
                               written));
    }
    journal_ = std::make_unique<RecordingJournal>(base, target);
  } catch (const Error& error) {
    console.warn(fmt::format("rows are in memory only until the run ends: {}", error.what()));
  }
}

KeptRun::~KeptRun() {
  if (journal_ && journal_->rows() == 0) remove_journal();
}

void KeptRun::follow(const Recording& recording) {
  if (!journal_) return;
  const bool is_first = journal_->rows() == 0;
  try {
    journal_->follow(recording);
  } catch (const Error& error) {
    if (!std::exchange(has_warned_, true))
      console_.warn(fmt::format("{}: rows after the first {} are in memory only until they can be written",
                                error.what(), journal_->rows()));
  }
  if (is_first && journal_->rows() > 0) set_last_words("the rows so far are in " + remedy());
}

std::vector<std::string> KeptRun::commit(std::optional<OutputFolder>& folder, const Recording& recording,
                                         const std::function<void(OutputFolder&)>& put) {
  if (!folder) return {};
  try {
    put(*folder);
    std::vector<std::string> files = folder->commit();
    if (journal_) remove_journal();
    return files;
  } catch (const Error&) {
    folder->discard();
    follow(recording);
    throw;
  }
}

void KeptRun::remove_journal() {
  set_last_words("");
  journal_->remove();
  journal_.reset();
}

std::string KeptRun::remedy() const {
  const std::string rows = (fs::path(out_) / kBase).string() + ".rows";
  return fmt::format("{0}: `taxel convert {0} FOLDER` writes them as files, and so does the next run with --out {1}",
                     rows, out_);
}

Error KeptRun::explained(const Error& error) const {
  if (!journal_ || journal_->rows() == 0) return error;
  return {error.file(), error.where(),
          fmt::format("{}; the {} rows so far are in {}", error.message(), journal_->rows(), remedy())};
}

}  // namespace taxel::cli
