#include "core/mesh/repair/wrap/distances.h"

#include "core/base/index.h"
#include "core/base/parallel.h"
#include "core/mesh/query/nearest_in_turn.h"
#include "core/mesh/query/ray_triangle.h"

namespace taxel {
namespace {

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

/// Distances from points to a mesh.
struct Distances {
  std::vector<double> value;  ///< distance of each point [m], or -1 if left out
  std::vector<int> face;      ///< nearest face of the mesh
};

Distances distances_to(const MeshIndex& mesh, const std::vector<PointOnFace>& points) {
  Distances distances{std::vector<double>(points.size()), std::vector<int>(points.size())};
  parallel_chunks(static_cast<int>(points.size()), 256, [&](int begin, int end) {
    NearestInTurn nearest(mesh);
    for (int i = begin; i < end; ++i) {
      const SurfacePoint point = nearest.closest_point(points[at(i)].position);
      distances.value[at(i)] = point.distance;
      distances.face[at(i)] = point.face;
    }
  });
  return distances;
}

/// Finds points of a mesh that see the outside: one of 64 rays, spread over all directions by the golden angle, leaves
/// it. Walls of cavities and walls inside of a body do not. Most rays hit a face near the one that they hit from the
/// point before, so a few steps over the mesh find one faster than the tree; any hit has the same answer. Each thread
/// needs its own.
class OutsideView {
 public:
  explicit OutsideView(const MeshIndex& mesh) : mesh_(mesh) {
    constexpr double kGoldenAngle = 2.399963229728653;
    for (int i = 0; i < kRays; ++i) {
      const double z = 1 - (2.0 * i + 1) / kRays, r = std::sqrt(1 - z * z), angle = kGoldenAngle * i;
      directions_[at(i)] = dvec3(r * std::cos(angle), r * std::sin(angle), z);
    }
    blockers_.fill(-1);
  }

  bool is_seen(const PointOnFace& point) {
    if (leaves(point, free_ray_)) return true;
    for (int i = 0; i < kRays; ++i) {
      if (i == free_ray_ || !leaves(point, i)) continue;
      free_ray_ = i;
      return true;
    }
    return false;
  }

 private:
  bool leaves(const PointOnFace& point, int number) {
    constexpr double kNothingNearer = -1;
    const Ray ray{point.position, directions_[at(number)]};
    const RayTriangleTest test(ray);
    const auto is_hit = [&](int face, double t_max) {
      const TriMesh& mesh = mesh_.mesh();
      return face != point.face && test(mesh.vertex(face, 0), mesh.vertex(face, 1), mesh.vertex(face, 2), t_max);
    };
    int& blocker = blockers_[at(number)];
    for (int step = 0; step < kSteps && blocker >= 0; ++step) {
      if (is_hit(blocker, ray.t_max)) return false;
      blocker = step_towards(ray, blocker);
    }
    blocker = -1;
    mesh_.tree().cast(ray, [&](int face, double t_max) {
      if (blocker < 0 && is_hit(face, t_max)) blocker = face;
      return blocker < 0 ? t_max : kNothingNearer;
    });
    return blocker < 0;
  }

  /// The face across the edge that the line of a ray passes farthest outside of, or -1.
  [[nodiscard]] int step_towards(const Ray& ray, int face) const {
    const TriMesh& mesh = mesh_.mesh();
    const dvec3 a = mesh.vertex(face, 0) - ray.origin, b = mesh.vertex(face, 1) - ray.origin,
                c = mesh.vertex(face, 2) - ray.origin;
    // Volumes of the tets of the line with the edges a b, b c and c a: of one sign if the line goes through the face.
    dvec3 volumes(glm::dot(ray.direction, glm::cross(a, b)), glm::dot(ray.direction, glm::cross(b, c)),
                  glm::dot(ray.direction, glm::cross(c, a)));
    if (volumes.x + volumes.y + volumes.z < 0) volumes = -volumes;
    const int edge = volumes.x < volumes.y ? (volumes.x < volumes.z ? 0 : 2) : (volumes.y < volumes.z ? 1 : 2);
    return volumes[edge] < 0 ? mesh.topology().face_across(3 * face + edge) : -1;
  }

  static constexpr int kRays = 64, kSteps = 24;
  const MeshIndex& mesh_;
  std::array<dvec3, kRays> directions_;
  std::array<int, kRays> blockers_;  ///< face that each ray hit from the last point, or -1
  int free_ray_ = 0;                 ///< ray that left the mesh from the last point that sees the outside
};

/// The largest distance of a face's points, at each of its corners. The corners of a wrap are on the loaded faces
/// themselves, so distances from them alone would be 0 or rounding.
class DistanceOfVertices {
 public:
  explicit DistanceOfVertices(const TriMesh& mesh) : mesh_(mesh), distance_(mesh.vertices().size(), 0) {}
  void include(int face, double distance) {
    for (int c = 0; c < 3; ++c) {
      float& largest = distance_[at(mesh_.faces()[at(face)][c])];
      largest = std::max(largest, static_cast<float>(distance));
    }
  }
  [[nodiscard]] std::vector<float> take() { return std::move(distance_); }

 private:
  const TriMesh& mesh_;
  std::vector<float> distance_;
};

}  // namespace

void measure_distances(const MeshIndex& loaded, double edge, RepairedMesh& repaired) {
  constexpr int kPoints = 20000;
  const MeshIndex repaired_index(repaired.mesh);
  const std::vector<PointOnFace> on_repaired = even_points(*repaired.mesh, kPoints);
  const Distances forward = distances_to(loaded, on_repaired);
  const std::vector<PointOnFace> on_loaded = even_points(loaded.mesh(), kPoints);
  Distances back = distances_to(repaired_index, on_loaded);
  // Only far points are worth the rays: a wall inside of the body is far from its surface.
  parallel_chunks(static_cast<int>(on_loaded.size()), 256, [&](int begin, int end) {
    OutsideView outside(loaded);
    for (int i = begin; i < end; ++i)
      if (back.value[at(i)] > edge && !outside.is_seen(on_loaded[at(i)])) back.value[at(i)] = -1;
  });
  double squares = 0, count = 0;
  DistanceOfVertices of_vertices(*repaired.mesh);
  const auto include = [&](double d, int repaired_face) {
    if (d < 0) return;
    repaired.report.distance_max = std::max(repaired.report.distance_max, d);
    squares += d * d;
    ++count;
    of_vertices.include(repaired_face, d);
  };
  for (std::size_t i = 0; i < on_repaired.size(); ++i) include(forward.value[i], on_repaired[i].face);
  for (std::size_t i = 0; i < on_loaded.size(); ++i) include(back.value[i], back.face[i]);
  repaired.report.distance_rms = count > 0 ? std::sqrt(squares / count) : 0;
  repaired.changes.distance = of_vertices.take();
}

}  // namespace taxel
