// The keys `contype` and `conaffinity` of sensors: bits of contact of a skin. MuJoCo computes no contact of the skin's
// geom and of geoms that the skin replaces, so the bits of these geoms are 0. Those of the skin decide which geoms it
// touches.
#pragma once

#include <mujoco/mujoco.h>

#include <map>

namespace taxel {

/// Two masks as of a geom: two geoms collide if the `contype` of one has a bit of the `conaffinity` of the other.
struct ContactBits {
  int contype = 0, conaffinity = 0;
  [[nodiscard]] bool any() const { return contype != 0 || conaffinity != 0; }
  bool operator==(const ContactBits&) const = default;
};

inline bool match(const ContactBits& a, const ContactBits& b) {
  return ((a.contype & b.conaffinity) | (b.contype & a.conaffinity)) != 0;
}
inline ContactBits operator|(const ContactBits& a, const ContactBits& b) {
  return {a.contype | b.contype, a.conaffinity | b.conaffinity};
}

/// Reads the keys of one sensor. Throws Error whose place is the key unless the value is a whole number from 0 on.
ContactBits read_skin_bits(const mjModel& m, int instance);

/// The bits of contact of all skins of a model.
class SkinBits {
 public:
  /// Skips sensors whose configuration is not valid: their own instance reports the reason.
  explicit SkinBits(const mjModel& m);

  /// Returns the bits of a geom together with those of the skin on it.
  [[nodiscard]] ContactBits of(int geom) const;
  /// Returns true if the bits let a geom of the body of `geom` touch the geom `other`, and the two bodies can collide
  /// and are not excluded. Always false in a model without such keys.
  [[nodiscard]] bool let_touch(int geom, int other) const;

 private:
  const mjModel& m_;
  std::map<int, ContactBits> skins_;  // by geom of the sensor
};

}  // namespace taxel
