#include "ui/scene/geometry/field_discs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/base/math.h"
#include "core/mesh/geodesic.h"

namespace taxel::ui {
namespace {

constexpr double kMargin = 1.03;      // of the radius: the border of a field is inside its triangles
constexpr double kShapeFineness = 4;  // radius of a field divided by the largest edge of halved faces
constexpr double kBeyond = 1.25;      // of the radius: distances are known up to there
constexpr float kLargestAlpha = 0.9f;
constexpr double kRise = 0.055;  // of the range of readings, over which a disc appears

/// Returns the skin with a normal at each corner of a face: that of the layout's rule if it interpolates normals.
RenderMesh smooth_skin(const SensorModel& model) {
  const TriMesh& mesh = model.skin->mesh();
  if (model.layout.receptive_field.normals == FieldNormals::face) return make_render_mesh(mesh);
  RenderMesh out;
  for (std::size_t i = 0; i < mesh.vertices().size(); ++i)
    out.vertices.push_back({glm::vec3(mesh.vertices()[i]), glm::vec3(mesh.vertex_normals()[i])});
  for (const ivec3& face : mesh.faces())
    for (int c = 0; c < 3; ++c) out.indices.push_back(static_cast<std::uint32_t>(face[c]));
  return out;
}

}  // namespace

/// The shape of one taxel while it is made.
struct FieldShapes::Cut {
  FieldShape& out;
  const std::vector<FieldDisc>& discs;
  dmat3 D_from_M{1};                                                       ///< rotation into the frame of a disc
  std::map<std::uint32_t, std::uint32_t> of_corner{};                      ///< vertices by those of the skin
  std::map<std::tuple<double, double, double>, std::uint32_t> of_point{};  ///< vertices on one face by their place

  void begin(const FieldDisc& disc) {
    const dvec3 x = any_perpendicular(disc.normal);
    D_from_M = glm::transpose(dmat3(x, glm::cross(disc.normal, x), disc.normal));
    of_corner.clear();
  }
  /// Returns whether `disc` is the nearest one of the taxel, relative to the radius.
  [[nodiscard]] bool is_nearest(const FieldDisc& disc, const dvec3& p) const {
    const auto away = [&](const FieldDisc& each) { return glm::distance(p, each.center) / each.radius; };
    return std::none_of(discs.begin(), discs.end(), [&](const FieldDisc& other) {
      return away(other) < away(disc) || (away(other) == away(disc) && &other < &disc);
    });
  }
  [[nodiscard]] glm::vec3 straight(const FieldDisc& disc, const dvec3& p) const {
    return {D_from_M * (p - disc.center) / disc.radius};
  }
  std::uint32_t add(const FieldVertex& vertex) {
    out.vertices.push_back(vertex);
    return static_cast<std::uint32_t>(out.vertices.size() - 1);
  }
};

FieldShapes::FieldShapes(const SensorModel& model, std::shared_ptr<const UnfoldedMesh> unfolded)
    : model_(model),
      unfolded_(std::move(unfolded)),
      smooth_(smooth_skin(model)),
      min_cosine_(min_cosine(model.layout.receptive_field)) {}

FieldShape FieldShapes::of(const Taxel& taxel) const {
  FieldShape shape;
  const std::vector<FieldDisc> discs = discs_of(taxel);
  Cut cut{shape, discs};
  for (const FieldDisc& disc : discs) {
    cut.begin(disc);
    if (unfolded_) {
      append_geodesic(disc, cut);
    } else if (discs.size() == 1) {
      append_whole(disc, cut);
    } else {
      const auto from_center = [&](const dvec3& p) { return cut.straight(disc, p); };
      for (const int face : model_.skin->faces_near(disc.center, kMargin * disc.radius))
        append_halved(disc, disc.center, face, from_center, cut);
    }
  }
  return shape;
}

bool FieldShapes::is_facing(int face, const FieldDisc& disc) const {
  const std::uint32_t* corners = &smooth_.indices[3 * at(face)];
  return std::any_of(corners, corners + 3, [&](std::uint32_t i) {
    return glm::dot(dvec3(smooth_.vertices[i].normal), disc.normal) > min_cosine_;
  });
}

glm::vec3 FieldShapes::normal_at(int face, const dvec3& p) const {
  const TriMesh& mesh = model_.skin->mesh();
  const TrianglePoint on_face =
      nearest_on_triangle(p, mesh.vertex(face, 0), mesh.vertex(face, 1), mesh.vertex(face, 2));
  glm::vec3 n(0);
  for (int c = 0; c < 3; ++c)
    n += static_cast<float>(on_face.barycentric[c]) * smooth_.vertices[smooth_.indices[3 * at(face) + at(c)]].normal;
  return n;
}

void FieldShapes::append_whole(const FieldDisc& disc, Cut& cut) const {
  const glm::mat3 D_from_M(cut.D_from_M);
  for (const int face : model_.skin->faces_near(disc.center, kMargin * disc.radius)) {
    if (!is_facing(face, disc)) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t corner = smooth_.indices[3 * at(face) + c];
      const auto [place, is_new] = cut.of_corner.try_emplace(corner, 0);
      if (is_new) {
        const RenderMesh::Vertex& v = smooth_.vertices[corner];
        place->second = cut.add({v.position, cut.straight(disc, dvec3(v.position)), D_from_M * v.normal});
      }
      cut.out.corners.push_back(place->second);
    }
  }
}

