#include "core/layout/generators/ring.h"

#include <fmt/format.h>

#include "core/layout/generators/place.h"

namespace taxel {
namespace {

/// Rays from outside of the mesh toward an axis.
class Inward {
 public:
  Inward(const AroundAxis& around, const MeshIndex& skin, std::string generator)
      : around_(around), skin_(skin), generator_(std::move(generator)) {
    require_count(generator_, "count", around.count);
    require_positive(generator_, "radius", around.radius);
    require_finite(generator_, "origin", around.origin);
    axis_ = require_direction(generator_, "axis", around.axis);
    const dvec3 first = require_direction(generator_, "first", around.first);
    const dvec3 across = first - glm::dot(first, axis_) * axis_;
    const double parallel = 1e-6;  // sine of the smallest angle that defines a half plane
    if (glm::length(across) < parallel) throw Error(generator_, "first", "must not be parallel to axis");
    zero_ = glm::normalize(across);
    quarter_ = glm::cross(axis_, zero_);
  }

  [[nodiscard]] Taxel at(int id, double height, double angle) const {
    const dvec3 out = std::cos(angle) * zero_ + std::sin(angle) * quarter_;
    const dvec3 foot = around_.origin + height * axis_;
    const Aabb& box = skin_.mesh().bounds();
    const double outside = glm::distance(foot, box.center()) + box.diagonal();
    SurfacePoint hit =
        *skin_under(skin_, foot + outside * out, -out, Beyond::refuse, generator_, fmt::format("taxel {}", id));
    if (glm::dot(hit.position - foot, out) < 0.0)
      throw Error(generator_, fmt::format("taxel {}", id),
                  fmt::format("the ray toward the axis at height {:.6g} meets the mesh only beyond the axis", height));
    return taxel_on(skin_.mesh(), hit, id, around_.radius);
  }

 private:
  const AroundAxis& around_;
  const MeshIndex& skin_;
  std::string generator_;
  dvec3 axis_{0}, zero_{0}, quarter_{0};
};

}  // namespace

std::vector<Taxel> ring(const AroundAxis& around, double height, const MeshIndex& skin) {
  const Inward inward(around, skin, "ring");
  require_finite("ring", "height", height);
  std::vector<Taxel> taxels;
  for (int i = 0; i < around.count; ++i) taxels.push_back(inward.at(i, height, 2.0 * kPi * i / around.count));
  return taxels;
}

std::vector<Taxel> helix(const AroundAxis& around, double bottom, double top, double turns, const MeshIndex& skin) {
  const Inward inward(around, skin, "helix");
  if (around.count < 2) throw Error("helix", "count", fmt::format("must be at least 2, is {}", around.count));
  require_finite("helix", "bottom", bottom);
  require_finite("helix", "top", top);
  require_finite("helix", "turns", turns);
  if (turns == 0.0) throw Error("helix", "turns", "must not be 0");
  std::vector<Taxel> taxels;
  for (int i = 0; i < around.count; ++i) {
    const double t = static_cast<double>(i) / (around.count - 1);
    taxels.push_back(inward.at(i, bottom + t * (top - bottom), 2.0 * kPi * turns * t));
  }
  return taxels;
}

}  // namespace taxel
