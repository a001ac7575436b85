// The receptive fields as functions on the skin, and the prisms of rays from its faces, for the readings that are
// integrals over the contact polygons.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/hydro/hydro_body.h"
#include "core/layout/field/receptive_field.h"
#include "core/mesh/query/bvh.h"
#include "core/mesh/query/closest_point.h"
#include "core/mesh/query/nearest.h"
#include "core/sensor/sensor_cache.h"

namespace taxel {

// The receptive fields on the faces of the sensed skin, in the plane of each face. Readings that are integrals compute
// weights at thousands of points in each step, so all that depends on the face alone is computed once.

/// The plane of a face. Its coordinates (u, v) are along e1 and e2 from the first corner, so the corners are (0, 0),
/// (second, 0) and `third`.
struct FacePlane {
  dvec3 origin{0}, e1{0}, e2{0}, outward{0};
  double second = 0;  ///< u of the second corner [m]
  dvec2 third{0};     ///< third corner [m]

  [[nodiscard]] dvec2 project(const dvec3& x) const { return {glm::dot(x - origin, e1), glm::dot(x - origin, e2)}; }
  [[nodiscard]] dvec3 point(const dvec2& q) const { return origin + q.x * e1 + q.y * e2; }
};

/// Returns the plane of a face of a mesh.
FacePlane face_plane(const TriMesh& mesh, int face);

/// Immutable, so threads can share it.
class FaceFields {
 public:
  /// `skin` is the mesh of the weights.
  FaceFields(std::shared_ptr<const FieldWeights> weights, const TriMesh& skin);

  /// The discs that reach a face, as ranges of the arrays below. They are ascending by the ids of their taxels.
  struct Range {
    std::uint32_t first = 0, end = 0;
    bool subtaxels = false;   ///< true if several of the discs belong to one taxel
    double least_radius = 0;  ///< smallest radius of the discs; infinite without discs [m]
    [[nodiscard]] std::size_t count() const { return end - first; }
  };
  [[nodiscard]] const Range& range(int face) const { return ranges_[static_cast<std::size_t>(face)]; }
  [[nodiscard]] const FacePlane& plane(int face) const { return planes_[static_cast<std::size_t>(face)]; }
  [[nodiscard]] int face_count() const { return static_cast<int>(planes_.size()); }
  [[nodiscard]] int taxel(std::size_t disc) const { return taxel_[disc]; }
  [[nodiscard]] double radius(std::size_t disc) const { return radius_[disc]; }
  /// Returns the centre of a disc in the plane of the face, and its squared distance from the plane [m^2].
  [[nodiscard]] dvec3 center(std::size_t disc) const { return {u_[disc], v_[disc], height2_[disc]}; }
  /// Returns r - d of a disc at a point of the plane of the face, with the straight distance d [m].
  [[nodiscard]] double straight_margin(std::size_t disc, const dvec2& q) const {
    const double u = q.x - u_[disc], v = q.y - v_[disc];
    return radius_[disc] - std::sqrt(u * u + v * v + height2_[disc]);
  }
  /// Returns true if distances are straight and the angle of a disc is the same on a whole face.
  [[nodiscard]] bool flat() const { return !geodesic_ && !interpolated_; }

  /// The discs of a face at one point: distance from the centre [m] and factor of the angle, 0 to 1. The memory is
  /// reused between calls.
  struct AtPoint {
    std::vector<double> away, facing;
  };
  void at(int face, const dvec2& q, AtPoint& out) const;
  /// Returns true if no other disc of the same taxel has the point nearer to its centre. `i` counts from range.first.
  [[nodiscard]] bool is_nearest(const Range& range, std::size_t i, const AtPoint& at) const;

 private:
  /// cos(angle) = (a + b u + c v) / |n(u, v)|, with the interpolated normal n.
  struct Slope {
    double a = 0, b = 0, c = 0;
  };
  void add_face(const TriMesh& skin, int face, std::vector<int>& near);
  static std::array<dvec3, 3> slopes_of(const FacePlane& plane, const std::array<dvec3, 3>& normals);

