// The pressures at the vertices of a pad, and the error of a press.
//
// An inner vertex with one layer takes p = E depth/H with the smaller of two depths, the distance to the skin and the
// mean depth below the planes of its faces, so that the stiffness at the skin is not above E/H. With two layers the
// middle vertex does so, and the inner vertex takes the depth between the two by which the triangles of inner vertices
// approximate the distance of their centroids to the skin best: a least-squares problem, which eight rounds of
// Gauss-Seidel solve well enough. The distance itself would overshoot between the vertices.
//
// The error of a press follows 1024 points of the skin straight inward from tet to tet and compares the pressure with
// the distance to the skin. Each point is at random in its own part of the area, by a generator with a fixed seed.
// Pitfall: a line crosses each tet once, but rounding at edges could lead it in a circle, so its steps are limited.
// Theory: docs/theory/hydro.md, "Two layers" and "Field report".
#include <algorithm>
#include <array>
#include <limits>

#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/base/rng.h"
#include "core/hydro/fields/pressure_field.h"
#include "core/hydro/pad/pad_field.h"

namespace taxel {
namespace {

/// Returns the depth of each offset vector's inner vertex below the planes of its faces, as an area-weighted mean; H
/// for an offset vector without faces.
std::vector<double> mean_plane_depths(const TriMesh& mesh, const PadShape& shape, double thickness) {
  std::vector<double> area(at(shape.offset_count()), 0.0), depth(at(shape.offset_count()), 0.0);
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (int c = 0; c < 3; ++c) {
      const int offset = shape.offset(f, c);
      const double cosine = -glm::dot(mesh.face_normals()[at(f)], shape.direction(offset).direction);
      area[at(offset)] += mesh.face_areas()[at(f)];
      depth[at(offset)] += mesh.face_areas()[at(f)] * shape.length(offset) * cosine;
    }
  }
  for (std::size_t i = 0; i < depth.size(); ++i) depth[i] = area[i] > 0 ? std::max(0.0, depth[i] / area[i]) : thickness;
  return depth;
}

/// Fits the depths of inner vertices of offset vectors with a middle vertex, weighted by the area of the face above.
/// Each depth stays between its two limits.
class InnerFit {
 public:
  InnerFit(const MeshIndex& index, const PadShape& shape, const PadLayers& layers, const PadDepths& depths,
           double thickness)
      : shape_(shape), depths_(depths), depth_(depths.below_planes), rank_(depth_.size(), -1) {
    constexpr double kWorthIt = 1e-2;
    for (const int offset : layers.offsets()) {
      if (depths.below_skin[at(offset)] - depths.below_planes[at(offset)] <= kWorthIt * thickness) continue;
      rank_[at(offset)] = static_cast<int>(free_.size());
      free_.push_back({offset, {}});
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
    int next, other;     ///< offset vectors at the triangle's other corners
    double sum, weight;  ///< sum that the three depths must have [m]
  };
  struct Free {
    int offset;
    std::vector<Target> targets;
  };

  void gather(const MeshIndex& index, const PadLayers& layers, double thickness) {
    const TriMesh& mesh = index.mesh();
    for (int f = 0; f < mesh.face_count(); ++f) {
      const ivec3 offsets(shape_.offset(f, 0), shape_.offset(f, 1), shape_.offset(f, 2));
      if (rank_[at(offsets.x)] < 0 && rank_[at(offsets.y)] < 0 && rank_[at(offsets.z)] < 0) continue;
      if (layers.bare(f)) continue;
      const dvec3 centroid =
          (shape_.inner_position(offsets.x) + shape_.inner_position(offsets.y) + shape_.inner_position(offsets.z)) /
          3.0;
      const double depth = depth_inside(index, centroid, thickness);
      for (int c = 0; c < 3; ++c) {
        const int rank = rank_[at(offsets[c])];
        if (rank < 0) continue;
        free_[at(rank)].targets.push_back(
            {offsets[(c + 1) % 3], offsets[(c + 2) % 3], 3.0 * depth, mesh.face_areas()[at(f)]});
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
      depth_[at(own.offset)] =
          std::clamp(sum / weight, depths_.below_planes[at(own.offset)], depths_.below_skin[at(own.offset)]);
  }

  const PadShape& shape_;
  const PadDepths& depths_;
  std::vector<double> depth_;
  std::vector<int> rank_;  ///< index of each offset vector in free_, or -1
  std::vector<Free> free_;
};

}  // namespace

PadDepths pad_depths(const TriMesh& mesh, const PadShape& shape, double thickness) {
  PadDepths depths;
  depths.planes = mean_plane_depths(mesh, shape, thickness);
  for (int offset = 0; offset < shape.offset_count(); ++offset) {
    depths.below_skin.push_back(std::min(shape.depth(offset), thickness));
    depths.below_planes.push_back(std::min(depths.below_skin.back(), depths.planes[at(offset)]));
  }
  return depths;
}

std::vector<char> diverging_offsets(const PadDepths& depths, double thickness) {
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
  for (int offset = 0; offset < shape.offset_count(); ++offset)
    pressure.push_back(shape.length(offset) > 0 ? elastic_pressure(inner[at(offset)], thickness, modulus) : 0.0);
  for (const int offset : layers.offsets()) {
    const double planes = depths.planes[at(offset)] * layers.height(offset) / shape.length(offset);
    pressure.push_back(elastic_pressure(std::min({layers.depth(offset), planes, thickness}), thickness, modulus));
  }
  return pressure;
}

namespace {

constexpr int kPressPoints = 1024;
/// Depths of the presses in thicknesses. The last one is the depth of the core, up to rounding.
constexpr std::array<double, 4> kParts{0.1, 0.25, 0.5, 1.0};
constexpr double kRounding = 1e-9;
/// Number of depths, beginning with the first, at which the pressure is compared with the distance to the skin.
constexpr std::size_t kCompared = 2;

/// Returns the cumulative areas of the faces [m^2].
std::vector<double> areas_up_to(const PressureField& field, const std::vector<SkinFace>& faces) {
  std::vector<double> area_to;
  double area = 0;
  for (const SkinFace& face : faces) {
    const ivec4& v = field.tets()[at(face.tet)].vertices;
    const auto corner = [&](int k) { return field.vertices()[at(v[(face.corner + k) % 4])]; };
    area += 0.5 * glm::length(glm::cross(corner(2) - corner(1), corner(3) - corner(1)));
    area_to.push_back(area);
  }
  return area_to;
}

/// Returns a point uniformly distributed over a face.
dvec3 random_point(const PressureField& field, const SkinFace& face, double u, double v) {
  const ivec4& vertices = field.tets()[at(face.tet)].vertices;
  const auto corner = [&](int k) { return field.vertices()[at(vertices[(face.corner + k) % 4])]; };
  const double root = std::sqrt(u);
  return (1 - root) * corner(1) + root * (1 - v) * corner(2) + root * v * corner(3);
}

}  // namespace

std::vector<SkinFace> skin_faces(const PressureField& field) {
  std::vector<SkinFace> faces;
  for (int t = 0; t < static_cast<int>(field.tets().size()); ++t) {
    for (int i = 0; i < 4; ++i) {
      if (field.is_skin(field.tets()[at(t)], i)) faces.push_back({t, i});
    }
  }
  return faces;
}

void pressures_below(const PressureField& field, const SkinFace& face, const dvec3& x, std::span<const double> depths,
                     std::span<double> pressures) {
  std::fill(pressures.begin(), pressures.end(), -1.0);
  const dvec3 inward = field.tets()[at(face.tet)].normal[at(face.corner)];
  std::size_t next = 0;
  // A line crosses each tet once; rounding at edges must not lead it round in a circle.
  int t = face.tet, entry = face.corner;
  for (std::size_t steps = 0; t >= 0 && steps < field.tets().size(); ++steps) {
    const Tet& tet = field.tets()[at(t)];
    double leaves = std::numeric_limits<double>::infinity();
    int exit = -1;
    for (int i = 0; i < 4; ++i) {
      const double along = glm::dot(tet.normal[at(i)], inward);
      if (i == entry || !(along < 0)) continue;
      const double s = -(glm::dot(tet.normal[at(i)], x) + tet.offset[at(i)]) / along;
      if (s >= leaves) continue;
      leaves = s;
      exit = i;
    }
    for (; next < depths.size() && depths[next] <= leaves; ++next) {
      pressures[next] = std::max(0.0, glm::dot(tet.gradient, x + depths[next] * inward) + tet.constant);
    }
    if (next == depths.size() || exit < 0 || tet.neighbour[exit] < 0) break;
    const ivec4& back = field.tets()[at(tet.neighbour[exit])].neighbour;
    for (int i = 0; i < 4; ++i) entry = back[i] == t ? i : entry;
    t = tet.neighbour[exit];
  }
}

std::vector<FieldReport::PressError> press_errors(const MeshIndex& index, const PressureField& field, double modulus,
                                                  double thickness) {
  const std::vector<SkinFace> faces = skin_faces(field);
  if (faces.empty()) return {};
  const std::vector<double> area_to = areas_up_to(field, faces);
  const double covered = area_to.back() / index.mesh().area();
  std::array<double, kParts.size()> depths{};
  for (std::size_t k = 0; k < depths.size(); ++k) depths[k] = kParts[k] * thickness * (1 - kRounding);
  const CounterRng rng(2);
  struct Felt {
    std::array<double, kParts.size()> pressure;
    std::array<double, kCompared> ratio;  ///< pressure over E depth/H; 0 if the point is left out
  };
  std::vector<Felt> felt(kPressPoints);
  constexpr int kChunk = 64;
  parallel_chunks(kPressPoints, kChunk, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const auto n = 3 * static_cast<std::uint64_t>(i);
      const double share = (i + rng.uniform(n)) / kPressPoints * area_to.back();
      const auto found = std::upper_bound(area_to.begin(), area_to.end() - 1, share);
      const SkinFace& face = faces[static_cast<std::size_t>(found - area_to.begin())];
      const dvec3 x = random_point(field, face, rng.uniform(n + 1), rng.uniform(n + 2));
      Felt& own = felt[at(i)];
      pressures_below(field, face, x, depths, own.pressure);
      for (std::size_t k = 0; k < kCompared; ++k) {
        own.ratio[k] = 0;
        if (own.pressure[k] < 0) continue;
        const dvec3 y = x + depths[k] * field.tets()[at(face.tet)].normal[at(face.corner)];
        const double depth = depth_inside(index, y, depths[k]);
        if (depth >= 0.5 * depths[k]) own.ratio[k] = own.pressure[k] * thickness / (modulus * depth);
      }
    }
  });
  std::vector<FieldReport::PressError> errors;
  for (std::size_t k = 0; k < kParts.size(); ++k) {
    FieldReport::PressError error;
    error.part = kParts[k];
    double count = 0, sum = 0, squares = 0, reached = 0;
    for (const Felt& own : felt) {
      reached += own.pressure[k] >= 0 ? 1 : 0;
      if (k >= kCompared || own.ratio[k] == 0) continue;
      count += 1;
      sum += own.ratio[k];
      squares += own.ratio[k] * own.ratio[k];
    }
    error.without_tets = std::max(0.0, 1 - covered * reached / kPressPoints);
    if (count > 0) {
      error.mean = sum / count;
      error.deviation = std::sqrt(std::max(0.0, squares / count - error.mean * error.mean));
    }
    errors.push_back(error);
  }
  return errors;
}

}  // namespace taxel
