#include "core/hydro/pad/pad_pressures.h"

#include <algorithm>

#include "core/base/index.h"
#include "core/hydro/elastic_pressure.h"

namespace taxel {
namespace {

/// Returns the depth of each leg's inner vertex below the planes of its faces, as an area-weighted mean; H for a leg
/// without faces.
std::vector<double> mean_plane_depths(const TriMesh& mesh, const PadShape& shape, double thickness) {
  std::vector<double> area(at(shape.leg_count()), 0.0), depth(at(shape.leg_count()), 0.0);
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (int c = 0; c < 3; ++c) {
      const int leg = shape.leg(f, c);
      const double cosine = -glm::dot(mesh.face_normals()[at(f)], shape.direction(leg).direction);
      area[at(leg)] += mesh.face_areas()[at(f)];
      depth[at(leg)] += mesh.face_areas()[at(f)] * shape.offset(leg) * cosine;
    }
  }
  for (std::size_t i = 0; i < depth.size(); ++i) depth[i] = area[i] > 0 ? std::max(0.0, depth[i] / area[i]) : thickness;
  return depth;
}

/// Fits the depths of inner vertices of legs with a middle vertex, so that the mean depth of each triangle of inner
/// vertices is the distance of its centroid to the skin, at most H. Solves the least-squares problem, weighted by the
/// area of the face above, by Gauss-Seidel iteration. Each depth stays between its two limits.
class InnerFit {
 public:
  InnerFit(const MeshIndex& index, const PadShape& shape, const PadLayers& layers, const PadDepths& depths,
           double thickness)
      : shape_(shape), depths_(depths), depth_(depths.below_planes), rank_(depth_.size(), -1) {
    constexpr double kWorthIt = 1e-2;
    for (const int leg : layers.legs()) {
      if (depths.below_skin[at(leg)] - depths.below_planes[at(leg)] <= kWorthIt * thickness) continue;
      rank_[at(leg)] = static_cast<int>(free_.size());
      free_.push_back({leg, {}});
    }
    if (!free_.empty()) gather(index, layers, thickness);
  }

  std::vector<double> solve() {
    constexpr int kRounds = 8;  // a third of each triangle's mean is its own: errors shrink by half and more
    for (int round = 0; round < kRounds; ++round) {
      for (const Free& own : free_) improve(own);
    }
    return std::move(depth_);
  }

 private:
  struct Target {
    int next, other;     ///< legs at the triangle's other corners
    double sum, weight;  ///< sum that the three depths must have [m]
  };
  struct Free {
    int leg;
    std::vector<Target> targets;
  };

  void gather(const MeshIndex& index, const PadLayers& layers, double thickness) {
    const TriMesh& mesh = index.mesh();
    for (int f = 0; f < mesh.face_count(); ++f) {
      const ivec3 legs(shape_.leg(f, 0), shape_.leg(f, 1), shape_.leg(f, 2));
      if (rank_[at(legs.x)] < 0 && rank_[at(legs.y)] < 0 && rank_[at(legs.z)] < 0) continue;
      if (layers.bare(f)) continue;
      const dvec3 centroid =
          (shape_.inner_position(legs.x) + shape_.inner_position(legs.y) + shape_.inner_position(legs.z)) / 3.0;
      const double depth = depth_inside(index, centroid, thickness);
      for (int c = 0; c < 3; ++c) {
        const int rank = rank_[at(legs[c])];
        if (rank < 0) continue;
        free_[at(rank)].targets.push_back(
            {legs[(c + 1) % 3], legs[(c + 2) % 3], 3.0 * depth, mesh.face_areas()[at(f)]});
      }
    }
  }

  void improve(const Free& own) {
    double weight = 0, sum = 0;
    for (const Target& target : own.targets) {
      weight += target.weight;
      sum += target.weight * (target.sum - depth_[at(target.next)] - depth_[at(target.other)]);
    }
    if (weight > 0)
      depth_[at(own.leg)] =
          std::clamp(sum / weight, depths_.below_planes[at(own.leg)], depths_.below_skin[at(own.leg)]);
  }

  const PadShape& shape_;
  const PadDepths& depths_;
  std::vector<double> depth_;
  std::vector<int> rank_;  ///< per leg: its place in free_, -1 where it has none
  std::vector<Free> free_;
};

}  // namespace

double depth_inside(const MeshIndex& index, const dvec3& x, double most) {
  const SignedPoint skin = index.signed_point(x, most);
  return skin.point.face < 0 ? most : std::clamp(-skin.signed_distance, 0.0, most);
}

bool is_nearest_skin(const MeshIndex& index, const dvec3& x, double distance) {
  constexpr double kNearest = 0.97;
  return depth_inside(index, x, distance) >= kNearest * distance;
}

PadDepths pad_depths(const TriMesh& mesh, const PadShape& shape, double thickness) {
  PadDepths depths;
  depths.planes = mean_plane_depths(mesh, shape, thickness);
  for (int leg = 0; leg < shape.leg_count(); ++leg) {
    depths.below_skin.push_back(std::min(shape.depth(leg), thickness));
    depths.below_planes.push_back(std::min(depths.below_skin.back(), depths.planes[at(leg)]));
  }
  return depths;
}

std::vector<char> diverging_legs(const PadDepths& depths, double thickness) {
  constexpr double kDiverging = 0.1;
  std::vector<char> diverging(depths.planes.size());
  for (std::size_t i = 0; i < diverging.size(); ++i)
    diverging[i] = depths.below_skin[i] - depths.below_planes[i] > kDiverging * thickness ? 1 : 0;
  return diverging;
}

std::vector<double> pad_pressures(const MeshIndex& index, const PadShape& shape, const PadLayers& layers,
                                  const PadDepths& depths, double modulus, double thickness) {
  const std::vector<double> inner = InnerFit(index, shape, layers, depths, thickness).solve();
  std::vector<double> pressure(index.mesh().vertices().size(), 0.0);
  for (int leg = 0; leg < shape.leg_count(); ++leg)
    pressure.push_back(shape.offset(leg) > 0 ? elastic_pressure(inner[at(leg)], thickness, modulus) : 0.0);
  for (const int leg : layers.legs()) {
    const double planes = depths.planes[at(leg)] * layers.height(leg) / shape.offset(leg);
    pressure.push_back(elastic_pressure(std::min({layers.depth(leg), planes, thickness}), thickness, modulus));
  }
  return pressure;
}

}  // namespace taxel
