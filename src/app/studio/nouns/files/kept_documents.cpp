#include "app/studio/nouns/files/kept_documents.h"

#include <fmt/format.h>
#include <imgui.h>

#include <filesystem>
#include <utility>

#include "app/studio/frame/message_list.h"
#include "app/studio/host/host.h"
#include "app/studio/nouns/files/files_state.h"
#include "core/base/error.h"
#include "core/base/text/shown_message.h"

namespace taxel::studio {

void offer_recording(Host& host) {
  if (host.files.recordings.empty()) return;
  const LeftRecording& left = host.files.recordings.front();
  host.app.get<ui::FilesState>().recovery.name =
      fmt::format("A recording of {} steps was not written when the program ended.", left.recording.rows.size());
  host.app.get<ui::FilesState>().recovery.detail =
      fmt::format("{:.6g} s to {:.6g} s, to be written as {}", left.recording.rows.front().time,
                  left.recording.rows.back().time, left.target);
}

void offer_recovery(Host& host) {
  host.app.get<ui::FilesState>().recovery.name.clear();
  if (host.files.lost.empty()) return offer_recording(host);
  const LostDocument& lost = host.files.lost.front();
  host.app.get<ui::FilesState>().recovery.name = lost.name + " was edited and not saved when the program ended.";
  host.app.get<ui::FilesState>().recovery.detail =
      fmt::format("Kept {}{}{}", lost.when, lost.origin.empty() ? "" : ", opened from ", lost.origin);
}

/// Writes or discards a recording that was left behind. If that fails, the recording is offered again at the next
/// start.
void answer_left_recording(Host& host, bool recover) {
  if (host.files.recordings.empty()) return;
  const LeftRecording left = std::move(host.files.recordings.front());
  host.files.recordings.erase(host.files.recordings.begin());
  try {
    if (recover) {
      const std::string file = write_left_recording(left).string();
      ui::add_message(host.app.get<ui::Messages>(), Severity::note,
                      fmt::format("Recorded {} steps in {}, without the scene", left.recording.rows.size(), file),
                      ImGui::GetTime());
    } else {
      discard_left_recording(left);
    }
  } catch (const Error& error) {
    ui::add_message(host.app.get<ui::Messages>(), Severity::error,
                    fmt::format("{} (offered again at the next start)", shown_message(error)), ImGui::GetTime());
  }
}

void start_autosave(Host& host) {
  const std::filesystem::path& folder = host.files.kept_in;
  try {
    host.files.autosave.start(folder / "autosave");
    host.files.lost = host.files.autosave.lost();
    host.files.recordings = left_recordings(folder / "recordings");
    host.run.set_journal_folder((folder / "recordings").string());
  } catch (const Error& error) {
    ui::add_message(host.app.get<ui::Messages>(), Severity::warning, shown_message(error), 0);
  }
  offer_recovery(host);
}

void keep_unsaved(Host& host) {
  if (!host.files.autosave.started()) return;
  const bool dirty = host.edits().dirty();
  const std::string failure =
      host.files.autosave.update(dirty ? host.edits().project() : nullptr, dirty ? host.edits().revision() : 0,
                                 host.app.shown->document.name, host.document.file(), steady_seconds());
  if (!failure.empty())
    ui::add_message(host.app.get<ui::Messages>(), Severity::warning, "Edits are not kept: " + failure, ImGui::GetTime(),
                    ui::Holds::while_unkept);
}

void keep_unsaved_at_end(Host& host) {
  const bool dirty = host.edits().dirty();
  host.files.autosave.leave(dirty ? host.edits().project() : nullptr, host.app.shown->document.name,
                            host.document.file());
}

void carry_out(const ui::AnswerRecovery& command, Host& host) {
  if (host.files.lost.empty()) {
    answer_left_recording(host, command.recover);
    return offer_recovery(host);
  }
  const LostDocument lost = host.files.lost.front();
  host.files.lost.erase(host.files.lost.begin());
  if (command.recover) {
    host.files.autosave.take_over(lost);
    host.document.recover(lost);
  } else {
    Autosave::forget(lost);
  }
  offer_recovery(host);
}

}  // namespace taxel::studio
