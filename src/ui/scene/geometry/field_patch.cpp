#include "ui/scene/geometry/field_patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/layout/field/receptive_field.h"
#include "core/mesh/geodesic.h"

namespace taxel::ui {
namespace {

/// A triangle in its own plane. The origin is the foot of the perpendicular from the sphere's centre.
struct PlaneTriangle {
  dvec3 foot, x, y;
  std::array<dvec2, 3> corner;  // counter-clockwise

  [[nodiscard]] bool contains(const dvec2& p) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const dvec2 e = corner[(k + 1) % 3] - corner[k], d = p - corner[k];
      if (e.x * d.y - e.y * d.x < 0) return false;
    }
    return true;
  }
  [[nodiscard]] dvec3 lift(double angle, double r) const {
    return foot + r * (std::cos(angle) * x + std::sin(angle) * y);
  }
};

PlaneTriangle in_own_plane(const TriMesh& mesh, int face, const dvec3& center) {
  const dvec3& n = mesh.face_normals()[static_cast<std::size_t>(face)];
  PlaneTriangle t;
  t.foot = center - glm::dot(center - mesh.vertex(face, 0), n) * n;
  t.x = any_perpendicular(n);
  t.y = glm::cross(n, t.x);
  for (int k = 0; k < 3; ++k) {
    const dvec3 d = mesh.vertex(face, k) - t.foot;
    t.corner[static_cast<std::size_t>(k)] = {glm::dot(d, t.x), glm::dot(d, t.y)};
  }
  return t;
}

/// Returns the angles at which the circle of radius r about the origin crosses the sides, ascending.
std::vector<double> crossings(const PlaneTriangle& t, double r) {
  std::vector<double> angles;
  for (std::size_t k = 0; k < 3; ++k) {
    const dvec2 p = t.corner[k], d = t.corner[(k + 1) % 3] - p;
    const double a = glm::dot(d, d), b = glm::dot(p, d), c = glm::dot(p, p) - r * r;  // a s^2 + 2 b s + c = 0
    const double discriminant = b * b - a * c;
    if (!(discriminant > 0)) continue;
    for (const double sign : {-1.0, 1.0}) {
      const double s = (-b + sign * std::sqrt(discriminant)) / a;
      if (s < 0 || s > 1) continue;
      const dvec2 q = p + s * d;
      angles.push_back(std::atan2(q.y, q.x));
    }
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

/// Appends the pieces of the circle of radius r about the origin that are inside the triangle.
void append_arcs(const PlaneTriangle& t, double r, int face, double step, std::vector<RingPiece>& out) {
  std::vector<double> angles = crossings(t, r);
  if (angles.empty()) angles.push_back(-kPi);  // the circle is entirely inside or outside
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double from = angles[i];
    const double to = i + 1 < angles.size() ? angles[i + 1] : angles[0] + 2 * kPi;
    const double middle = 0.5 * (from + to);
    if (!(to > from) || !t.contains(r * dvec2(std::cos(middle), std::sin(middle)))) continue;
    const int pieces = std::max(1, static_cast<int>(std::ceil((to - from) / step)));
    for (int k = 0; k < pieces; ++k) {
      out.push_back(
          {t.lift(from + (to - from) * k / pieces, r), t.lift(from + (to - from) * (k + 1) / pieces, r), face});
    }
  }
}

}  // namespace

std::vector<RingPiece> field_ring(const MeshIndex& skin, const dvec3& center, double radius, const dvec3& normal,
                                  double max_angle_deg, double step_deg) {
  const TriMesh& mesh = skin.mesh();
  const double least = std::cos(glm::radians(max_angle_deg)) * glm::length(normal);
  const double step = glm::radians(step_deg);
  std::vector<RingPiece> out;
  for (const int f : skin.faces_near(center, radius)) {
    const dvec3& n = mesh.face_normals()[static_cast<std::size_t>(f)];
    if (glm::dot(n, normal) <= least) continue;
    const double h = glm::dot(center - mesh.vertex(f, 0), n);  // height above the plane
    if (std::abs(h) >= radius) continue;
    append_arcs(in_own_plane(mesh, f, center), std::sqrt(radius * radius - h * h), f, step, out);
  }
  return out;
}

