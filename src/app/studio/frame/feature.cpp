#include "app/studio/frame/feature.h"

#include <algorithm>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"

namespace taxel::ui {

bool is_left_out(const Feature& feature, const App& app) {
  const WindowParts& parts = app.get<WindowParts>();
  if (parts.is_presenting) return true;
  const bool has_readings = feature.dock == Dock::bottom && feature.in_front;
  return parts.has_few && feature.dock != Dock::floating && !has_readings;
}

bool is_drawn(const Feature& feature, const App& app) {
  if (feature.draw == nullptr || is_left_out(feature, app)) return false;
  const bool layout = app.viewer->mode == Mode::layout;
  if (feature.opens != Opens::never && !app.get<PanelsShown>()[feature]) return false;
  if (feature.context == Context::simulate && layout) return false;
  if (!feature.of_readings || !layout || app.shown->state(*app.viewer) != nullptr) return true;
  const auto gives = [&](const Feature* row) { return row->gives_readings != nullptr && row->gives_readings(app); };
  return std::any_of(features().begin(), features().end(), gives);
}

void enter_mode(App& app, Mode mode) {
  app.viewer->mode = mode;
  app.get<PanelsShown>().enter(mode);
}

bool is_in_use(const Feature& feature, const App& app) {
  if (!app.get<PanelsShown>()[feature]) return false;
  return app.viewer->mode != Mode::analyse || app.ui->widgets.shows_panel(feature.title);
}

Dock dock_in(Mode mode, const Feature& feature) {
  if (mode != Mode::analyse || feature.dock == Dock::none) return feature.dock;
  if (feature.analyse.is_plot) return Dock::plot;
  return feature.dock == Dock::floating && feature.analyse.tab == 0 ? Dock::floating : Dock::inspector;
}

void cancel_innermost(App& app) {
  const ToolSpec* first = nullptr;
  for (const Feature* row : features()) {
    const ToolSpec& tool = row->tool;
    if (tool.cancel == nullptr || !tool.active(app)) continue;
    if (first == nullptr || tool.cancel_order < first->cancel_order) first = &tool;
  }
  if (first != nullptr) first->cancel(app);
}

}  // namespace taxel::ui
