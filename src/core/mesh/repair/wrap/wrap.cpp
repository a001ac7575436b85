#include "core/mesh/repair/wrap/wrap.h"

#include <fmt/format.h>

#include <cmath>

#include "core/mesh/make/level_set.h"
#include "core/mesh/repair/steps/cut_crossings.h"
#include "core/mesh/repair/steps/shells.h"
#include "core/mesh/repair/steps/solid.h"
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

}  // namespace taxel
