// A level set around faces, moved onto them and simplified, and distances between the surfaces.
//
// 1. The signed distance of wrap_field.cpp is polygonised on a grid of tets, on which no faces cross; cavities and
//    small parts are dropped.
// 2. Points within half an edge of the faces move onto them, unless a face would turn by more than 60 degrees or lose
//    nine tenths of its area. Points of faces that cross then move back.
// 3. Manifold simplifies the surface within the tolerance; new crossings are cut out, or the surface is simplified
//    less.
//
// Everything is computed in a frame in which the box of the faces has the diagonal 1, with points rounded to 2^-30 and
// lengths to 24 bits, so that the result does not depend on the unit of the file. Distances are measured from 20000
// points spread evenly over each surface to the other; far points of the loaded faces that do not see the outside are
// walls inside of the body and do not count. Cost: the cube of the diagonal over the edge for the grid, though only
// cells near faces are expensive.
#include "core/mesh/repair/wrap/wrap.h"

#include <fmt/format.h>
#include <manifold/manifold.h>

#include <cmath>

#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/mesh/make/level_set.h"
#include "core/mesh/query/nearest.h"
#include "core/mesh/query/triangle.h"
#include "core/mesh/repair/steps.h"
#include "core/mesh/repair/topology.h"

namespace taxel {
namespace {

constexpr double kGridEdge = 0.9;  // of the edge: a wrap has longer ones across the cubes of its grid

/// Coordinates in which the box of some points has the diagonal 1.
class UnitFrame {
 public:
  explicit UnitFrame(const std::vector<dvec3>& points) {
    Aabb box;
    for (const dvec3& p : points) box.include(p);
    origin_ = box.lo;
    length_ = box.diagonal();
  }
  /// Rounded to 2^-30, which is finer than any wrap: the roundings of the file's unit do not reach the result.
  [[nodiscard]] dvec3 into(const dvec3& p) const {
    constexpr double kSteps = 1 << 30;
    return glm::round((p - origin_) / length_ * kSteps) / kSteps;
  }
  [[nodiscard]] dvec3 out_of(const dvec3& p) const { return origin_ + length_ * p; }
  [[nodiscard]] RepairLimits into(RepairLimits limits) const {
    for (double* length : {&limits.edge, &limits.tolerance, &limits.thickness}) *length = rounded(*length / length_);
    return limits;
  }

 private:
  /// Rounds to 24 bits. GCC 12 leaves conversions to float and back out of a loop that it vectorises.
  static double rounded(double x) {
    constexpr int kBits = 24;
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    return std::ldexp(std::round(std::ldexp(mantissa, kBits)), exponent - kBits);
  }

