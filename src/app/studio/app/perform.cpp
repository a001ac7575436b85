#include "app/studio/app/perform.h"

#include <imgui.h>

#include "app/studio/app/carry_out.h"

namespace taxel::ui {

namespace {

bool is_valid(Context context, const UiState& ui, bool gesture) {
  switch (context) {
    case Context::gesture:
      return gesture;
    case Context::widget:
      return false;  // the widget handles its keys
    case Context::layout:
      return !gesture && ui.mode == Mode::layout;
    case Context::simulate:
      return !gesture && ui.mode == Mode::simulate;
    case Context::everywhere:
      return !gesture;
  }
  return false;
}

}  // namespace

bool is_enabled(const Binding& row, const UiState& ui, const UiInput& input) {
  return row.enabled == nullptr || row.enabled(ui, input);
}

bool is_checked(const Binding& row, const UiState& ui, const UiInput& input) {
  if (row.checked != nullptr) return row.checked(ui, input);
  if (const auto* toggle = std::get_if<ToggleOverlay>(&row.command)) return ui.saved.overlays.*toggle->overlay;
  if (const auto* toggle = std::get_if<TogglePanel>(&row.command)) return ui.saved.panels.*toggle->panel;
  const auto* toggle = std::get_if<ToggleGroup>(&row.command);
  return toggle != nullptr && (ui.saved.overlays.*toggle->groups).at(toggle->group);
}

void perform(const Binding& row, UiState& ui, const UiInput& input) {
  if (!is_enabled(row, ui, input)) return;
  std::visit(
      [&](const auto& command) {
        if constexpr (InterfaceCommand<decltype(command)>)
          CarryOut{ui, input}(command);
        else
          ui.ask(command);
      },
      row.command);
}

void handle_keys(UiState& ui, const UiInput& input) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) return;
  if (ui.fields.had_keys || io.WantTextInput) return;
  // A gesture that runs when the loop begins takes all keys, also if it ends within the loop.
  const bool gesture = ui.tool.follows();
  if (gesture) type_number(ui);
  for (const Binding& row : bindings()) {
    if (!is_valid(row.context, ui, gesture)) continue;
    for (const int chord : {row.chord, row.also}) {
      // A running gesture uses Shift and Ctrl itself: they make it finer, and snap.
      if (chord != 0 && !widgets_take(ui, chord) && (gesture || io.KeyMods == (chord & ImGuiMod_Mask_)) &&
          ImGui::IsKeyPressed(static_cast<ImGuiKey>(chord & ~ImGuiMod_Mask_), row.repeats)) {
        perform(row, ui, input);
      }
    }
  }
}

}  // namespace taxel::ui
