#include "app/studio/nouns/menus/window_commands.h"

#include <imgui_internal.h>

#include <algorithm>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_state.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/host/host.h"
#include "app/studio/nouns/menus/menus_state.h"
#include "app/studio/nouns/present/present.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "ui/widgets/ui.h"

namespace taxel::ui {

namespace {

constexpr float kScaleStep = 1.1f, kMinScale = 0.6f, kMaxScale = 2.5f;

void flip(bool& value) {
  value = !value;
}

/// Returns whether a feature has a panel next to the view, not a window over it.
bool is_a_panel(const Feature& feature) {
  return feature.dock != Dock::none || feature.label != nullptr;
}

bool leaves_out_panels(const App& app) {
  return app.get<WindowParts>().is_presenting || app.get<WindowParts>().has_few;
}

/// Lets the panel under the pointer fill the window, or the view if no panel is there; restores all panels if one fills
/// the window already.
void toggle_maximised(Arrangement& arrangement, Mode mode) {
  if (!arrangement.maximised.empty()) {
    arrangement.maximised.clear();
    return;
  }
  arrangement.maximised = kViewTitle;
  const ImGuiContext* context = ImGui::GetCurrentContext();
  const ImGuiWindow* hovered = context != nullptr ? context->HoveredWindow : nullptr;
  if (hovered == nullptr) return;
  for (const Feature* row : features()) {
    const Dock dock = dock_in(mode, *row);
    if (dock == Dock::floating || dock == Dock::none) continue;
    if (ImGui::FindWindowByName(row->title) == hovered->RootWindow) arrangement.maximised = row->title;
  }
}

}  // namespace

void carry_out(const Escape&, App& app) {
  cancel_innermost(app);
}

void carry_out(const EnterPanel& command, App& app) {
  if (leaves_out_panels(app)) show_all_parts(app);
  enter_panel(*app.ui, command.title);
}

void carry_out(const OpenPalette&, App& app) {
  app.get<PaletteState>() = {};
  app.get<PaletteState>().open = app.get<PaletteState>().wants_focus = true;
}

void carry_out(const TogglePanel& command, App& app) {
  bool& open = app.get<PanelsShown>()[*command.panel];
  const bool was_left_out = is_a_panel(*command.panel) && is_left_out(*command.panel, app);
  open = was_left_out || !open;
  open ? app.ui->open_in_front(open) : void(std::erase(app.ui->opened, &open));
  if (is_a_panel(*command.panel) || !leaves_out_panels(app)) show_all_parts(app);
}

void carry_out(const ToggleTheme&, App& app) {
  flip(app.get<Appearance>().dark);
}

void carry_out(const ToggleFullScreen&, App& app) {
  flip(app.get<WindowState>().full_screen);
}

void carry_out(const ScaleInterface& command, App& app) {
  float& scale = app.get<Appearance>().scale;
  if (command.steps > 0) scale = std::min(kMaxScale, scale * kScaleStep);
  if (command.steps < 0) scale = std::max(kMinScale, scale / kScaleStep);
  if (command.steps == 0) scale = 1;
}

void carry_out(const ResetArrangement&, App& app) {
  for (const bool analyse : {false, true})
    for (const Feature* row : features())
      app.get<PanelsShown>().in(analyse, *row) = PanelsShown::is_open_first(analyse, *row);
  show_all_parts(app);
  app.get<Arrangement>().kept = {};
  app.get<Arrangement>().reset = true;
}

void carry_out(const MaximisePanel&, App& app) {
  if (leaves_out_panels(app)) return show_all_parts(app);
  toggle_maximised(app.get<Arrangement>(), app.viewer->mode);
}

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::ShowPart& command, Host& host) {
  ui::App& app = host.app;
  const ui::Feature& panel = *command.panel;
  const ui::PanelPart& part = command.part;
  if (panel.opens != ui::Opens::never) app.ui->open_in_front(app.get<ui::PanelsShown>()[panel]);
  show_all_parts(app);
  if (part.prepare) part.prepare(app);
  app.ui->widgets.seek({panel.title, part.section, part.widget.empty() ? part.label : part.widget, part.instead});
}

void carry_out(const ui::ShowAnswer& command, Host& host) {
  ui::App& app = host.app;
  carry_out(ui::SetMode{ui::Mode::analyse}, host);
  if (app.viewer->mode != ui::Mode::analyse) return;  // nothing can be simulated: a message says why
  app.ui->open_in_front(app.get<ui::PanelsShown>()[*command.panel]);
  if (command.panel->analyse.answer != nullptr) command.panel->analyse.answer(app);
}

void carry_out(const ui::TakeScreenshot&, Host& host) {
  host.app.get<ui::WindowState>().saves_screenshot = true;
}

void carry_out(const ui::Quit&, Host& host) {
  host.app.get<ui::WindowState>().quits = true;
}

}  // namespace taxel::studio
