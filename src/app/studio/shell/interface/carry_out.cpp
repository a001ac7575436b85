#include "app/studio/shell/interface/carry_out.h"

#include <imgui.h>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/menus/window_commands.h"
#include "app/studio/nouns/taxel/taxel_commands.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "app/studio/nouns/view/view_commands.h"

namespace taxel::ui {

namespace {

bool is_valid(Context context, const App& app, bool gesture) {
  switch (context) {
    case Context::gesture:
      return gesture;
    case Context::widget:
      return false;  // the widget handles its keys
    case Context::layout:
      return !gesture && app.viewer->mode == Mode::layout;
    case Context::simulate:
      return !gesture && shows_run(app.viewer->mode);
    case Context::everywhere:
      return !gesture;
  }
  return false;
}

/// Says why a command does nothing, if its row has a reason.
void report_disabled(const Binding& row, App& app) {
  if (const std::string why = why_disabled(row, app); !why.empty())
    add_message(app.get<Messages>(), Severity::note, why, ImGui::GetTime());
}

}  // namespace

bool is_enabled(const Binding& row, const App& app) {
  return row.enabled == nullptr || row.enabled(app);
}

bool is_checked(const Binding& row, const App& app) {
  if (row.checked != nullptr) return row.checked(app);
  if (const auto* toggle = row.command.get_if<ToggleOverlay>()) return app.viewer->overlays().*toggle->overlay;
  if (const auto* toggle = row.command.get_if<TogglePanel>()) {
    const bool is_left_out_panel = toggle->panel->label != nullptr && is_left_out(*toggle->panel, app);
    return app.get<PanelsShown>()[*toggle->panel] && !is_left_out_panel;
  }
  const auto* toggle = row.command.get_if<ToggleGroup>();
  return toggle != nullptr && (app.viewer->overlays().*toggle->groups).at(toggle->group);
}

std::string why_disabled(const Binding& row, const App& app) {
  if (is_enabled(row, app)) return {};
  if (row.why_disabled != nullptr) return row.why_disabled(app);
  return row.needs != nullptr ? row.needs : "";
}

void carry_out_if_enabled(const Binding& row, App& app) {
  if (!is_enabled(row, app)) return;
  row.command.is_about_interface() ? row.command.carry_out(app) : app.ui->post(row.command);
}

void carry_out_if_enabled(const Command& command, App& app) {
  carry_out_if_enabled(binding_of(command), app);
}

void handle_keys(App& app) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) return;
  if (app.ui->fields.had_keys || io.WantTextInput) return;
  // A gesture that runs when the loop begins takes all keys, also if it ends within the loop.
  const bool gesture = app.get<ToolState>().follows();
  if (gesture) type_number(app.get<ToolState>());
  for (const Binding& row : bindings()) {
    if (!is_valid(row.context, app, gesture)) continue;
    for (const int chord : {row.chord, row.also}) {
      // A running gesture uses Shift and Ctrl itself: they make it finer, and snap.
      if (chord != 0 && !widgets_take(*app.ui, chord) && (gesture || io.KeyMods == (chord & ImGuiMod_Mask_)) &&
          ImGui::IsKeyPressed(static_cast<ImGuiKey>(chord & ~ImGuiMod_Mask_), row.repeats)) {
        report_disabled(row, app);
        carry_out_if_enabled(row, app);
      }
    }
  }
}

}  // namespace taxel::ui
