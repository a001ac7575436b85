// Edits, undo and the clipboard.
#include "app/studio/frame/message_list.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "app/studio/shell/studio.h"
#include "core/base/text/shown_message.h"
#include "core/layout/file/taxel_clipboard.h"

namespace taxel::studio {

/// Shows why an edit is refused at the field or the gesture that requested it, or as a message. The document stays
/// then.
void Studio::edit_document(const std::function<void(EditSession&)>& body, bool in_gesture,
                           const std::optional<ui::FieldInput>& from) {
  if (!session_.edits().is_open()) return;
  try {
    body(session_.edits());
    app_.get<ui::ToolState>().problem.clear();
    app_.ui->fields.refused.reset();
    ui::end_messages(app_.get<ui::Messages>(), ui::Holds::until_edit);
  } catch (const Error& error) {
    if (from) {
      app_.ui->fields.refused = {*from, shown_message(error), app_.viewer->selection.taxels};
    } else if (in_gesture) {
      app_.get<ui::ToolState>().problem = shown_message(error);
    } else {
      ui::add_message(app_.get<ui::Messages>(), Severity::error, shown_message(error), ImGui::GetTime(),
                      ui::Holds::until_edit);
    }
    return;
  }
  session_.after_edit(app_.viewer->mode == ui::Mode::simulate);
  app_.viewer->selection.keep_only(session_.edits().project()->layout);
}

void Studio::carry_out(const ui::EditProject& command) {
  edit_document([&](EditSession& edits) { edits.edit(command.edit, command.gesture); }, command.gesture.number != 0,
                command.from);
}

void Studio::carry_out(const ui::CancelGesture& command) {
  edit_document([&](EditSession& edits) { edits.cancel(command.number); });
}

void Studio::carry_out(const ui::UndoStep&) {
  edit_document([](EditSession& edits) { edits.undo(); });
}

void Studio::carry_out(const ui::RedoStep&) {
  edit_document([](EditSession& edits) { edits.redo(); });
}

void Studio::carry_out(const ui::GoToEdit& command) {
  edit_document([&](EditSession& edits) { edits.go_to(command.revision); });
}

void Studio::carry_out(const ui::CopyTaxels&) {
  if (!session_.edits().is_open()) return;
  const Layout& layout = session_.edits().project()->layout;
  std::vector<Taxel> taxels;
  for (const int index : ui::selected_indices(app_.viewer->selection, layout))
    taxels.push_back(layout.taxels[static_cast<std::size_t>(index)]);
  if (!taxels.empty()) window_->set_clipboard(taxels_to_json(taxels));
}

void Studio::carry_out(const ui::PasteTaxels&) {
  edit_document([&](EditSession& edits) {
    const std::vector<Taxel> taxels = with_unused_ids(parse_taxels(window_->clipboard()), edits.project()->layout);
    edits.edit(AddTaxels{taxels, std::nullopt});
    app_.viewer->selection.clear();
    for (const Taxel& taxel : taxels) app_.viewer->selection.add(taxel.id);
  });
}

}  // namespace taxel::studio
