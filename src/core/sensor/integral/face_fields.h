// The receptive fields on the faces of the sensed skin, in the plane of each face. Readings that are integrals compute
// weights at thousands of points in each step, so all that depends on the face alone is computed once.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/layout/field/field_weights.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

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

}  // namespace taxel
