#include "app/studio/nouns/select/select.h"

#include <imgui.h>

#include <algorithm>

#include "app/studio/frame/app.h"
#include "app/studio/nouns/camera/camera_state.h"
#include "app/studio/nouns/perturb/perturb_state.h"
#include "app/studio/nouns/scene/controls_state.h"
#include "app/studio/nouns/taxel/taxel_commands.h"

namespace taxel::ui {
namespace {

/// Distance that the pointer moves between two corners of a lasso [pixels].
constexpr double kLassoStep = 2;

template <class Inside>
void select_where(Viewer& viewer, const Shown& shown, const Inside& inside) {
  const ImGuiIO& io = ImGui::GetIO();
  const Layout* layout = shown.layout(viewer);
  if (layout == nullptr) return;
  if (!io.KeyShift && !io.KeyCtrl) viewer.selection.clear();
  const GestureView view = gesture_view(viewer, shown);
  const std::vector<int>& hidden = shown.document.editing.project->hidden;
  for (const Taxel& taxel : layout->taxels) {
    const bool seen = viewer.overlays().sensor_transparent || view.faces_eye(taxel);
    if (!seen || !inside(view.pixel_of(taxel.center))) continue;
    if (std::binary_search(hidden.begin(), hidden.end(), taxel.id)) continue;
    io.KeyCtrl ? viewer.selection.remove(taxel.id) : viewer.selection.add(taxel.id);
  }
}

}  // namespace

bool in_polygon(const std::vector<dvec2>& corners, const dvec2& point) {
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const dvec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    if ((a.y > point.y) == (b.y > point.y)) continue;
    // The edge crosses the row of the point at `x`. Only crossings to the right of the point are counted.
    const double x = a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x);
    if (point.x < x) inside = !inside;
  }
  return inside;
}

bool draw_area(Viewer& viewer, const Shown& shown, ToolState& tool, const dvec2& at, bool hovered) {
  std::vector<dvec2>& area = tool.area;
  const bool lasso = tool.tool == Tool::lasso;
  if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) area = {at};
  if (area.empty()) return false;
  if (lasso && glm::distance(area.back(), at) >= kLassoStep) area.push_back(at);
  if (!ImGui::IsMouseReleased(ImGuiMouseButton_Left)) return false;
  if (lasso) {
    select_where(viewer, shown, [&](const dvec2& pixel) { return in_polygon(area, pixel); });
  } else {
    const dvec2 lo = glm::min(area.front(), at), hi = glm::max(area.front(), at);
    select_where(viewer, shown,
                 [&](const dvec2& p) { return p.x >= lo.x && p.y >= lo.y && p.x <= hi.x && p.y <= hi.y; });
  }
  return true;
}

namespace {

/// Removes hidden taxels from the selection.
void keep_shown(App& app) {
  if (app.viewer->mode != Mode::layout || !app.shown->document.editing.project) return;
  for (const int id : app.shown->document.editing.project->hidden) app.viewer->selection.remove(id);
}

}  // namespace

void carry_out(const SelectAll&, App& app) {
  app.viewer->selection.set_all(*app.shown->layout(*app.viewer));
  keep_shown(app);
}

void carry_out(const SelectNone&, App& app) {
  app.viewer->selection.clear();
}

void carry_out(const InvertSelection&, App& app) {
  app.viewer->selection.invert(*app.shown->layout(*app.viewer));
  keep_shown(app);
}

void carry_out(const SelectParentBody&, App& app) {
  select_parent(*app.ui, app.viewer->selection, app.shown->run, app.get<PerturbState>(), app.get<ControlsState>());
}

}  // namespace taxel::ui
