#include "core/mesh/repair/distances.h"

#include "core/base/parallel.h"
#include "core/mesh/closest_point.h"

namespace taxel {
namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

struct PointOnFace {
  dvec3 position;
  int face;
};

/// Points with equal area each, in the order of faces; within a face by the additive sequence of Roberts 2018 (R2),
/// folded into the triangle.
std::vector<PointOnFace> even_points(const TriMesh& mesh, int count) {
  constexpr double kR2x = 0.7548776662466927, kR2y = 0.5698402909980532;
  std::vector<PointOnFace> points;
  const double spacing = mesh.area() / count;
  double next = 0.5 * spacing, covered = 0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    covered += mesh.face_areas()[at(f)];
    for (; next < covered; next += spacing) {
      const auto i = static_cast<double>(points.size());
      double u = i * kR2x - std::floor(i * kR2x), v = i * kR2y - std::floor(i * kR2y);
      if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
      }
      const dvec3& a = mesh.vertex(f, 0);
      points.push_back({a + u * (mesh.vertex(f, 1) - a) + v * (mesh.vertex(f, 2) - a), f});
    }
  }
  return points;
}

std::vector<double> distances_to(const MeshIndex& mesh, const std::vector<PointOnFace>& points) {
  std::vector<double> distances(points.size());
  parallel_chunks(static_cast<int>(points.size()), 256, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) distances[at(i)] = mesh.closest_point(points[at(i)].position).distance;
  });
  return distances;
}

/// Whether a point of a mesh sees the outside: one of 64 rays, spread over all directions by the golden angle, leaves
/// it. Walls of cavities and walls inside of a body do not.
bool is_seen(const MeshIndex& mesh, const PointOnFace& point) {
  constexpr int kRays = 64;
  constexpr double kGoldenAngle = 2.399963229728653;
  for (int i = 0; i < kRays; ++i) {
    const double z = 1 - (2.0 * i + 1) / kRays, r = std::sqrt(1 - z * z), angle = kGoldenAngle * i;
    const dvec3 direction(r * std::cos(angle), r * std::sin(angle), z);
    if (!mesh.cast_except({point.position, direction}, point.face)) return true;
  }
  return false;
}

}  // namespace

void measure_distances(const TriMeshPtr& loaded, double edge, RepairedMesh& repaired) {
  constexpr int kPoints = 20000;
  const MeshIndex loaded_index(loaded), repaired_index(repaired.mesh);
  std::vector<double> all = distances_to(loaded_index, even_points(*repaired.mesh, kPoints));
  const std::vector<PointOnFace> on_loaded = even_points(*loaded, kPoints);
  std::vector<double> back = distances_to(repaired_index, on_loaded);
  // Only far points are worth the rays: a wall inside of the body is far from its surface.
  parallel_chunks(static_cast<int>(back.size()), 64, [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      if (back[at(i)] > edge && !is_seen(loaded_index, on_loaded[at(i)])) back[at(i)] = -1;
  });
  all.insert(all.end(), back.begin(), back.end());
  double squares = 0, count = 0;
  for (const double d : all) {
    if (d < 0) continue;
    repaired.report.distance_max = std::max(repaired.report.distance_max, d);
    squares += d * d;
    ++count;
  }
  repaired.report.distance_rms = count > 0 ? std::sqrt(squares / count) : 0;
  repaired.changes.distance.resize(repaired.mesh->vertices().size());
  parallel_chunks(repaired.mesh->vertex_count(), 256, [&](int begin, int end) {
    for (int v = begin; v < end; ++v) {
      const double d = loaded_index.closest_point(repaired.mesh->vertices()[at(v)]).distance;
      repaired.changes.distance[at(v)] = static_cast<float>(d);
    }
  });
}

}  // namespace taxel