namespace {

/// Returns the ring of a disc by the rule. With interpolated normals, the pieces end within `step_deg` of the limit.
std::vector<RingPiece> disc_ring(const MeshIndex& skin, const FieldDisc& disc, const ReceptiveFieldRule& rule,
                                 double step_deg) {
  if (rule.normals == FieldNormals::face)
    return field_ring(skin, disc.center, disc.radius, disc.normal, rule.max_angle_deg, step_deg);
  std::vector<RingPiece> ring = field_ring(skin, disc.center, disc.radius, disc.normal, 180.0, step_deg);
  const FieldAngle angle(rule);
  std::erase_if(ring, [&](const RingPiece& piece) {
    const dvec3 normal = skin_normal(skin.mesh(), piece.face, 0.5 * (piece.a + piece.b));
    return !(disc.facing(normal, angle) > 0);
  });
  return ring;
}

}  // namespace

std::vector<RingPiece> taxel_rings(const MeshIndex& skin, const Taxel& taxel, const ReceptiveFieldRule& rule,
                                   double step_deg) {
  std::vector<RingPiece> out;
  for (const FieldDisc& disc : discs_of(taxel)) {
    const std::vector<RingPiece> ring = disc_ring(skin, disc, rule, step_deg);
    out.insert(out.end(), ring.begin(), ring.end());
  }
  return out;
}

namespace {

constexpr int kFine = 8, kCoarse = 5, kManyPatches = 200;

/// Clips a convex polygon to the part where a linear value is negative (Sutherland, Hodgman 1974), and returns the
/// clipping points.
template <class Corner, class Value>
std::vector<Corner> clipped(const std::vector<Corner>& polygon, const Value& value, std::vector<dvec3>& cuts) {
  std::vector<Corner> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double va = value(a), vb = value(b);
    if (va < 0) kept.push_back(a);
    if ((va < 0) == (vb < 0)) continue;
    const double t = va / (va - vb);
    kept.push_back({glm::mix(a.p, b.p, t), glm::mix(a.euclidean, b.euclidean, t), glm::mix(a.geodesic, b.geodesic, t),
                    glm::mix(a.turned, b.turned, t)});
    cuts.push_back(kept.back().p);
  }
  return kept;
}

double squared_distance(const dvec3& p, const Aabb& box) {
  const dvec3 away = p - glm::clamp(p, box.lo, box.hi);
  return glm::dot(away, away);
}

}  // namespace

/// State of cutting one field out of one face.
struct FieldCutter::Cut {
  const FieldDisc& disc;
  FieldPart part;
  double reach;  ///< largest Euclidean distance of the field from the centre [m]
  double edge;   ///< longest edge of an undivided triangle [m]
  int face = -1;
};

FieldCutter::FieldCutter(const MeshIndex& skin, std::shared_ptr<const UnfoldedMesh> unfolded,
                         const ReceptiveFieldRule& rule, int fineness)
    : skin_(skin), geodesic_(std::move(unfolded)), rule_(rule), min_cosine_(min_cosine(rule)), fineness_(fineness) {}

void FieldCutter::append(const FieldDisc& disc, FieldPart part, FieldPatch& out) {
  Cut cut{disc, part, disc.radius, disc.radius / fineness_};
  if (part != FieldPart::euclidean) {
    // Geodesic distances begin at the point of the skin closest to the centre; somewhat beyond the radius they are
    // needed to find where they equal it.
    const SurfacePoint from = skin_.closest_point(disc.center);
    geodesic_.propagate(from.face, from.position, disc.radius + 2 * cut.edge);
    if (part == FieldPart::geodesic) cut.reach += from.distance;
  }
  const TriMesh& mesh = skin_.mesh();
  for (const int f : skin_.faces_near(disc.center, cut.reach)) {
    if (rule_.normals == FieldNormals::face &&
        !disc.faces(mesh.face_normals()[static_cast<std::size_t>(f)], min_cosine_))
      continue;
    cut.face = f;
    halve(cut, {mesh.vertex(f, 0), mesh.vertex(f, 1), mesh.vertex(f, 2)}, out);
  }
}

