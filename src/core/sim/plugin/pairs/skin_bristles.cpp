#include "core/sim/plugin/pairs/skin_bristles.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/sim/plugin/shared/shared_parts.h"

namespace taxel {
namespace {

constexpr std::size_t kPerRoot = 5, kPerGeom = 7;

std::size_t place_of_pose(std::size_t roots, int geom) {
  return kPerRoot * roots + kPerGeom * static_cast<std::size_t>(geom);
}

BristleSkinPtr skin_of_body(const HydroBody& body, int count) {
  const auto* soft = std::get_if<SoftBody>(&body.geometry);
  if (soft == nullptr)
    throw Error("", "tangential_stiffness",
                fmt::format("needs a soft body with a skin, but \"{}\" is {}", body.name,
                            body.soft() ? "a plane" : "rigid: give it a modulus above 0"));
  return share_bristle_skin({hash_of_numbers(std::span(soft->field->vertices())), std::to_string(count)},
                            [&] { return std::make_shared<const BristleSkin>(*soft->field, count); });
}

}  // namespace

int bristle_state_size(const BristleSettings& settings, int geoms) {
  if (!settings.has_bristles()) return 0;
  return static_cast<int>(kPerRoot) * settings.count + static_cast<int>(kPerGeom) * geoms;
}

SkinBristles::SkinBristles(const HydroBody& body, const BristleSettings& settings)
    : settings_(settings), search_(skin_of_body(body, settings.count)) {}

void SkinBristles::read(std::size_t pair, const ContactSurface& surface, int geom, const Pose& X_MB,
                        std::span<const mjtNum> state) {
  if (pair >= contacts_.size()) {
    contacts_.resize(pair + 1);
    assigned_.resize(pair + 1, 0);
  }
  BristleContact& contact = contacts_[pair];
  if (assigned_[pair] == 0) contact.assign(surface, search_);
  assigned_[pair] = 1;
  for (Bristle& b : contact.bristles()) b.u = dvec3(0);
  const mjtNum* saved = &state[place_of_pose(search_.skin().roots().size(), geom)];
  const Pose X_saved{dquat(saved[0], saved[1], saved[2], saved[3]), dvec3(saved[4], saved[5], saved[6])};
  if (X_saved.q == dquat(0, 0, 0, 0)) return;
  const RigidTransform X_MM(X_MB * X_saved.inverse());  // moves points that are fixed to the touched body
  for (Bristle& b : contact.bristles()) {
    const mjtNum* own = &state[kPerRoot * static_cast<std::size_t>(b.root)];
    if (own[0] != geom + 1) continue;
    // New area attaches without deflection, so the force is kept; area that is lost takes its force away.
    const double kept = std::min(1.0, own[4] / b.area);
    const dvec3 u = kept * dvec3(own[1], own[2], own[3]) + (b.x - X_MM(b.x));
    b.u = u - glm::dot(u, b.normal) * b.normal;
  }
}

void SkinBristles::write(std::size_t pair, int geom, const Pose& X_MB, const BristleLaw& law, const Twist& V_BA,
                         std::span<const mjtNum> state) {
  for (const Bristle& b : contacts_[pair].bristles()) {
    const std::size_t place = kPerRoot * static_cast<std::size_t>(b.root);
    mjtNum* own = &next_[place];
    // Where two geoms touch one root, the geom that had the bristle before keeps it.
    if (own[0] != 0 && state[place] != geom + 1) continue;
    const dvec3 u = answer_of(b, law, V_BA).u;
    own[0] = geom + 1;
    for (int i = 0; i < 3; ++i) own[1 + i] = u[i];
    own[4] = b.area;
  }
  mjtNum* pose = &next_[place_of_pose(search_.skin().roots().size(), geom)];
  pose[0] = X_MB.q.w, pose[1] = X_MB.q.x, pose[2] = X_MB.q.y, pose[3] = X_MB.q.z;
  for (int i = 0; i < 3; ++i) pose[4 + i] = X_MB.p[i];
}

}  // namespace taxel
