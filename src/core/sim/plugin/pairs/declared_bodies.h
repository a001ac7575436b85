// The bodies whose contacts a model declares: each sensor, and each soft geom of a `taxel.contact`. If two of them
// touch each other, they share one surface and one wrench; this file decides which of the two bodies computes them.
#pragma once

#include <mujoco/mujoco.h>

#include <compare>
#include <vector>

#include "core/sim/plugin/plugin_config.h"

namespace taxel {

/// A body of a plugin instance: a `taxel.sensor` has one, a `taxel.contact` one for each soft geom without a sensor.
struct BodyId {
  int instance = -1;  ///< plugin instance; -1 if there is no body
  int number = 0;     ///< index of the body in the instance
  auto operator<=>(const BodyId&) const = default;
  [[nodiscard]] bool valid() const { return instance >= 0; }
};

struct DeclaredBody {
  BodyId id;
  bool sensor = true;        ///< true if the instance is a `taxel.sensor`
  ContactSettings settings;  ///< configured values, then completed by complete_settings()
};

/// Returns the bodies that the model declares, ascending. An instance whose configuration cannot be read is left out,
/// because its own init reports the reason; for `instance` itself the Error is thrown.
///
/// The settings of a body are completed by those of the other bodies. A pair that one of two bodies names is a pair of
/// both. A pair of a `taxel.contact` with the geom of a sensor belongs to the sensor. A material that a `taxel.contact`
/// gives to a geom applies in all instances. Throws Error if `instance` and another instance give a geom different
/// materials or both make it soft, or if one of them applies the forces of a pair that the other only senses.
std::vector<DeclaredBody> declared_bodies(const mjModel& m, int instance);

/// How a body and a geom that it touches share their contact.
struct PairRole {
  BodyId partner;         ///< body on the touched geom; not valid for an ordinary geom
  bool mirrored = false;  ///< the partner computes the surface and the wrench, and this body copies both
  bool applies = true;    ///< the wrench moves bodies; true for one contact of each pair of geoms
};

/// Returns the role of `self` towards `geom`. If only one of two bodies applies forces, that body computes the pair;
/// otherwise the body whose geom's name comes first. If several sensors are on one geom, the first one that applies
/// forces represents the geom, or the first one if none applies forces; the other sensors compute their own pairs and
/// move nothing.
PairRole pair_role(const std::vector<DeclaredBody>& bodies, const DeclaredBody& self, int geom);

// Finds the other declared bodies of an mjData. The plugin table, which holds their instances, defines these functions.

class BodyContacts;

/// Returns a declared body in `d`. Returns null if its instance is not of this library, or if `d` is a bitwise copy (as
/// pickling makes) whose bodies are in another mjData.
BodyContacts* find_body(const mjData& d, BodyId id);

/// Returns a declared body in `d`, and builds it first if `d` is a bitwise copy. Throws Error.
BodyContacts& own_body(const mjModel& m, mjData& d, BodyId id);

}  // namespace taxel
