#include "app/studio/frame/window_ui.h"

#include <utility>

namespace taxel::ui {

void WindowUi::post(Command command) {
  commands.push_back(std::move(command));
}

}  // namespace taxel::ui
