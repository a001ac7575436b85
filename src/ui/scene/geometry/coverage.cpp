#include "ui/scene/geometry/coverage.h"

#include <cmath>

#include "core/base/index.h"
#include "core/base/parallel.h"
#include "core/base/per_thread.h"
#include "core/layout/field/field_disc.h"
#include "core/mesh/geodesic/geodesic_distance.h"

namespace taxel::ui {
namespace {

/// A skin divided into small triangles. The triangles of one face are successive.
struct Pieces {
  std::vector<Coverage::Piece> all;
  std::vector<int> first;  // first triangle of each face, and the total number
};

/// Appends n^2 equal triangles with the winding of the face.
void append_pieces(const TriMesh& mesh, int face, int n, std::vector<Coverage::Piece>& out) {
  const dvec3 o = mesh.vertex(face, 0), u = (mesh.vertex(face, 1) - o) / double(n),
              v = (mesh.vertex(face, 2) - o) / double(n);
  const auto point = [&](int i, int j) { return o + double(i) * u + double(j) * v; };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; i + j < n; ++j) {
      out.push_back({{point(i, j), point(i + 1, j), point(i, j + 1), face}});
      if (i + j + 1 < n) out.push_back({{point(i + 1, j), point(i + 1, j + 1), point(i, j + 1), face}});
    }
  }
}

Pieces cut_skin(const TriMesh& mesh, int pieces) {
  Pieces out;
  out.first.push_back(0);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const double share = pieces * mesh.face_areas()[at(f)] / mesh.area();
    append_pieces(mesh, f, std::max(1, static_cast<int>(std::ceil(std::sqrt(share)))), out.all);
    out.first.push_back(static_cast<int>(out.all.size()));
  }
  return out;
}

/// Finds the pieces inside a taxel's field. Each thread has its own.
class Seeing {
 public:
  Seeing(const SensorModel& model, const Pieces& pieces, std::shared_ptr<const UnfoldedMesh> unfolded)
      : model_(model), pieces_(pieces), cosine_(min_cosine(model.layout.receptive_field)) {
    if (unfolded) geodesic_.emplace(std::move(unfolded));
  }

  std::vector<int> operator()(const Taxel& taxel) {
    std::vector<int> seen;
    for (const FieldDisc& disc : discs_of(taxel)) geodesic_ ? by_path(disc, seen) : straight(disc, seen);
    std::sort(seen.begin(), seen.end());
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    return seen;
  }

 private:
  template <class Distance>
  void visit(int face, const FieldDisc& disc, const Distance& distance, std::vector<int>& seen) const {
    const FieldNormals normals = model_.layout.receptive_field.normals;
    const TriMesh& skin = model_.skin->mesh();
    if (normals == FieldNormals::face && !disc.faces(skin.face_normals()[at(face)], cosine_)) return;
    for (int i = pieces_.first[at(face)]; i < pieces_.first[at(face) + 1]; ++i) {
      const SkinPiece& piece = pieces_.all[at(i)].at;
      const dvec3 middle = (piece.a + piece.b + piece.c) / 3.0;
      if (distance(middle) <= disc.radius && disc.faces(field_normal(normals, skin, face, middle), cosine_))
        seen.push_back(i);
    }
  }
  void straight(const FieldDisc& disc, std::vector<int>& seen) const {
    const auto distance = [&](const dvec3& p) { return glm::distance(p, disc.center); };
    for (const int face : model_.skin->faces_near(disc.center, disc.radius)) visit(face, disc, distance, seen);
  }
  void by_path(const FieldDisc& disc, std::vector<int>& seen) {
    const SurfacePoint from = model_.skin->closest_point(disc.center);
    geodesic_->propagate(from.face, from.position, disc.radius);
    for (const int face : geodesic_->reached_faces()) {
      visit(
          face, disc, [&](const dvec3& p) { return geodesic_->to(face, p); }, seen);
    }
  }

  const SensorModel& model_;
  const Pieces& pieces_;
  double cosine_;
  std::optional<GeodesicDistance> geodesic_;
};

}  // namespace

double Coverage::shared() const {
  double sum = 0;
  for (std::size_t n = 2; n < area_of_overlap.size(); ++n) sum += area_of_overlap[n];
  return sum;
}

double Coverage::overlap() const {
  double sum = 0;
  for (std::size_t n = 1; n < area_of_overlap.size(); ++n) sum += static_cast<double>(n) * area_of_overlap[n];
  const double covered = area - uncovered();
  return covered > 0 ? sum / covered : 0;
}

Coverage make_coverage(const SensorModel& model, int pieces) {
  CoverageMemory memory;
  return make_coverage(model, memory, pieces);
}

Coverage make_coverage(const SensorModel& model, CoverageMemory& memory, int pieces) {
  const TriMesh& mesh = model.skin->mesh();
  Pieces cut = cut_skin(mesh, pieces);
  const bool geodesic = model.layout.receptive_field.metric == Metric::geodesic;
  if (geodesic && (!memory.unfolded || &memory.unfolded->mesh() != &mesh)) memory.unfolded = unfolded_skin(model);
  PerThread<Seeing> seeing([&] { return Seeing(model, cut, geodesic ? memory.unfolded : nullptr); });
  const auto& seen =
      memory.seen.update(model, pieces, [&](const std::vector<int>& missing, std::vector<std::vector<int>>& values) {
        parallel_chunks(static_cast<int>(missing.size()), 8, [&](int begin, int end) {
          for (int i = begin; i < end; ++i) {
            const int k = missing[at(i)];
            values[at(k)] = seeing.local()(model.layout.taxels[at(k)]);
          }
        });
      });
  Coverage out;
  out.pieces = std::move(cut.all);
  for (const std::vector<int>& of_taxel : seen) {
    for (const int i : of_taxel) ++out.pieces[at(i)].taxels;
  }
  out.area = mesh.area();
  out.area_of_overlap.assign(1, 0);
  for (const Coverage::Piece& piece : out.pieces) {
    if (out.area_of_overlap.size() <= at(piece.taxels)) out.area_of_overlap.resize(at(piece.taxels) + 1, 0);
    const SkinPiece& p = piece.at;
    out.area_of_overlap[at(piece.taxels)] += 0.5 * glm::length(glm::cross(p.b - p.a, p.c - p.a));
  }
  return out;
}

}  // namespace taxel::ui
