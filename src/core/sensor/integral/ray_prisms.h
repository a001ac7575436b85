// The rays from whole faces of the skin: each face and its rays form a prism, from the face inward. A contact polygon
// is hit by the rays of a face where it is inside of the prism.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/hydro/hydro_body.h"
#include "core/mesh/query/bvh.h"
#include "core/sensor/integral/face_fields.h"
#include "core/sensor/sensor_cache.h"

namespace taxel {

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

}  // namespace taxel
