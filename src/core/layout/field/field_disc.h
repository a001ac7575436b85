// Discs that gather samples in a receptive field: one disc per taxel, or one per subtaxel.
#pragma once

#include <vector>

#include "core/layout/layout.h"

namespace taxel {

struct FieldDisc {
  dvec3 center{0}, normal{0, 0, 1};  ///< centre [m] and unit normal
  double radius = 0;

  /// Returns true if the normal of a face is less than the angle limit from the normal of the disc.
  [[nodiscard]] bool faces(const dvec3& face_normal, double min_cosine) const {
    return glm::dot(face_normal, normal) > min_cosine;
  }
  /// Returns the paper's weight w = (r - d)^2 for d <= r [m^2].
  [[nodiscard]] double weight(double distance) const { return (radius - distance) * (radius - distance); }
};

inline std::vector<FieldDisc> discs_of(const Taxel& taxel) {
  if (taxel.subtaxels.empty()) return {{taxel.center, glm::normalize(taxel.normal), taxel.radius}};
  std::vector<FieldDisc> discs;
  for (const Subtaxel& s : taxel.subtaxels) discs.push_back({s.center, glm::normalize(s.normal), s.radius});
  return discs;
}

/// Returns the cosine of the angle limit.
inline double min_cosine(const ReceptiveFieldRule& rule) {
  return std::cos(rule.max_angle_deg * kPi / 180.0);
}

}  // namespace taxel
