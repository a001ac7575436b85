#include "core/hydro/friction/sticking_friction.h"

#include <algorithm>
#include <limits>

namespace taxel {
namespace {

double squared_length(const dvec3& v) {
  return glm::dot(v, v);
}

/// Returns the mean of a value of the roots at a point by their shares, or `none` if there are no roots.
template <class T, class Value>
T mean_at(const StickingFriction& friction, const dvec3& x, const T& none, const Value& value) {
  double least = std::numeric_limits<double>::infinity();
  for (const StickingFriction::Root& root : friction.roots) least = std::min(least, squared_length(root.place - x));
  T sum = none;
  double parts = 0;
  for (const StickingFriction::Root& root : friction.roots) {
    const double part = share_of(squared_length(root.place - x), least, friction.reach);
    sum += part * value(root);
    parts += part;
  }
  return parts > 0 ? sum / parts : none;
}

}  // namespace

dvec3 StickingFriction::traction_at(const dvec3& x) const {
  return mean_at(*this, x, dvec3(0), [](const Root& root) { return root.traction; });
}

double StickingFriction::slip_at(const dvec3& x) const {
  return mean_at(*this, x, 0.0, [](const Root& root) { return root.slips ? 1.0 : 0.0; });
}

StickingFriction sticking_friction(const BristleContact& contact, const BristleSkin& skin, const BristleLaw& law,
                                   const Twist& V_BA) {
  StickingFriction friction;
  friction.reach = skin.reach();
  for (const Bristle& b : contact.bristles()) {
    const BristleAnswer answer = answer_of(b, law, V_BA);
    friction.roots.push_back(
        {skin.roots()[static_cast<std::size_t>(b.root)], b.normal, b.area, answer.force / b.area, answer.slips});
  }
  return friction;
}

StickingFriction mirrored(const StickingFriction& on_A, const RigidTransform& X_BA) {
  StickingFriction on_B = on_A;
  for (StickingFriction::Root& root : on_B.roots)
    root = {X_BA(root.place), -(X_BA.R * root.normal), root.area, -(X_BA.R * root.traction), root.slips};
  return on_B;
}

}  // namespace taxel
