#include "core/sensor/explain/field_rays.h"

#include <numeric>

#include "core/base/angle.h"
#include "core/base/index.h"
#include "core/mesh/query/point_triangle.h"

namespace taxel {
namespace {

Layout of_one(const Layout& layout, const Taxel& taxel) {
  Layout one = layout;
  one.taxels = {taxel};
  return one;
}

/// Returns false only if the angle of the rule surely excludes every point of a face. Interpolated normals lie in the
/// cap around the normal of one corner that reaches the others.
bool may_face(const TriMesh& skin, int face, const FieldDisc& disc, const ReceptiveFieldRule& rule) {
  if (rule.normals == FieldNormals::face) return disc.faces(skin.face_normals()[at(face)], min_cosine(rule));
  const ivec3& corners = skin.faces()[at(face)];
  const auto normal = [&](int c) { return skin.vertex_normals()[at(corners[c])]; };
  const double cap = std::max(angle_deg(normal(0), normal(1)), angle_deg(normal(0), normal(2)));
  return cap >= 90.0 || angle_deg(normal(0), disc.normal) - cap < rule.max_angle_deg;
}

}  // namespace

FieldRays::FieldRays(const SensorModel& model, int taxel, std::span<const ContactSurface* const> surfaces,
                     FieldNormals normals)
    : model_(model),
      taxel_(model.layout.taxels[at(taxel)]),
      normals_(normals),
      skin_{model.mesh, model.skin, model.skin_face_of},
      discs_(discs_of(taxel_)),
      weights_(of_one(model.layout, taxel_), *model.skin),
      disc_numbers_(discs_.size()) {
  std::iota(disc_numbers_.begin(), disc_numbers_.end(), 0);
  if (model.layout.receptive_field.metric == Metric::geodesic)  // paths begin on the skin
    for (FieldDisc& disc : discs_) disc.center = model.skin->closest_point(disc.center).position;
  smallest_radius_ = weights_.smallest_radius(disc_numbers_);
  smallest_contact_ = std::numeric_limits<double>::infinity();
  for (const ContactSurface* surface : surfaces) {
    if (surface == nullptr || surface->empty()) continue;
    Aabb box;
    for (const dvec3& v : surface->vertices) box.include(v);
    smallest_contact_ = std::min(smallest_contact_, box.diagonal());
    boxes_.push_back(box);
  }
  caster_.build(surfaces);
}

dvec3 FieldRays::direction(int face, const dvec3& point) const {
  return model_.layout.readout.ray == RayDirection::taxel_normal
             ? -glm::normalize(taxel_.normal)
             : -field_normal(normals_, skin_.sensed->mesh(), face, point);
}

RayHit FieldRays::cast(int face, const dvec3& point) const {
  SensorRay ray{0, point, direction(face, point), model_.max_depth};
  // A hit within the allowed depth may be beyond the middle of a thin wall, which is checked for hits only.
  if (model_.body->soft() && !caster_.cast(ray.origin, ray.direction, ray.max_depth).hit()) return {};
  limit_ray(skin_, face, model_.body->soft(), model_.max_depth, ray);
  return caster_.cast(ray.origin, ray.direction, ray.max_depth);
}

double FieldRays::weight(int face, const dvec3& point) {
  weights_.at(face, point, disc_numbers_, at_);
  return at_.weights.empty() ? 0.0 : at_.weights.front().value;
}

std::optional<FieldRays::Start> FieldRays::nearest_start(const dvec3& p) const {
  double nearest = std::numeric_limits<double>::infinity();
  std::optional<Start> start;
  for (const Face& f : faces()) {
    const TrianglePoint at = nearest_on_triangle(p, f.corners[0], f.corners[1], f.corners[2]);
    if (!(at.squared_distance < nearest)) continue;
    nearest = at.squared_distance;
    start = Start{f.face, at.position};
  }
  return start;
}

bool FieldRays::reaches(const dvec3& center, double radius) const {
  return std::any_of(discs_.begin(), discs_.end(),
                     [&](const FieldDisc& disc) { return glm::distance(disc.center, center) <= disc.radius + radius; });
}

std::vector<FieldRays::Face> FieldRays::faces() const {
  const TriMesh& skin = skin_.sensed->mesh();
  const FaceSet sampled = sampled_region(model_);
  const std::vector<int>& region = *sampled;
  std::vector<Face> out;
  for (int f = 0; f < skin.face_count(); ++f) {
    if (!region.empty() && !std::binary_search(region.begin(), region.end(), skin_.face_of[at(f)])) continue;
    const Face face{f, {skin.vertex(f, 0), skin.vertex(f, 1), skin.vertex(f, 2)}, skin.face_areas()[at(f)]};
    const bool reached = std::any_of(discs_.begin(), discs_.end(), [&](const FieldDisc& disc) {
      const auto& [a, b, c] = face.corners;
      return may_face(skin, f, disc, model_.layout.receptive_field) &&
             nearest_on_triangle(disc.center, a, b, c).squared_distance <= disc.radius * disc.radius;
    });
    if (reached) out.push_back(face);
  }
  return out;
}

bool FieldRays::may_hit(int face, const std::array<dvec3, 3>& corners) const {
  Aabb swept;
  const dvec3 first = direction(face, corners[0]);
  double bulge = 0;  // between the corners, rays that diverge end farther out than the corners' rays
  for (const dvec3& corner : corners) {
    const dvec3 along = direction(face, corner);
    swept.include(corner);
    swept.include(corner + model_.max_depth * along);
    bulge = std::max(bulge, model_.max_depth * glm::distance(along, first));
  }
  // The rays of rigid sensors start outside.
  const double lead = 1e-5 * skin_.sensed->mesh().bounds().diagonal() + bulge;
  swept.lo -= lead, swept.hi += lead;
  return std::any_of(boxes_.begin(), boxes_.end(), [&](const Aabb& box) { return swept.overlaps(box); });
}

}  // namespace taxel
