// Arrows of the net forces that contacts exert on sensors.
#include "core/base/text/rounded.h"
#include "ui/scene/marks/marks.h"

#include <fmt/format.h>

namespace taxel::ui {
namespace {

constexpr double kLongestForce = 0.8;  // largest length of an arrow, as a fraction of the sensor's diagonal

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
    marks.push_back({view.index, base_W, base_W + metres_per_newton * view.state->force_W, force});
  }
  return marks;
}

std::string force_text(double force) {
  return force < 0.01 ? rounded(force, 2, 4) + " N" : fmt::format("{:.2f} N", force);
}

}  // namespace taxel::ui
