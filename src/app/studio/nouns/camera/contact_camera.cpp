// The camera of a scenario's run: at the first touch it comes near, and then it follows the contact, until the user
// moves it. The first view of a run has its whole path, in which a contact is small.
#include <algorithm>
#include <cmath>
#include <optional>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/camera/camera_state.h"
#include "ui/scene/camera.h"

namespace taxel::ui {
namespace {

/// Length that the shorter side of the view shows at the contact, in diagonals of the touching sensor: the pad, and the
/// arrow of a force of 1 N next to it.
constexpr double kPadShown = 0.8;
/// Time constant with which target and distance approach those of the contact [s].
constexpr double kApproachTime = 0.3;

/// Returns the diagonal of the largest sensor that touches something [m].
double touching_diagonal(const SimFrame& frame) {
  double largest = 0;
  for (const SensorStep& sensor : frame.sensors)
    if (!sensor.surfaces.empty()) largest = std::max(largest, sensor.model->mesh->bounds().diagonal());
  return largest;
}

/// Returns the distance at which the shorter side of the view shows a length at the target [m].
double distance_for(const Camera& camera, const ViewPlace& view, double length) {
  const double height = length * std::max(1.0, static_cast<double>(view.height) / view.width);
  return 0.5 * height / std::tan(0.5 * glm::radians(camera.fov_deg));
}

}  // namespace

void lead_to_contact(App& app, double seconds) {
  ContactCamera& state = app.get<ContactCamera>();
  if (!state.leads || !shows_run(app.viewer->mode)) return;
  const RunView& run = app.shown->run;
  Camera& camera = app.viewer->camera();
  state.leads = has_untouched_camera(app);
  if (!state.leads || !run.runs_scenario || !run.playing || !run.frame || app.viewer->view.width <= 0) return;
  const std::optional<dvec3> contact_W = contact_center(*run.frame);
  if (!contact_W) return;
  const double near = distance_for(camera, app.viewer->view, kPadShown * touching_diagonal(*run.frame));
  const double share = -std::expm1(-seconds / kApproachTime);
  camera.target += share * (*contact_W - camera.target);
  camera.distance += share * (std::min(near, camera.distance) - camera.distance);
  app.get<Framing>().framed[1] = camera;
}

}  // namespace taxel::ui
