// Arrows of the net forces that contacts exert on sensors.
#include "core/base/text/rounded.h"
#include "ui/scene/marks/marks.h"

#include <fmt/format.h>

namespace taxel::ui {
namespace {

constexpr double kLongestForce = 0.8;  // largest length of an arrow, as a fraction of the sensor's diagonal
constexpr double kGapAside = 0.3;      // gap between contact and arrow, as a fraction of half of the contact's width
constexpr double kEndOn = 0.05;        // a smaller part of the force across the line of sight has no direction

/// Returns the direction across the line of sight to the right of a vector, as the image shows it; the right of the
/// image if the vector is along the line of sight.
dvec3 right_of(const dvec3& along_W, const Camera& camera) {
  const glm::dmat3 axes = glm::transpose(glm::dmat3(camera.view()));  // columns: right, up, towards the eye
  const dvec2 seen(glm::dot(axes[0], along_W), glm::dot(axes[1], along_W));
  if (!(glm::length(seen) > kEndOn * glm::length(along_W))) return axes[0];
  return glm::normalize(seen.y * axes[0] - seen.x * axes[1]);
}

}  // namespace

double force_of_named_arrow(const std::vector<SensorView>& views) {
  double force = 1;
  for (const SensorView& view : views) {
    if (view.state == nullptr) continue;
    const double largest = glm::length(view.state->force_W),
                 room = kLongestForce * view.model->mesh->bounds().diagonal();
    if (!(room > 0) || !std::isfinite(largest)) continue;
    while (kNamedArrow * largest > room * force) force *= 10;
  }
  return force;
}

std::vector<ForceMark> force_marks(const SceneInput& input, const std::vector<SensorView>& views) {
  std::vector<ForceMark> marks;
  if (!input.overlays.contact_surface) return marks;
  const double metres_per_newton = kNamedArrow / force_of_named_arrow(views);
  for (const SensorView& view : views) {
    if (view.state == nullptr) continue;
    const double force = glm::length(view.state->force_W);
    const std::optional<dvec3> from = center_of_pressure(*view.state);
    if (!(force > 0) || !from) continue;
    const dvec3 base_W = view.X_WM * *from;
    marks.push_back({view.index, base_W, base_W, base_W + metres_per_newton * view.state->force_W, force});
  }
  return marks;
}

std::vector<ForceMark> force_marks_aside(const SceneInput& input, const std::vector<SensorView>& views,
                                         const Camera& camera) {
  std::vector<ForceMark> marks = force_marks(input, views);
  for (ForceMark& mark : marks) {
    const auto view =
        std::find_if(views.begin(), views.end(), [&](const SensorView& one) { return one.index == mark.sensor; });
    const dvec3 aside_W = right_of(mark.tip_W - mark.base_W, camera);
    double reach = 0;
    for (const ContactSurface& surface : view->state->surfaces)
      for (const dvec3& p_M : surface.vertices)
        reach = std::max(reach, glm::dot(aside_W, view->X_WM * p_M - mark.center_W));
    const dvec3 move_W = (1 + kGapAside) * reach * aside_W;
    mark.base_W += move_W;
    mark.tip_W += move_W;
  }
  return marks;
}

std::string force_text(double force) {
  return force < 0.01 ? rounded(force, 2, 4) + " N" : fmt::format("{:.2f} N", force);
}

}  // namespace taxel::ui
