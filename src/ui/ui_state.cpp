#include "ui/ui_state.h"

#include <utility>

namespace taxel::ui {

void UiState::ask(Request request) {
  requests.push_back(std::move(request));
}

}  // namespace taxel::ui
