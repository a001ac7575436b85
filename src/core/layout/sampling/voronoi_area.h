// Voronoi cells of the samples on a surface, and convex polygons in the plane, which half-planes clip to cells.
#pragma once

#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "core/base/math.h"
#include "core/layout/sampling/surface_sample.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// A convex polygon, counter-clockwise. Reuses its memory.
class ConvexPolygon {
 public:
  void assign(std::span<const dvec2> corners) { corners_.assign(corners.begin(), corners.end()); }
  [[nodiscard]] bool empty() const { return corners_.size() < 3; }
  [[nodiscard]] const std::vector<dvec2>& corners() const { return corners_; }

  /// Keeps the part where dot(normal, x) + offset <= 0 (Sutherland, Hodgman 1974).
  void cut(const dvec2& normal, double offset) {
    sides_.resize(corners_.size());
    double farthest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      sides_[i] = glm::dot(normal, corners_[i]) + offset;
      farthest = std::max(farthest, sides_[i]);
    }
    if (!(farthest > 0.0)) return;
    kept_.clear();
    for (std::size_t i = 0, from = corners_.size() - 1; i < corners_.size(); from = i++) {
      const double a = sides_[from], b = sides_[i];
      if ((a <= 0.0) != (b <= 0.0)) kept_.push_back(corners_[from] + (corners_[i] - corners_[from]) * (a / (a - b)));
      if (b <= 0.0) kept_.push_back(corners_[i]);
    }
    corners_.swap(kept_);
  }

  [[nodiscard]] double area() const {
    double twice = 0.0;
    for (std::size_t i = 1; i + 1 < corners_.size(); ++i) twice += twice_area(i);
    return 0.5 * twice;
  }
  /// Returns the area of the triangle of the first corner and the corners i and i + 1.
  [[nodiscard]] double triangle_area(int i) const { return 0.5 * twice_area(static_cast<std::size_t>(i)); }
  /// Returns the centroid. The polygon must have an area.
  [[nodiscard]] dvec2 centroid() const {
    double twice = 0.0;
    dvec2 sum(0);
    for (std::size_t i = 1; i + 1 < corners_.size(); ++i) {
      const double part = twice_area(i);
      twice += part;
      sum += part * (corners_[i] + corners_[i + 1] - 2.0 * corners_[0]);
    }
    return corners_[0] + sum / (3.0 * twice);
  }
  /// Returns the squared distance of the corner farthest from the origin.
  [[nodiscard]] double squared_reach() const {
    double farthest = 0.0;
    for (const dvec2& c : corners_) farthest = std::max(farthest, glm::dot(c, c));
    return farthest;
  }

 private:
  /// Returns twice the area of the triangle of the first corner and the corners i and i + 1.
  [[nodiscard]] double twice_area(std::size_t i) const {
    const dvec2 a = corners_[i] - corners_[0], b = corners_[i + 1] - corners_[0];
    return a.x * b.y - a.y * b.x;
  }

  std::vector<dvec2> corners_, kept_;
  std::vector<double> sides_;
};

/// Fills SurfaceSample::area with the area of the sample's Voronoi cell on the surface: the part of the mesh that is
/// nearer to this sample than to any other sample of the same wall (or of any wall, if the wall has no sample nearby).
/// Faces are clipped exactly along the bisecting planes, so the sum of the areas is the area of the mesh. `samples`
/// must not be empty.
void assign_voronoi_areas(const TriMesh& mesh, std::vector<SurfaceSample>& samples);

/// Returns for each point the index of the sample whose Voronoi cell it is in: the nearest sample of the same wall (of
/// any wall, if no sample is on the same wall within 4 spacings). `spacing` is about that of the samples [m]. `samples`
/// must not be empty.
std::vector<int> cells_of(std::span<const SurfaceSample> points, const std::vector<SurfaceSample>& samples,
                          double spacing);

/// Returns the parts of `mesh` in the Voronoi cells of the samples for which `is_wanted` is true, as triangles that do
/// not share vertices. `spacing` is about that of the samples [m].
TriMesh surface_of_cells(const TriMesh& mesh, const std::vector<SurfaceSample>& samples,
                         const std::vector<bool>& is_wanted, double spacing);

}  // namespace taxel
