// Taxels spread over a region of the skin as far apart as possible, along the surface.
//
// Farthest-point sampling (Gonzalez 1985): of many candidates, each next taxel is the one with the largest distance to
// the nearest taxel so far. The least distance is at least half of the best that any choice among the candidates can
// have. The candidates are a pool in which each part of equal area has one point (surface_sample.h); the first taxel is
// a random one of them.
//
// Distances are exact paths on the whole skin. Paths from a new taxel end at the largest distance that any candidate
// has, since farther ones cannot become nearer, so later taxels cost less and less. Pitfall: a candidate is placed on
// its own face, because another sheet may touch the skin there.
#include "core/layout/generators/geodesic_spread.h"

#include <fmt/format.h>

#include <numeric>

#include "core/base/rng.h"
#include "core/layout/generators/place.h"
#include "core/layout/sampling/surface_sample.h"
#include "core/mesh/geodesic.h"
#include "core/mesh/query/triangle.h"

namespace taxel {
namespace {

constexpr int kMaxCandidates = 1'000'000;

/// Returns the region's faces in ascending order. Throws Error for an invalid or repeated face.
std::vector<int> region_faces(const Spread& spread, const TriMesh& mesh) {
  std::vector<int> faces = spread.faces;
  if (faces.empty()) {
    faces.resize(static_cast<std::size_t>(mesh.face_count()));
    std::iota(faces.begin(), faces.end(), 0);
    return faces;
  }
  std::sort(faces.begin(), faces.end());
  if (faces.front() < 0 || faces.back() >= mesh.face_count())
    throw Error("geodesic spread", "faces",
                fmt::format("{} is not a face of the mesh, which has {} faces",
                            faces.front() < 0 ? faces.front() : faces.back(), mesh.face_count()));
  const auto twice = std::adjacent_find(faces.begin(), faces.end());
  if (twice != faces.end()) throw Error("geodesic spread", "faces", fmt::format("{} is listed twice", *twice));
  return faces;
}

/// Returns the faces as a separate mesh, in the same order.
TriMesh part_of(const TriMesh& mesh, const std::vector<int>& faces) {
  std::vector<int> new_index(static_cast<std::size_t>(mesh.vertex_count()), -1);
  std::vector<dvec3> vertices;
  std::vector<ivec3> corners;
  for (const int face : faces) {
    ivec3 f = mesh.faces()[static_cast<std::size_t>(face)];
    for (int c = 0; c < 3; ++c) {
      int& index = new_index[static_cast<std::size_t>(f[c])];
      if (index < 0) {
        index = static_cast<int>(vertices.size());
        vertices.push_back(mesh.vertices()[static_cast<std::size_t>(f[c])]);
      }
      f[c] = index;
    }
    corners.push_back(f);
  }
  return {std::move(vertices), std::move(corners)};
}

int candidate_count(const Spread& spread) {
  require_count("geodesic spread", "count", spread.count);
  require_positive("geodesic spread", "radius", spread.radius);
  const int per_taxel = 30, at_least = 2000;
  if (spread.candidates == 0) return std::min(kMaxCandidates, std::max(at_least, per_taxel * spread.count));
  if (spread.candidates < 0 || spread.candidates > kMaxCandidates)
    throw Error("geodesic spread", "candidates",
                fmt::format("must be 0 to {}, is {}", kMaxCandidates, spread.candidates));
  if (spread.count > spread.candidates)
    throw Error("geodesic spread", "count",
                fmt::format("{} taxels are more than the {} candidate points", spread.count, spread.candidates));
  return spread.candidates;
}

/// Candidates, and the distance of each from the nearest chosen taxel.
class FarthestPoints {
 public:
  FarthestPoints(const MeshIndex& skin, SurfacePool pool)
      : pool_(std::move(pool)),
        geodesic_(std::make_shared<UnfoldedMesh>(skin.mesh_ptr())),
        distances_(static_cast<std::size_t>(pool_.size()), std::numeric_limits<double>::infinity()),
        on_face_(static_cast<std::size_t>(skin.mesh().face_count())) {
    for (int i = 0; i < pool_.size(); ++i)
      on_face_[static_cast<std::size_t>(pool_.faces[static_cast<std::size_t>(i)])].push_back(i);
  }

  /// Returns the candidate that is farthest from all chosen taxels, the lowest index among equals.
  [[nodiscard]] int farthest() const {
    return static_cast<int>(std::max_element(distances_.begin(), distances_.end()) - distances_.begin());
  }
  [[nodiscard]] double distance(int candidate) const { return distances_[static_cast<std::size_t>(candidate)]; }

  /// Returns the place of a candidate on its own face, because another sheet may touch the skin there.
  [[nodiscard]] SurfacePoint place(int candidate, const TriMesh& mesh) const {
    const int face = pool_.faces[static_cast<std::size_t>(candidate)];
    const TrianglePoint nearest = nearest_on_triangle(pool_.positions[static_cast<std::size_t>(candidate)],
                                                      mesh.vertex(face, 0), mesh.vertex(face, 1), mesh.vertex(face, 2));
    return {nearest.position, face, nearest.barycentric, 0.0};
  }

  /// Paths end at `reach`, the largest distance so far: farther candidates cannot become nearer.
  void choose(int candidate, double reach) {
    const auto chosen = static_cast<std::size_t>(candidate);
    geodesic_.propagate(pool_.faces[chosen], pool_.positions[chosen], reach);
    for (const int face : geodesic_.reached_faces()) {
      for (const int i : on_face_[static_cast<std::size_t>(face)]) {
        const auto at = static_cast<std::size_t>(i);
        distances_[at] = std::min(distances_[at], geodesic_.to(face, pool_.positions[at]));
      }
    }
    distances_[chosen] = 0.0;
  }

 private:
  SurfacePool pool_;
  GeodesicDistance geodesic_;
  std::vector<double> distances_;
  std::vector<std::vector<int>> on_face_;
};

}  // namespace

SpreadTaxels geodesic_spread(const Spread& spread, const MeshIndex& skin, Progress* progress) {
  const int candidates = candidate_count(spread);
  const TriMesh& mesh = skin.mesh();
  const std::vector<int> faces = region_faces(spread, mesh);
  SurfacePool pool = make_surface_pool(part_of(mesh, faces), candidates, spread.seed);
  for (int& face : pool.faces) face = faces[static_cast<std::size_t>(face)];
  FarthestPoints points(skin, std::move(pool));

  SpreadTaxels result;
  result.least_distance = std::numeric_limits<double>::infinity();
  const std::uint64_t stream = 7;  // differs from the streams of the candidates
  int next = static_cast<int>(CounterRng(spread.seed, stream).bits(0) % static_cast<std::uint64_t>(candidates));
  for (int k = 0; k < spread.count; ++k) {
    if (progress) progress->check(static_cast<double>(k) / spread.count);
    const double reach = points.distance(next);
    if (!(reach > 0.0))
      throw Error("geodesic spread", "count", fmt::format("only {} of the candidates are different places", k));
    result.least_distance = std::min(result.least_distance, reach);
    result.taxels.push_back(taxel_on(mesh, points.place(next, mesh), k, spread.radius));
    points.choose(next, reach);
    next = points.farthest();
  }
  return result;
}

}  // namespace taxel
