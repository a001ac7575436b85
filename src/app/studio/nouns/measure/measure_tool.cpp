#include "app/studio/nouns/measure/measure_tool.h"

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/surface_place.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/measure/measure_state.h"
#include "app/studio/nouns/taxel/taxel_commands.h"
#include "ui/scene/scene_cast.h"

namespace taxel::ui {

namespace {

constexpr double kSnap = 12;  // largest distance at which a point snaps to a taxel's centre, at scale 1 [pixels]

/// Returns the centre of the taxel near the pointer, or the place of the skin under the pointer.
std::optional<MeasurePoint> point_at(const WindowUi& ui, const Viewer& viewer, const Shown& displayed,
                                     const SceneInput& scene, const dvec2& at) {
  const double reach = kSnap * ui.pixel_scale;
  const auto under = pick(scene, viewer.camera(), at.x, at.y, viewer.view.width, viewer.view.height, reach);
  if (under && under->taxel >= 0 && under->taxel < displayed.document.model->taxel_count()) {
    const Taxel& taxel = displayed.document.model->layout.taxels[static_cast<std::size_t>(under->taxel)];
    return MeasurePoint{taxel.center, taxel.id};
  }
  const auto shown =
      shown_part(scene.clip, viewer.camera().pixel_ray(at.x, at.y, viewer.view.width, viewer.view.height));
  if (!shown) return std::nullopt;
  const auto place = place_under(*displayed.document.model->skin, in_frame(shown_pose(viewer, displayed), shown->ray));
  if (!place) return std::nullopt;
  return MeasurePoint{place->position, std::nullopt};
}

}  // namespace

void leave_measure(MeasureState& measure) {
  measure = {};
}

bool can_measure(const Viewer& viewer, const DocumentView& document) {
  return viewer.mode == Mode::layout && document.model != nullptr;
}

bool toggle_measure(const Viewer& viewer, const DocumentView& document, MeasureState& measure) {
  const bool on = measure.on;
  leave_measure(measure);
  measure.on = !on && can_measure(viewer, document);
  return measure.on;
}

std::optional<MeasureRequest> measure_request(const Viewer& viewer, const DocumentView& document,
                                              const MeasureState& measure) {
  if (!measure.on || measure.points.size() != 2 || viewer.mode != Mode::layout || !document.model) return std::nullopt;
  return MeasureRequest{document.model->skin, measure.points[0].at, measure.points[1].at};
}

bool handle_measure_mouse(const WindowUi& ui, const Viewer& viewer, const Shown& shown, bool has_other_tool,
                          MeasureState& measure, const SceneInput& scene, const PointerEvent& event) {
  measure.hover.reset();
  if (!measure.on || viewer.mode != Mode::layout || !shown.document.model || has_other_tool) return false;
  if (!event.hovered || event.ctrl || event.shift) return false;
  const bool clicked = event.left().clicked();
  if (event.any_down || (!clicked && event.left().released)) return false;
  measure.hover = point_at(ui, viewer, shown, scene, event.at);
  if (!clicked || !measure.hover) return clicked;
  if (measure.points.size() == 2) measure.points.clear();
  measure.points.push_back(*measure.hover);
  return true;
}

void carry_out(const ToggleMeasure&, App& app) {
  if (toggle_measure(*app.viewer, app.shown->document, app.get<MeasureState>())) leave_tool(app);
}

}  // namespace taxel::ui
