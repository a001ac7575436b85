// The generalised winding number of a surface around a point, and the solid angle of a triangle: summed over a closed
// mesh both separate inside from outside.
#pragma once

#include <cmath>

#include "core/base/math.h"
#include "core/mesh/query/bvh.h"

namespace taxel {

/// Generalised winding number (Jacobson, Kavan, Sorkine-Hornung 2013, "Robust inside-outside segmentation using
/// generalized winding numbers"): the signed solid angle of all faces over 4 pi. 1 inside a closed surface that winds
/// outward, 0 outside, a harmonic function in between if the surface has holes. Faces far away are summed by
/// clusters, each as one dipole (Barill et al. 2018, "Fast winding numbers for soups and clouds").
class WindingNumber {
 public:
  WindingNumber(const std::vector<dvec3>& points, std::vector<ivec3> faces);
  /// The winding number at p, with an error below 0.01 by the clusters. O(log n).
  [[nodiscard]] double operator()(const dvec3& p) const { return without(p, -1); }
  /// The winding number at a point p of a face, of all faces except this one: the mean of those on its two sides.
  [[nodiscard]] double without(const dvec3& p, int left_out) const;

 private:
  struct Cluster {
    dvec3 center{0};           ///< mean of the faces' centres, by area
    dvec3 normal{0};           ///< sum of the faces' normals, by area [m^2]
    double squared_reach = 0;  ///< beyond it the cluster is one dipole [m^2]
  };
  const std::vector<dvec3>& points_;
  std::vector<ivec3> faces_;
  Bvh bvh_;
  std::vector<Cluster> clusters_;  ///< one per node of the tree
};

/// Returns the solid angle of the triangle (a, b, c) seen from the origin [sr], positive if the origin lies behind the
/// triangle, as inside of a closed mesh (van Oosterom, Strackee 1983).
inline double solid_angle(const dvec3& a, const dvec3& b, const dvec3& c) {
  const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
  const double numerator = glm::dot(a, glm::cross(b, c));
  const double denominator = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
  return 2.0 * std::atan2(numerator, denominator);
}

}  // namespace taxel
