// The pointer in the 3-D view, where no other tool takes it, and the commands about the view.
#include <optional>

#include "app/studio/frame/app.h"
#include "app/studio/frame/pointer_event.h"
#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/brush/brush.h"
#include "app/studio/nouns/camera/camera_state.h"
#include "app/studio/nouns/explain/explain_state.h"
#include "app/studio/nouns/generate/generate_state.h"
#include "app/studio/nouns/perturb/perturb_state.h"
#include "app/studio/nouns/scenario/scenario_state.h"
#include "app/studio/nouns/scene/controls_state.h"
#include "app/studio/nouns/scene/scene_layouts.h"
#include "app/studio/nouns/taxel/taxel_commands.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "app/studio/nouns/view/view_commands.h"
#include "app/studio/nouns/view/view_state.h"
#include "ui/scene/camera.h"

namespace taxel::ui {
namespace {

void flip_switch(bool& value) {
  value = !value;
}

}  // namespace

void carry_out(const ToggleOverlay& command, App& app) {
  flip_switch(app.viewer->overlays().*command.overlay);
}

void carry_out(const ToggleGroup& command, App& app) {
  flip_switch((app.viewer->overlays().*command.groups).at(command.group));
}

void carry_out(const CycleFrames&, App& app) {
  app.viewer->overlays().frames = next(app.viewer->overlays().frames);
}

void carry_out(const CycleLabels&, App& app) {
  app.viewer->overlays().labels = next(app.viewer->overlays().labels);
}

void carry_out(const ToggleClipPlane&, App& app) {
  toggle_clip(*app.viewer, *app.shown);
}

void carry_out(const FlipClipPlane&, App& app) {
  app.viewer->clip = app.viewer->clip->flipped();
}

void carry_out(const ToggleRangeLock&, App& app) {
  flip_switch(app.viewer->range.automatic);
}

void carry_out(const ToggleReadingRangeLock&, App& app) {
  toggle_reading_lock(*app.viewer, *app.shown);
}

void carry_out(const LinkRanges&, App& app) {
  flip_switch(app.viewer->readings.linked);
}

namespace {

/// Greatest distance between the pointer and the centre of a taxel that it picks, at scale 1 [pixels].
constexpr double kPickReach = 12;

void count_clicks(Clicks& clicks, const PointerEvent& event) {
  clicks.left += event.left().pressed ? 1 : 0;
  clicks.right += event.right().pressed ? 1 : 0;
  clicks.left_double += event.left().double_pressed ? 1 : 0;
  clicks.right_double += event.right().double_pressed ? 1 : 0;
}

/// Adds the plane, facing the eye through the middle, at the first notch; later notches move the plane.
void move_clip(Viewer& viewer, const Shown& shown, double notches) {
  constexpr double kPerNotch = 0.02;  // fraction of the size of the scene
  const Aabb box = scene_box(viewer, shown);
  if (box.empty()) return;
  if (!viewer.clip) return toggle_clip(viewer, shown);
  viewer.clip->offset -= kPerNotch * box.diagonal() * notches;
}

std::optional<Pick> pick_under(const App& app, const PointerEvent& event) {
  return pick(scene_input(app), app.viewer->camera(), event.at.x, event.at.y, app.viewer->view.width,
              app.viewer->view.height, kPickReach * app.ui->pixel_scale);
}

/// Zooms at the point under the pointer, or in the plane of the target if nothing is there.
void zoom_at_pointer(App& app, const PointerEvent& event) {
  const std::optional<Pick> under = pick_under(app, event);
  Camera& camera = app.viewer->camera();
  const ViewPlace& view = app.viewer->view;
  camera.zoom_at(event.wheel,
                 under ? under->position_W : camera.point_under(event.at.x, event.at.y, view.width, view.height));
}

bool turn_wheel(App& app, const PointerEvent& event) {
  if (!event.hovered || event.wheel == 0) return false;
  const bool edited = can_edit(*app.viewer, *app.shown);
  if (app.get<ToolState>().tool == Tool::brush && edited) {
    resize_brush(app.get<ToolState>(), *app.shown->document.model, event.wheel);
  } else if (event.ctrl && app.get<GenerateState>().open) {
    turn_pattern(app.get<GenerateState>(), event.wheel);
  } else if (event.ctrl && edited) {
    resize_by_wheel(*app.ui, app.viewer->selection, app.shown->document, app.get<ToolState>(), event.wheel);
  } else if (event.shift) {
    move_clip(*app.viewer, *app.shown, event.wheel);
  } else if (!looks_through_camera(*app.viewer, app.get<FollowState>())) {
    zoom_at_pointer(app, event);
  }
  return false;  // the tools see where the pointer is
}

/// Returns whether the gizmo has no use for an event: the wheel zooms there too, and a drag that began elsewhere passes
/// over the gizmo.
bool passes_gizmo(const PointerEvent& event) {
  const auto drags = [](const ButtonState& button) { return button.moved && (button.down || button.released); };
  return event.wheel != 0 || std::any_of(event.buttons.begin(), event.buttons.end(), drags);
}

/// Looks along an axis whose end in the gizmo is clicked, with every tool.
bool point_gizmo(App& app, const PointerEvent& event) {
  if (app.get<WindowParts>().is_presenting || passes_gizmo(event)) return false;
  const dvec2 size(app.viewer->view.width, app.viewer->view.height);
  const int axis = gizmo_hit(app.viewer->camera(), event.at / app.ui->pixel_scale, size / app.ui->pixel_scale);
  if (axis < 0) return false;
  if (event.left().clicked())
    free_camera(*app.viewer, app.get<FollowState>()), look_from_axis(app.viewer->camera(), axis);
  return true;
}

bool point_place(App& app, const PointerEvent& event) {
  const bool places = event.ctrl || app.get<ToolState>().tool == Tool::place;
  if (!event.left().clicked() || !places || !can_edit(*app.viewer, *app.shown)) return false;
  place_taxel(*app.ui, *app.viewer, *app.shown, app.get<ToolState>(), event.at.x, event.at.y);
  return true;
}

void select_under(App& app, const std::optional<Pick>& under, bool shift) {
  const bool simulates = shows_run(app.viewer->mode);
  if (under && under->sensor >= 0 && app.shown->shows_scene(*app.viewer)) app.viewer->selection.sensor = under->sensor;
  if (under && under->polygon >= 0 && under->taxel < 0 && simulates)
    return inspect_polygon(app.shown->run, app.get<ExplainState>(), app.get<PanelsShown>()[kExplain],
                           {under->surface, under->polygon});
  const SensorModelPtr model = app.shown->model(*app.viewer);
  if (under && under->taxel >= 0 && model && under->taxel < model->taxel_count()) {
    click_taxel(app.viewer->selection, model->layout.taxels[static_cast<std::size_t>(under->taxel)].id, shift);
  } else if (!shift) {
    app.viewer->selection.clear();
  }
  if (under && under->sensor >= 0) app.viewer->selection.is_sensor_chosen = true;
}

/// Centres the camera on a pick; with Ctrl the camera follows the picked body.
void centre_on(App& app, const Pick& under, bool ctrl) {
  if (ctrl && shows_run(app.viewer->mode) && app.shown->run.frame && app.shown->run.frame->scene)
    return track_body(*app.viewer, app.shown->run, app.get<FollowState>(), under);
  free_camera(*app.viewer, app.get<FollowState>());
  app.viewer->camera().target = under.position_W;
}

/// Edits the layout of a sensor that was double-clicked.
void edit_picked_sensor(WindowUi& ui, const RunView& run, const Pick& under) {
  const auto sensor = static_cast<std::size_t>(under.sensor);
  if (under.sensor < 0 || sensor >= run.frame->scene->sensors.size()) return;
  if (run.frame->scene->sensors[sensor]->taxel_count() > 0) ui.post(EditSensorLayout{under.sensor});
}

bool point_selection(App& app, const PointerEvent& event) {
  const bool left = event.left().clicked(), centre = event.right().double_pressed;
  const bool body = app.shown->shows_scene(*app.viewer) && event.left().double_pressed;
  const bool resting = is_pointer_resting();
  if (!left && !centre && !resting && !body) return false;
  const std::optional<Pick> under = pick_under(app, event);
  if (left) select_under(app, under, event.shift);
  if (body)
    select_body(*app.ui, app.viewer->selection, app.shown->run, app.get<PerturbState>(), app.get<ControlsState>(),
                under);
  if (body && under && app.viewer->mode == Mode::layout) edit_picked_sensor(*app.ui, app.shown->run, *under);
  if (centre && under) centre_on(app, *under, event.ctrl);
  if (resting) app.viewer->hovered = under;
  return true;
}

bool has_any_selection(const App& app) {
  return app.get<PathState>().selected >= 0 || !app.viewer->selection.empty() || app.viewer->selection.body >= 0;
}

void clear_selection(App& app) {
  app.get<PathState>().selected = -1;
  app.viewer->selection.clear();
  deselect_body(*app.ui, app.viewer->selection, app.get<PerturbState>());
}

}  // namespace

constinit const Feature kClicks{.tool = {"clicks", kEverywhere, [](App& app, const PointerEvent& event) {
                                           if (event.hovered) count_clicks(app.get<ViewShown>().clicks, event);
                                           return false;
                                         }}};
constinit const Feature kWheel{.tool = {"wheel", kEverywhere, turn_wheel}};
constinit const Feature kGizmo{.tool = {"gizmo", kEverywhere, point_gizmo}};
constinit const Feature kPlaceTaxel{.tool = {"place", kLayout, point_place}};
constinit const Feature kSelection{
    .tool = {"selection", kEverywhere, point_selection, 12, has_any_selection, clear_selection}};

}  // namespace taxel::ui