  std::shared_ptr<const FieldWeights> weights_;
  bool geodesic_ = false, interpolated_ = false;
  std::vector<FacePlane> planes_;
  std::vector<Range> ranges_;
  std::vector<double> u_, v_, height2_, radius_, facing_;  // by disc of a face
  std::vector<int> taxel_, disc_;
  std::vector<Slope> slope_;                   // by disc of a face, with interpolated normals
  std::vector<std::array<dvec3, 3>> normals_;  // n(u, v) = [0] + [1] u + [2] v of each face, with interpolated normals
};

// The rays from whole faces of the skin: each face and its rays form a prism, from the face inward. A contact polygon
// is hit by the rays of a face where it is inside of the prism.

/// A line in the plane of a face: normal q + offset, positive on the inner side.
struct FaceLine {
  dvec2 normal{0};
  double offset = 0;
  [[nodiscard]] double operator()(const dvec2& q) const { return glm::dot(normal, q) + offset; }
};

/// The prism of a face.
struct RayPrism {
  int face = -1;  ///< face of the sensed skin
  FacePlane plane;
  std::array<FaceLine, 3> edges;
  /// Depth up to which no ray of the face ends early, at the middle of a thin part of the body [m].
  double free_depth = 0;
};

/// The prisms of the faces that are sampled and that a field reaches. Immutable.
class RayPrisms {
 public:
  /// `region` lists the sampled faces of skin.mesh, ascending; empty for all. `depth` is SensorModel::max_depth.
  RayPrisms(const SensorSkin& skin, const std::vector<int>& region, const FaceFields& fields, const HydroBody& body,
            double depth);

  [[nodiscard]] const std::vector<RayPrism>& prisms() const { return prisms_; }
  /// A prism that a tet intersects.
  struct InTet {
    std::int32_t prism = 0;
    /// The planes of its sides as normal and offset, positive inside, in single precision: three times (x, y, z,
    /// offset).
    std::array<float, 12> sides{};
    /// Returns false only if a ball about x is surely outside of a side.
    [[nodiscard]] bool may_reach(const std::array<float, 3>& x, float radius) const {
      float least = std::numeric_limits<float>::infinity();
      for (std::size_t i = 0; i < 12; i += 4)
        least = std::min(least, sides[i] * x[0] + sides[i + 1] * x[1] + sides[i + 2] * x[2] + sides[i + 3]);
      return least >= -radius;
    }
  };
  /// Returns the prisms that a tet of the body's field intersects, ascending. The tet must exist.
  [[nodiscard]] std::span<const InTet> of_tet(int tet) const {
    const auto t = static_cast<std::size_t>(tet);
    return std::span(of_tets_).subspan(first_[t], first_[t + 1] - first_[t]);
  }
  /// Returns true if the table has the tet.
  [[nodiscard]] bool has(int tet) const { return tet >= 0 && static_cast<std::size_t>(tet) + 1 < first_.size(); }
  /// Calls visit(index) for a superset of the prisms that intersect a box, in no particular order.
  template <class Visit>
  void visit_near(const Aabb& box, const Visit& visit) const {
    tree_.visit([&](const Aabb& node) { return node.overlaps(box); }, visit);
  }
  [[nodiscard]] double depth() const { return depth_; }  ///< length of the rays [m]
  /// Largest error of InTet::may_reach(), to be added to the radius [m].
  [[nodiscard]] double slack() const { return slack_; }
  [[nodiscard]] double lead() const { return lead_; }  ///< the rays start this far outside of the skin [m]
  /// Returns the depth at which the ray from a point of a prism's face ends [m].
  [[nodiscard]] double end_of_ray(const RayPrism& prism, const dvec2& q) const;

 private:
  void add(const FaceFields& fields, int face);
  [[nodiscard]] InTet in_tet(std::int32_t number) const;
  void fill(const PressureField& field);

  SensorSkin skin_;
  bool soft_ = false;
  double depth_ = 0, lead_ = 0, slack_ = 0;
  std::vector<RayPrism> prisms_;
  std::vector<std::size_t> first_;  ///< the prisms of tet t are of_tets_ [first_[t], first_[t + 1])
  std::vector<InTet> of_tets_;
  Bvh tree_;
};

/// The integral over the contact polygons that is the limit of an aggregate for ever more samples.
enum class IntegralKind {
  none,
  weighted_mean,  ///< pressure_integral.h
  mean,           ///< pressure_integral.h
  force           ///< force_integral.h
};

/// All that the integrals of one model need, computed once. Immutable.
struct SkinFields {
  std::shared_ptr<const FieldWeights> weights;
  FaceFields faces;
  std::optional<NearestGuess> nearest;  ///< for IntegralKind::force
  std::optional<RayPrisms> prisms;      ///< for the other integrals
  /// Integral of the weight over the sampled part of each taxel's field, for the other integrals.
  std::vector<double> whole;
};
using SkinFieldsPtr = std::shared_ptr<const SkinFields>;

}  // namespace taxel
