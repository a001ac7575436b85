// Receptive fields: the discs of taxels, the samples that each taxel gathers and their weights, as sparse rows, the
// discs that have their own density of samples, and the weights as functions on the skin.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "core/layout/field/point_grid.h"
#include "core/layout/layout.h"
#include "core/layout/sampling/poisson_disk.h"
#include "core/mesh/geodesic.h"
#include "core/mesh/query/closest_point.h"
#include "core/mesh/query/triangle.h"

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

/// A disc that gathers samples in a receptive field: one per taxel, or one per subtaxel.
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

/// Rows = taxels in layout order. Row k is entries [first[k], first[k+1]), sorted by sample number.
struct ReceptiveFields {
  struct Entry {
    int sample = 0;
    double distance = 0.0;  ///< d, from the taxel's centre [m]
    double weight = 0.0;    ///< (r - d)^2 c [m^2], times the share or the Voronoi area ratio of the sample
  };
  std::vector<int> first{0};
  std::vector<Entry> entries;
  [[nodiscard]] int taxel_count() const { return static_cast<int>(first.size()) - 1; }
};

/// Returns the receptive fields. The field of a taxel has the samples within radius r of the centre whose normal is
/// less than max_angle_deg from the taxel's normal, and c is the factor of FieldAngle, which is 1 without a roll-off.
/// The normal is that of the face, or interpolated (FieldNormals). Fields may overlap. Distances are Euclidean from the
/// stored centre (Metric::euclidean, the paper), or lengths of shortest paths on `skin` from the point closest to the
/// centre (Metric::geodesic), up to rounding. With subtaxels, the field is the union of their fields, with r, d and c
/// of the nearest subtaxel. `samples` are on faces of `skin`. The result does not depend on the number of threads.
ReceptiveFields make_receptive_fields(const Layout& layout, const std::vector<SurfaceSample>& samples,
                                      const MeshIndex& skin);

/// Returns true if a taxel has more samples than the layout gives.
inline bool is_dense(const Taxel& taxel, const Sampling& sampling) {
  return taxel.density > sampling.density;
}

/// Returns the number of samples on `area` without the densities of taxels. `count` is the number of samples that there
/// are, which is returned if no taxel has a density of its own.
double uniform_samples(const Layout& layout, std::size_t count, double area);

/// Returns the discs of all taxels with a density of their own, on the side of the skin to which their normals point.
/// Each disc contains the receptive field of its taxel or subtaxel.
std::vector<DenseDisc> dense_fields(const Layout& layout, const MeshIndex& skin);

/// Multiplies all densities of a layout.
void multiply_densities(Layout& layout, double factor);

/// The weight of every taxel at any point of the skin, for integrals without samples, as ReceptiveFields defines it for
/// samples: w = (r - d)^2 c if d <= r and the normal of the skin is less than the angle limit from the normal of the
/// disc, with the factor c of FieldAngle; with subtaxels, r, d and c of the nearest subtaxel. Immutable, so threads can
/// share it.
class FieldWeights {
 public:
  struct Weight {
    int taxel = 0;      ///< index in layout order
    double value = 0;   ///< w, never negative [m^2]
    double facing = 0;  ///< c, greater than 0 and at most 1
  };
  /// The fields at one point. The object is reused between calls, so that no call allocates memory.
  struct AtPoint {
    std::vector<Weight> weights;  ///< weights by ascending id, so sums do not depend on the order of the taxels
    /// Distance of the point from the edge of the area that the fields cover together, along the known path across the
    /// edge: the largest r - d of the discs that cover the face, negative outside [m].
    double margin = 0;
    /// The largest factor c of the taxels with a weight greater than 0; 0 without one. It is 1 without a roll-off.
    double cover = 0;
  };

  /// A disc of a taxel.
  struct Disc {
    FieldDisc disc;
    int taxel = 0;
    dvec3 origin{0};  ///< origin of distances: the stored centre, or its closest point on the skin
  };

  /// `skin` has the outer shells, as for make_receptive_fields(). With geodesic distances, memory and time are those of
  /// one propagation per disc.
  FieldWeights(const Layout& layout, const MeshIndex& skin);

  /// Sets `discs` to the discs, ascending, that may contain points of the skin within `reach` of p.
  void near(const dvec3& p, double reach, std::vector<int>& discs) const;
  /// Computes the weights at a point of a face of the skin, only for `discs` (ascending).
  void at(int face, const dvec3& point, std::span<const int> discs, AtPoint& out) const;
  /// Computes the weights at a point where the skin has another unit normal than the face: on an edge or a corner, a
  /// normal between those of its faces. FieldNormals::interpolated takes the interpolated normal in place of `normal`.
  void at(int face, const dvec3& point, const dvec3& normal, std::span<const int> discs, AtPoint& out) const;
  /// Returns the smallest radius of `discs` [m]; infinite if there are none.
  [[nodiscard]] double smallest_radius(std::span<const int> discs) const;

  /// Returns a disc by its number. Numbers ascend with the ids of the taxels.
  [[nodiscard]] const Disc& disc(int number) const { return discs_[static_cast<std::size_t>(number)]; }
  [[nodiscard]] const FieldAngle& angle() const { return angle_; }
  [[nodiscard]] FieldNormals normals() const { return normals_; }
  [[nodiscard]] bool geodesic() const { return !paths_.empty(); }  ///< true if distances are along the skin
  /// Returns the distance of a point of a face from the origin of a disc; infinite if no known path leads there [m].
  [[nodiscard]] double distance(int disc, int face, const dvec3& point) const;

 private:
  TriMeshPtr skin_;
  FieldAngle angle_;
  FieldNormals normals_;
  double largest_radius_ = 0;
  std::vector<Disc> discs_;         // discs by ascending id of the taxel
  std::vector<GeodesicMap> paths_;  // paths of each disc; empty for Euclidean distances
  PointGrid grid_{{}, 1.0};         // grid of the origins
};

}  // namespace taxel
