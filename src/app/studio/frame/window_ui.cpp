#include "app/studio/frame/window_ui.h"

#include <utility>

namespace taxel::ui {

void WindowUi::post(Command command) {
  commands.push_back(std::move(command));
}

void post_edit(WindowUi& ui, Edit edit) {
  ui.post(EditProject{std::move(edit), {}, ui.fields.last});
}

}  // namespace taxel::ui
