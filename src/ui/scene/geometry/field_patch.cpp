#include "ui/scene/geometry/field_patch.h"

#include <array>
#include <numeric>

#include "core/base/parallel.h"
#include "core/base/per_thread.h"

namespace taxel::ui {
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

}  // namespace taxel::ui
