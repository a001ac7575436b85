#include "app/studio/app/ui_state.h"

#include <utility>

namespace taxel::ui {

void UiState::ask(Command command) {
  commands.push_back(std::move(command));
}

bool can_edit(const UiState& ui, const UiInput& input) {
  return ui.mode == Mode::layout && input.editing.project && input.model;
}

void ask_edit(UiState& ui, Edit edit) {
  ui.ask(EditProject{std::move(edit), {}, ui.fields.last});
}

void click_taxel(UiState& ui, int id, bool shift) {
  shift ? ui.selection.toggle(id) : ui.selection.set(id);
}

void begin_dialog(UiState& ui, FileTask task) {
  ui.dialog.task = task;
  ui.dialog.open = ui.dialog.wants_focus = true;
  ui.dialog.path.clear();
  ui.dialog.filter.clear();
  ui.dialog.exists.clear();
}

void open_dialog(UiState& ui) {
  begin_dialog(ui, FileTask::open);
  ui.ask(ListFolder{ui.dialog.folder});
}

void add_message(UiState& ui, Severity severity, std::string text, double now) {
  Message message;
  message.severity = severity;
  message.text = std::move(text);
  message.number = ui.messages.empty() ? 1 : ui.messages.back().number + 1;
  message.shown_at = now;
  ui.messages.push_back(std::move(message));
}

}  // namespace taxel::ui