void FieldCutter::halve(const Cut& cut, const std::array<dvec3, 3>& corners, FieldPatch& out) {
  const auto& [a, b, c] = corners;
  Aabb box;
  for (const dvec3& p : corners) box.include(p);
  if (squared_distance(cut.disc.center, box) > cut.reach * cut.reach) return;
  const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
  if (longest <= cut.edge) return cut_leaf(cut, corners, out);
  const dvec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
  halve(cut, {a, ab, ca}, out);
  halve(cut, {ab, b, bc}, out);
  halve(cut, {ca, bc, c}, out);
  halve(cut, {ab, bc, ca}, out);
}

void FieldCutter::cut_leaf(const Cut& cut, const std::array<dvec3, 3>& corners, FieldPatch& out) {
  const double most = geodesic_.radius() - cut.disc.radius;
  std::vector<Corner> polygon;
  for (const dvec3& p : corners) {
    const double geodesic =
        cut.part == FieldPart::euclidean ? 0 : std::min(geodesic_.to(cut.face, p) - cut.disc.radius, most);
    polygon.push_back({p, glm::distance(p, cut.disc.center) - cut.disc.radius, geodesic});
    if (rule_.normals == FieldNormals::interpolated)
      polygon.back().turned = min_cosine_ - glm::dot(skin_normal(skin_.mesh(), cut.face, p), cut.disc.normal);
  }
  std::vector<dvec3> cuts, ignored;
  polygon = clipped(
      polygon, [](const Corner& corner) { return corner.turned; }, ignored);
  if (cut.part != FieldPart::geodesic) {
    polygon = clipped(
        polygon, [](const Corner& corner) { return corner.euclidean; }, cuts);
  }
  if (cut.part == FieldPart::geodesic) {
    polygon = clipped(
        polygon, [](const Corner& corner) { return corner.geodesic; }, cuts);
  }
  if (cut.part == FieldPart::euclidean_only) {
    polygon = clipped(
        polygon, [](const Corner& corner) { return -corner.geodesic; }, ignored);
  } else if (cuts.size() == 2) {
    out.boundary.push_back({cuts[0], cuts[1], cut.face});
  }
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const SkinPiece piece{polygon[0].p, polygon[i - 1].p, polygon[i].p, cut.face};
    out.area += 0.5 * glm::length(glm::cross(piece.b - piece.a, piece.c - piece.a));
    out.pieces.push_back(piece);
  }
}

std::shared_ptr<const UnfoldedMesh> unfolded_skin(const SensorModel& model) {
  return std::make_shared<const UnfoldedMesh>(model.skin->mesh_ptr());
}

int field_fineness(const SensorModel& model) {
  return model.taxel_count() > kManyPatches ? kCoarse : kFine;
}

void cut_patches(const SensorModel& model, FieldPart part, const std::shared_ptr<const UnfoldedMesh>& unfolded,
                 const std::vector<int>& taxels, std::vector<FieldPatch>& patches) {
  const ReceptiveFieldRule& rule = model.layout.receptive_field;
  const int fineness = field_fineness(model);
  PerThread<FieldCutter> cutters([&] { return FieldCutter(*model.skin, unfolded, rule, fineness); });
  parallel_chunks(static_cast<int>(taxels.size()), 8, [&](int begin, int end) {
    FieldCutter& cutter = cutters.local();
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
      const auto k = static_cast<std::size_t>(taxels[i]);
      for (const FieldDisc& disc : discs_of(model.layout.taxels[k])) cutter.append(disc, part, patches[k]);
    }
  });
}

std::vector<FieldPatch> taxel_patches(const SensorModel& model, FieldPart part) {
  std::vector<int> all(model.layout.taxels.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<FieldPatch> patches(all.size());
  cut_patches(model, part, unfolded_skin(model), all, patches);
  return patches;
}

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