  dvec3 origin_{0};
  double length_ = 1;
};

/// All faces of a draft in the frame.
Draft into_frame(const Draft& draft, const UnitFrame& frame) {
  Draft moved = draft;
  for (dvec3& p : moved.points) p = frame.into(p);
  return moved;
}

/// The faces of positive area.
std::vector<int> faces_with_area(const Draft& draft) {
  std::vector<int> found;
  for (int f = 0; f < draft.face_count(); ++f)
    if (draft.area(f) > 0) found.push_back(f);
  return found;
}

/// The outer shells of the field's level set: its largest one, and others that are not much smaller than a few edges.
/// Inner ones are cavities that nothing outside reaches.
Draft outer_shells(const WrapField& field, double edge, Progress* progress) {
  constexpr double kMinEdges = 4;
  const auto value = [&](const dvec3& p) {
    if (progress != nullptr) progress->stop_if_cancelled();
    return field(p);
  };
  const TriMesh level_set = make_level_set(value, field.bounds(), kGridEdge * edge, EdgeZero::linear);
  Draft draft{level_set.vertices(), level_set.faces(), std::vector<int>(level_set.faces().size(), kWrappedFace)};
  const FaceShells shells = find_shells(draft);
  std::vector<double> volumes;
  for (const std::vector<int>& shell : shells.faces) volumes.push_back(volume_of(draft, shell));
  if (volumes.empty()) return draft;
  const double least = std::min(std::pow(kMinEdges * edge, 3), *std::max_element(volumes.begin(), volumes.end()));
  std::vector<char> removed(draft.faces.size(), 0);
  for (int f = 0; f < draft.face_count(); ++f) removed[at(f)] = volumes[at(shells.of_face[at(f)])] < least ? 1 : 0;
  remove_faces(draft, removed);
  drop_unused_points(draft);
  return draft;
}

/// Moves each point to the closest point of the faces if that is nearer than half an edge, turns no face at the point
/// by more than 60 degrees and leaves each a tenth of its area.
void snap_to_faces(Draft& draft, const MeshIndex& faces, double edge) {
  constexpr double kLeastCosine = 0.5, kLeastArea = 0.1;
  const Topology topology = make_topology(draft, twin_pairs(draft.edges()));
  std::vector<dvec3> area_normals;
  for (int f = 0; f < draft.face_count(); ++f) area_normals.push_back(draft.area_normal(f));
  for (const OpenMesh::SmartVertexHandle v : topology.mesh.vertices()) {
    dvec3& point = draft.points[at(topology.vertex_of[at(v.idx())])];
    const SurfacePoint nearest = faces.closest_point(point, 0.5 * edge);
    if (nearest.face < 0) continue;
    const dvec3 before = point;
    point = nearest.position;
    for (const OpenMesh::FaceHandle f : topology.mesh.vf_range(v)) {
      const dvec3 normal = draft.area_normal(f.idx()), &first = area_normals[at(f.idx())];
      const double area = glm::length(normal), first_area = glm::length(first);
      if (area >= kLeastArea * first_area && glm::dot(normal, first) >= kLeastCosine * area * first_area) continue;
      point = before;
      break;
    }
  }
}

/// Moves the points of faces that cross each other back to the lattice, whose faces do not cross.
void move_crossing_back(Draft& wrapped, const Draft& lattice) {
  std::vector<char> changed(wrapped.faces.size(), 1), moved(wrapped.points.size(), 0);
  while (true) {
    const std::vector<std::pair<int, int>> pairs = find_crossing_pairs(wrapped, changed);
    bool has_moved = false;
    for (const auto& [f, g] : pairs) {
      for (const int face : {f, g}) {
        for (int c = 0; c < 3; ++c) {
          const int point = wrapped.faces[at(face)][c];
          if (wrapped.points[at(point)] == lattice.points[at(point)]) continue;
          wrapped.points[at(point)] = lattice.points[at(point)];
          moved[at(point)] = 1;
          has_moved = true;
        }
      }
    }
    if (!has_moved) return;
    for (int f = 0; f < wrapped.face_count(); ++f) {
      const ivec3& face = wrapped.faces[at(f)];
      changed[at(f)] = moved[at(face.x)] | moved[at(face.y)] | moved[at(face.z)];
    }
  }
}

/// Fewer faces within `tolerance`. Faces that the simplification has led through each other are cut out; a mesh in
/// which more than a few pairs, or more than those of the source, remain is simplified less.
Draft simplify(const Draft& wrapped, int source_pairs, const RepairLimits& limits) {
  std::vector<int> all(wrapped.faces.size());
  for (std::size_t f = 0; f < all.size(); ++f) all[f] = static_cast<int>(f);
  const manifold::Manifold solid = make_solid(wrapped, all, SolidFaces::mergeable);
  constexpr std::size_t kHopeless = 20;  // times the allowed pairs
  for (const double part : {1.0, 0.2}) {
    Draft simple;
    append_wrapped(simple, solid.Simplify(part * limits.tolerance));
    RepairStep unused;
    if (simple.faces.empty()) continue;
    const std::vector<std::pair<int, int>> pairs = find_crossing_pairs(simple);
    const std::size_t allowed = at(std::min(source_pairs, few_pairs(simple.face_count())));
    if (pairs.size() > kHopeless * at(few_pairs(simple.face_count()))) continue;
    if (pairs.size() > allowed && !cut_crossings(simple, pairs, allowed, limits, unused)) continue;
    simple.loaded.assign(simple.faces.size(), kWrappedFace);
    return simple;
  }
  return wrapped;
}

/// Throws Error if the grid of the level set would be too large.
void check_grid(const Draft& source, const RepairLimits& limits) {
  constexpr double kMaxNodes = 5e7;
  Aabb box;
  for (const dvec3& p : source.points) box.include(p);
  const dvec3 cells = box.extent() / (kGridEdge * limits.edge) + 8.0;
  const double nodes = cells.x * cells.y * cells.z;
  if (nodes <= kMaxNodes) return;
  throw Error("", "/mesh/repair/edge",
              fmt::format("must be at least {:.2g} to wrap a mesh of this size, is {}",
                          1.1 * limits.edge * std::cbrt(nodes / kMaxNodes), limits.edge));
}

}  // namespace

void wrap_faces(Draft& result, const Draft& source, WrapKind kind, const RepairLimits& limits, Progress* progress) {
  check_grid(source, limits);
  const UnitFrame frame(source.points);
  const Draft local = into_frame(source, frame);
  const RepairLimits lengths = frame.into(limits);
  const std::vector<int> sound = faces_with_area(local);
  if (sound.empty()) return;
  const WrapField field(local, sound, kind, lengths);
  const Draft lattice = outer_shells(field, lengths.edge, progress);
  if (lattice.faces.empty()) return;
  Draft wrapped = lattice;
  snap_to_faces(wrapped, field.faces(), lengths.edge);
  move_crossing_back(wrapped, lattice);
  Draft simple = simplify(wrapped, field.crossing_count(), lengths);
  for (dvec3& p : simple.points) p = frame.out_of(p);
  append(result, simple);
}

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
