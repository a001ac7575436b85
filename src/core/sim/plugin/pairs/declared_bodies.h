// The bodies whose contacts a model declares: each sensor, and each soft geom of a `taxel.contact`. Also decides which
// of two such bodies computes their contact: both feel one surface, and one wrench moves them.
#pragma once

#include <mujoco/mujoco.h>

#include <compare>
#include <vector>

#include "core/sim/plugin/contact_config.h"
#include "core/sim/plugin/sensor_config.h"

namespace taxel {

/// A body of a plugin instance: a `taxel.sensor` has one, a `taxel.contact` one for each soft geom without a sensor.
struct BodyId {
  int instance = -1;  ///< -1: no body
  int number = 0;     ///< in the instance
  auto operator<=>(const BodyId&) const = default;
  [[nodiscard]] bool valid() const { return instance >= 0; }
};

struct DeclaredBody {
  BodyId id;
  bool sensor = true;        ///< whether the instance is a `taxel.sensor`
  ContactSettings settings;  ///< configured values, then completed by complete_settings()
};

/// Returns the bodies that the model declares, ascending. An instance whose configuration cannot be read is left out,
/// because its own init reports the reason; only for `instance` the Error is thrown.
///
/// The settings are completed by those of the other bodies: a pair that one of two bodies names is a pair of both; a
/// pair of a `taxel.contact` with a sensor's geom belongs to the sensor; and a material that a `taxel.contact` gives a
/// geom holds for all instances. Throws Error if `instance` gives a geom another material than another instance does,
/// makes a geom soft that another instance makes soft, or applies forces of a pair that a sensor only senses, or the
/// other way round.
std::vector<DeclaredBody> declared_bodies(const mjModel& m, int instance);

/// How a body and a geom that it touches share their contact.
struct PairRole {
  BodyId partner;         ///< body on the touched geom; not valid for an ordinary geom
  bool mirrored = false;  ///< the partner computes the surface and the wrench, this body takes both from there
  bool applies = true;    ///< the wrench moves bodies: once per pair of geoms
};

/// Returns the role of `self` towards `geom`. Of two bodies the one that applies forces computes the pair, otherwise
/// the one whose geom's name comes first. If several sensors are on one geom, the first that applies forces represents
/// it, otherwise the first; the others compute their pairs for themselves and move nothing.
PairRole pair_role(const std::vector<DeclaredBody>& bodies, const DeclaredBody& self, int geom);

}  // namespace taxel
