#include "core/sim/plugin/contact_instance.h"

#include "core/base/error.h"
#include "core/sim/plugin/pairs/geom_body.h"

namespace taxel {
namespace {

/// Returns the bounds of a body in its own frame; empty for a half-space.
Aabb bounds_of(const HydroBody& body) {
  Aabb box;
  if (const auto* soft = std::get_if<SoftBody>(&body.geometry))
    for (const dvec3& v : soft->field->vertices()) box.include(v);
  return box;
}

}  // namespace

ContactInstance::ContactInstance(const mjModel& m, int instance)
    : instance_(instance), config_(read_contact_config(m, instance)) {
  const std::vector<DeclaredBody> declared = declared_bodies(m, instance);
  bodies_.reserve(config_.bodies.size());
  for (std::size_t k = 0; k < config_.bodies.size(); ++k) {
    BodyContacts& body = bodies_.emplace_back(BodyId{instance, static_cast<int>(k)}, declared);
    HydroBodyPtr soft;
    try {
      std::string repair;
      soft = geom_body(m, body.settings().geom, config_.materials, repair);
      if (!repair.empty()) body.warnings.push_back(repair);
    } catch (const Error& error) {
      throw Error("", "materials", error.what());
    }
    const Aabb bounds = bounds_of(*soft);
    body.set_body(m, std::move(soft), bounds, Pose{});
  }
}

void ContactInstance::sense(const mjModel& m, mjData& d) {
  for (BodyContacts& body : bodies_) body.sense(m, d);
  for (int s = 0; s < m.nsensor; ++s) {
    if (m.sensor_plugin[s] != instance_) continue;
    mjtNum* out = d.sensordata + m.sensor_adr[s];
    for (const BodyContacts& body : bodies_)
      for (const Output block : config_.output) out = body.write_output(block, out);
  }
}

}  // namespace taxel
