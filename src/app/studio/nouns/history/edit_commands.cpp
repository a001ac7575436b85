#include "app/studio/nouns/history/edit_commands.h"

#include <imgui.h>

#include <utility>

#include "app/studio/frame/message_list.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/host/host.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "core/base/error.h"
#include "core/base/text/shown_message.h"

namespace taxel::ui {

void post_edit(WindowUi& ui, Edit edit) {
  ui.post(EditProject{std::move(edit), {}, ui.fields.last});
}

}  // namespace taxel::ui

namespace taxel::studio {

/// Shows why an edit is refused at the field or the gesture that requested it, or as a message. The document stays
/// then.
void edit_document(Host& host, const std::function<void(EditSession&)>& body, bool in_gesture,
                   const std::optional<ui::FieldInput>& from) {
  if (!host.edits().is_open()) return;
  try {
    body(host.edits());
    host.app.get<ui::ToolState>().problem.clear();
    host.app.ui->fields.refused.reset();
    ui::end_messages(host.app.get<ui::Messages>(), ui::Holds::until_edit);
  } catch (const Error& error) {
    if (from) {
      host.app.ui->fields.refused = {*from, shown_message(error), host.app.viewer->selection.taxels};
    } else if (in_gesture) {
      host.app.get<ui::ToolState>().problem = shown_message(error);
    } else {
      ui::add_message(host.app.get<ui::Messages>(), Severity::error, shown_message(error), ImGui::GetTime(),
                      ui::Holds::until_edit);
    }
    return;
  }
  after_edit(host);
  host.app.viewer->selection.keep_only(host.edits().project()->layout);
}

void carry_out(const ui::EditProject& command, Host& host) {
  edit_document(
      host, [&](EditSession& edits) { edits.edit(command.edit, command.gesture); }, command.gesture.number != 0,
      command.from);
}

void carry_out(const ui::CancelGesture& command, Host& host) {
  edit_document(host, [&](EditSession& edits) { edits.cancel(command.number); });
}

void carry_out(const ui::EndGesture&, Host& host) {
  host.edits().end_gesture();
}

void carry_out(const ui::UndoStep&, Host& host) {
  edit_document(host, [](EditSession& edits) { edits.undo(); });
}

void carry_out(const ui::RedoStep&, Host& host) {
  edit_document(host, [](EditSession& edits) { edits.redo(); });
}

void carry_out(const ui::GoToEdit& command, Host& host) {
  edit_document(host, [&](EditSession& edits) { edits.go_to(command.revision); });
}

}  // namespace taxel::studio
