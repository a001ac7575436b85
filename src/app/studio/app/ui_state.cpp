#include "app/studio/app/ui_state.h"

#include <utility>

namespace taxel::ui {

void UiState::ask(Request request) {
  requests.push_back(std::move(request));
}

void ask_edit(UiState& ui, Edit edit) {
  ui.ask(EditProject{std::move(edit), {}, ui.fields.last});
}

}  // namespace taxel::ui
