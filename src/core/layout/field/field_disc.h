// Discs that gather samples in a receptive field: one disc per taxel, or one per subtaxel.
#pragma once

#include <algorithm>
#include <vector>

#include "core/layout/layout.h"
#include "core/mesh/query/skin_normal.h"

namespace taxel {

/// How a field rolls off with the angle between the normal of the skin and the normal of its disc.
class FieldAngle {
 public:
  explicit FieldAngle(const ReceptiveFieldRule& rule)
      : min_cosine_(cosine_of(rule.max_angle_deg)),
        full_cosine_(cosine_of(std::max(rule.max_angle_deg - rule.angle_falloff_deg, 0.0))) {}

  /// Returns the factor c of the weight for the cosine of the angle: 0 from the limit on, 1 up to the roll-off, and the
  /// smoothstep t^2 (3 - 2t) between them, where t is linear in the cosine.
  [[nodiscard]] double factor(double cosine) const {
    if (!(cosine > min_cosine_)) return 0.0;
    if (cosine >= full_cosine_) return 1.0;
    const double t = (cosine - min_cosine_) / (full_cosine_ - min_cosine_);
    return t * t * (3.0 - 2.0 * t);
  }
  [[nodiscard]] double min_cosine() const { return min_cosine_; }  ///< cosine of the angle limit

 private:
  static double cosine_of(double degrees) { return std::cos(degrees * kPi / 180.0); }

  double min_cosine_ = 0, full_cosine_ = 0;
};

struct FieldDisc {
  dvec3 center{0}, normal{0, 0, 1};  ///< centre [m] and unit normal
  double radius = 0;

  /// Returns true if the normal of a face is less than the angle limit from the normal of the disc.
  [[nodiscard]] bool faces(const dvec3& face_normal, double min_cosine) const {
    return glm::dot(face_normal, normal) > min_cosine;
  }
  /// Returns the factor c of the weight at a point with this unit normal: 0 at the angle limit and beyond.
  [[nodiscard]] double facing(const dvec3& skin_normal, const FieldAngle& angle) const {
    return angle.factor(glm::dot(skin_normal, normal));
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

/// Returns the unit normal of the skin at a point of a face, as the angle limit refers to it.
inline dvec3 field_normal(FieldNormals normals, const TriMesh& skin, int face, const dvec3& point) {
  return normals == FieldNormals::interpolated ? skin_normal(skin, face, point)
                                               : skin.face_normals()[static_cast<std::size_t>(face)];
}

/// Returns the cosine of the angle limit.
inline double min_cosine(const ReceptiveFieldRule& rule) {
  return std::cos(rule.max_angle_deg * kPi / 180.0);
}

}  // namespace taxel