/// Appends the triangles of a face within reach of `middle`.
template <class FromCenter>
void FieldShapes::append_halved(const FieldDisc& disc, const dvec3& middle, int face, const FromCenter& from_center,
                                Cut& cut) const {
  if (!is_facing(face, disc)) return;
  const TriMesh& mesh = model_.skin->mesh();
  const double edge = disc.radius / kShapeFineness;
  const glm::mat3 D_from_M(cut.D_from_M);
  cut.of_point.clear();
  const auto vertex = [&](const dvec3& p) {
    const auto [place, is_new] = cut.of_point.try_emplace({p.x, p.y, p.z}, 0);
    if (is_new) place->second = cut.add({glm::vec3(p), from_center(p), D_from_M * normal_at(face, p)});
    return place->second;
  };
  std::vector<std::array<dvec3, 3>> pending{{mesh.vertex(face, 0), mesh.vertex(face, 1), mesh.vertex(face, 2)}};
  while (!pending.empty()) {
    const auto [a, b, c] = pending.back();
    pending.pop_back();
    Aabb box;
    for (const dvec3& p : {a, b, c}) box.include(p);
    if (glm::distance(middle, glm::clamp(middle, box.lo, box.hi)) > kMargin * disc.radius) continue;
    if (std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)}) > edge) {
      const dvec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
      for (const auto& quarter : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
        pending.push_back(quarter);
    } else if (cut.discs.size() == 1 || cut.is_nearest(disc, (a + b + c) / 3.0)) {
      for (const dvec3& p : {a, b, c}) cut.out.corners.push_back(vertex(p));
    }
  }
}

void FieldShapes::append_geodesic(const FieldDisc& disc, Cut& cut) const {
  GeodesicDistance geodesic(unfolded_);
  const SurfacePoint from = model_.skin->closest_point(disc.center);
  geodesic.propagate(from.face, from.position, kBeyond * disc.radius);
  for (const int face : geodesic.reached_faces()) {
    const auto from_center = [&](const dvec3& p) {
      return glm::vec3(static_cast<float>(std::min(geodesic.to(face, p) / disc.radius, kBeyond)), 0, 0);
    };
    append_halved(disc, from.position, face, from_center, cut);
  }
}

FieldDiscs join_shapes(const SensorModel& model, const std::vector<FieldShape>& shapes) {
  FieldDiscs out;
  out.min_cosine = min_cosine(model.layout.receptive_field);
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    const auto before = static_cast<std::uint32_t>(out.shape.vertices.size());
    for (FieldVertex vertex : shapes[k].vertices) {
      vertex.taxel = static_cast<float>(k);  // the shape may come from a layout with another order
      out.shape.vertices.push_back(vertex);
    }
    for (const std::uint32_t i : shapes[k].corners) out.shape.corners.push_back(before + i);
    out.first.push_back(static_cast<int>(out.shape.corners.size()));
  }
  return out;
}

float disc_alpha(double fraction) {
  if (!(fraction > 0)) return 0;  // NaN, too
  return kLargestAlpha * static_cast<float>(1 - std::exp(-fraction / kRise));
}

}  // namespace taxel::ui
