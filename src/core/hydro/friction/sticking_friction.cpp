#include "core/hydro/friction/sticking_friction.h"

#include <algorithm>
#include <limits>

namespace taxel {
namespace {

double squared_length(const dvec3& v) {
  return glm::dot(v, v);
}

}  // namespace

dvec3 StickingFriction::traction_at(const dvec3& x) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Root& root : roots) least = std::min(least, squared_length(root.place - x));
  dvec3 sum{0};
  double parts = 0;
  for (const Root& root : roots) {
    const double part = share_of(squared_length(root.place - x), least, reach);
    sum += part * root.traction;
    parts += part;
  }
  return parts > 0 ? sum / parts : dvec3(0);
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
