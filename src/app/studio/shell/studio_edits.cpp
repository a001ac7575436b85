// Edits, undo and the clipboard, as panels, tools and keys ask for them.
#include "app/studio/app/actions.h"
#include "app/studio/shell/studio.h"
#include "core/layout/file/taxel_clipboard.h"

namespace taxel::studio {

/// What an edit refuses is told, and nothing has changed then: by the field or the gesture that asked, or as a message.
void Studio::edit_document(const std::function<void(EditSession&)>& body, bool in_gesture,
                           const std::optional<ui::FieldInput>& from) {
  if (!session_.edits().is_open()) return;
  try {
    body(session_.edits());
    ui_.tool.problem.clear();
    ui_.fields.refused.reset();
  } catch (const Error& error) {
    if (from) {
      ui_.fields.refused = {*from, error.what(), ui_.selection.taxels};
    } else if (in_gesture) {
      ui_.tool.problem = error.what();
    } else {
      ui::add_message(ui_, Severity::error, error.what(), ImGui::GetTime());
    }
    return;
  }
  session_.after_edit(ui_.mode == ui::Mode::simulate);
  ui_.selection.keep_only(session_.edits().project()->layout);
}

bool Studio::carry_out_edit(const ui::Request& request) {
  if (const auto* edit = std::get_if<ui::EditProject>(&request)) {
    edit_document([&](EditSession& edits) { edits.edit(edit->edit, edit->gesture); }, edit->gesture.number != 0,
                  edit->from);
  } else if (const auto* unit = std::get_if<ui::SetMeshUnit>(&request)) {
    set_mesh_unit(unit->metres);
  } else if (const auto* cancelled = std::get_if<ui::CancelGesture>(&request)) {
    edit_document([&](EditSession& edits) { edits.cancel(cancelled->number); });
  } else if (std::holds_alternative<ui::EndGesture>(request)) {
    session_.edits().end_gesture();
  } else if (std::holds_alternative<ui::UndoStep>(request)) {
    edit_document([](EditSession& edits) { edits.undo(); });
  } else if (std::holds_alternative<ui::RedoStep>(request)) {
    edit_document([](EditSession& edits) { edits.redo(); });
  } else if (std::holds_alternative<ui::CopyTaxels>(request)) {
    copy_taxels();
  } else if (std::holds_alternative<ui::PasteTaxels>(request)) {
    paste_taxels();
  } else {
    return false;
  }
  return true;
}

void Studio::copy_taxels() {
  if (!session_.edits().is_open()) return;
  const Layout& layout = session_.edits().project()->layout;
  std::vector<Taxel> taxels;
  for (const int index : ui::selected_indices(ui_.selection, layout))
    taxels.push_back(layout.taxels[static_cast<std::size_t>(index)]);
  if (!taxels.empty()) window_->set_clipboard(taxels_to_json(taxels));
}

void Studio::paste_taxels() {
  edit_document([&](EditSession& edits) {
    const std::vector<Taxel> taxels = with_unused_ids(parse_taxels(window_->clipboard()), edits.project()->layout);
    edits.edit(AddTaxels{taxels, std::nullopt});
    ui_.selection.clear();
    for (const Taxel& taxel : taxels) ui_.selection.add(taxel.id);
  });
}

}  // namespace taxel::studio
