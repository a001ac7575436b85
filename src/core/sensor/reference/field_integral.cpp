// The steps of the reading that field_integral.h defines, by adaptive quadrature on the skin:
//
// 1. The faces of the field are divided into triangles that are small against the field and, where rays may hit a
//    surface, against the contact. Otherwise a contact between the points of the rule would be missed.
// 2. Each triangle is integrated by rules of degree 5 and 2 at the same points, a ray from each; their difference is
//    its error. If all rays hit, or all miss, and a corner does not, a tenth of the corner's part is added to the
//    error: the rim of the contact is there.
// 3. The triangle with the largest error is divided into four, until the sum of errors is small enough or kExactRays
//    are cast.
//
// For `max` the triangle that may have the largest pressure comes first; for `nearest` one ray is enough. Cost: one or
// two rays per point; walls are checked only where a ray hits. Pitfall: after the refinement sums are added up again,
// without the rounding of the sums that were subtracted.
#include "core/sensor/reference/field_integral.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <queue>
#include <vector>

#include "core/base/math.h"
#include "core/layout/field/receptive_field.h"
#include "core/mesh/query/triangle.h"

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

namespace {

constexpr int kMaxLevel = 24;
/// Largest edge of the first triangles as a fraction of the smallest field, and of the smallest contact where the rays
/// of a triangle may hit a surface. kLeastPart is the smallest fraction of the field. With larger triangles a contact
/// between the points of the rule would not be found.
constexpr double kFieldPart = 0.125, kContactPart = 0.125, kLeastPart = 1.0 / 64;

double longest_edge(const std::array<dvec3, 3>& c) {
  return std::max({glm::distance(c[0], c[1]), glm::distance(c[1], c[2]), glm::distance(c[2], c[0])});
}

/// Returns the four triangles between a triangle's corners and the middles of its edges.
std::array<std::array<dvec3, 3>, 4> quarters(const std::array<dvec3, 3>& c) {
  const dvec3 ab = 0.5 * (c[0] + c[1]), bc = 0.5 * (c[1] + c[2]), ca = 0.5 * (c[2] + c[0]);
  return {{{c[0], ab, ca}, {ab, c[1], bc}, {ca, bc, c[2]}, {bc, ca, ab}}};
}

}  // namespace

FieldIntegral::FieldIntegral(FieldRays rays, double accuracy, FieldTerms terms)
    : rays_(std::move(rays)), accuracy_(accuracy), terms_(terms) {}

void FieldIntegral::add_faces() {
  for (const FieldRays::Face& face : rays_.faces()) add({face.face, face.corners, face.area, 0});
}

FieldIntegral::Leaf FieldIntegral::measure(const Triangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  Leaf leaf;
  leaf.triangle = triangle;
  leaf.least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < kNodes; ++i) {
    const EmbeddedPoint& q = kTriangleDegree5[i];
    const dvec3 x = q.u * a + q.v * b + (1 - q.u - q.v) * c;
    const double w = rays_.weight(triangle.face, x);
    if (!rays_.inside()) continue;
    leaf.hits[i] = rays_.cast(triangle.face, x);
    ++cast_;
    const RayHit& hit = leaf.hits[i];
    leaf.largest = std::max(leaf.largest, hit.pressure), leaf.least = std::min(leaf.least, hit.pressure);
    const double factor = terms_.weighted ? w : 1.0;
    const double whole = hit.hit() || !rays_.omit_misses() ? factor * triangle.area : 0.0;
    const double value = factor * hit.pressure * triangle.area;
    leaf.parts[i] = q.weight * value;
    leaf.sums.value += q.weight * value, leaf.sums.coarse_value += q.coarse * value;
    leaf.sums.whole += q.weight * whole, leaf.sums.coarse_whole += q.coarse * whole;
  }
  if (!(leaf.least <= leaf.largest)) leaf.least = 0;
  leaf.hidden = hidden_in(leaf);
  return leaf;
}

/// Returns the error of a triangle whose nodes all hit or all miss, while a corner does not: the rim of the contact
/// runs through the triangle, and a tenth of the corner's pressure times the area may be missing or too much.
double FieldIntegral::hidden_in(const Leaf& leaf) {
  constexpr double kMissedPart = 0.1;
  const auto hits = std::count_if(leaf.hits.begin(), leaf.hits.end(), [](const RayHit& hit) { return hit.hit(); });
  if (hits != 0 && hits != static_cast<std::ptrdiff_t>(kNodes)) return 0.0;  // the two rules differ
  double hidden = 0;
  for (const dvec3& corner : leaf.triangle.corners) {
    const double w = rays_.weight(leaf.triangle.face, corner);
    if (!rays_.inside()) continue;
    const RayHit hit = rays_.cast(leaf.triangle.face, corner);
    ++cast_;
    if (hit.hit() == (hits != 0)) continue;
    hidden = std::max(hidden, (terms_.weighted ? w : 1.0) * std::max(hit.pressure, leaf.least));
  }
  return kMissedPart * hidden * leaf.triangle.area;
}

void FieldIntegral::add(const Triangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  const dvec3 middle = (a + b + c) / 3.0;
  const double radius = std::max({glm::distance(middle, a), glm::distance(middle, b), glm::distance(middle, c)});
  if (!rays_.reaches(middle, radius)) return;
  const double field = rays_.smallest_radius();
  double edge = kFieldPart * field;
  if (kContactPart * rays_.smallest_contact() < edge && rays_.may_hit(triangle.face, triangle.corners))
    edge = std::max(kContactPart * rays_.smallest_contact(), kLeastPart * field);
  if (longest_edge(triangle.corners) <= edge || triangle.level >= kMaxLevel / 2) {
    leaves_.push_back(measure(triangle));
    return;
  }
  for (const auto& part : quarters(triangle.corners))
    add({triangle.face, part, 0.25 * triangle.area, triangle.level + 1});
}

/// Returns the error of the quotient value / whole, times the whole: |d value| + reading |d whole|.
double FieldIntegral::error_of(const Leaf& leaf) const {
  const Sums& s = leaf.sums;
  const double reading = !terms_.divided || !(sum_.whole > 0) ? 0.0 : sum_.value / sum_.whole;
  return std::abs(s.value - s.coarse_value) + reading * std::abs(s.whole - s.coarse_whole) + leaf.hidden;
}

void FieldIntegral::add_sums(const Leaf& leaf, double sign) {
  sum_.value += sign * leaf.sums.value, sum_.whole += sign * leaf.sums.whole;
}

void FieldIntegral::refine(std::size_t number) {
  const Triangle triangle = leaves_[number].triangle;
  const auto parts = quarters(triangle.corners);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Leaf leaf = measure({triangle.face, parts[i], 0.25 * triangle.area, triangle.level + 1});
    if (i == 0)
      leaves_[number] = leaf;
    else
      leaves_.push_back(leaf);
  }
}

/// Returns the parts of the reading by polygon. `scale` times an integral is a part of the reading.
std::vector<PolygonPart> FieldIntegral::parts(double scale) const {
  std::map<std::pair<int, int>, double> sums;
  for (const Leaf& leaf : leaves_)
    for (std::size_t i = 0; i < kNodes; ++i)
      if (leaf.hits[i].hit()) sums[{leaf.hits[i].surface, leaf.hits[i].polygon}] += leaf.parts[i];
  std::vector<PolygonPart> out;
  for (const auto& [of, value] : sums) out.push_back({of.first, of.second, scale * value});
  return out;
}

/// Refines the triangle that may have the largest pressure, until no triangle may have noticeably more than the largest
/// pressure found.
ExactReading FieldIntegral::read_largest() {
  add_faces();
  const auto promise = [](const Leaf& leaf) { return leaf.largest + (leaf.largest - leaf.least); };
  const auto less = [&](std::size_t a, std::size_t b) {
    return std::pair(promise(leaves_[a]), b) < std::pair(promise(leaves_[b]), a);
  };
  std::priority_queue<std::size_t, std::vector<std::size_t>, decltype(less)> open(less);
  double largest = 0;
  for (std::size_t i = 0; i < leaves_.size(); ++i) largest = std::max(largest, leaves_[i].largest), open.push(i);
  ExactReading out;
  while (!open.empty() && cast_ < kExactRays) {
    const std::size_t top = open.top();
    out.error = std::max(0.0, promise(leaves_[top]) - largest);
    if (out.error <= accuracy_ * largest || leaves_[top].triangle.level >= kMaxLevel) break;
    open.pop();
    const std::size_t before = leaves_.size();
    refine(top);
    open.push(top);
    for (std::size_t i = before; i < leaves_.size(); ++i) open.push(i);
    for (std::size_t i = before; i < leaves_.size(); ++i) largest = std::max(largest, leaves_[i].largest);
    largest = std::max(largest, leaves_[top].largest);
  }
  out.value = largest;
  out.rays = cast_;
  return out;
}

ExactReading FieldIntegral::read() {
  add_faces();
  for (const Leaf& leaf : leaves_) add_sums(leaf, 1);
  using Open = std::pair<double, std::size_t>;  // error, leaf
  std::priority_queue<Open> open;
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    const double error = error_of(leaves_[i]);
    error_ += error;
    open.emplace(error, i);
  }
  while (!open.empty() && error_ > accuracy_ * sum_.value && cast_ < kExactRays) {
    const auto [error, number] = open.top();
    open.pop();
    if (leaves_[number].triangle.level >= kMaxLevel) continue;
    const std::size_t before = leaves_.size();
    add_sums(leaves_[number], -1);
    refine(number);
    error_ -= error;
    const auto renew = [&](std::size_t i) {
      add_sums(leaves_[i], 1);
      const double now = error_of(leaves_[i]);
      error_ += now;
      open.emplace(now, i);
    };
    renew(number);
    for (std::size_t i = before; i < leaves_.size(); ++i) renew(i);
  }
  sum_ = {};  // added up again, without the rounding of the sums that were subtracted
  for (const Leaf& leaf : leaves_) add_sums(leaf, 1);
  const SensorModel& model = rays_.model();
  const double samples_per_area =
      uniform_samples(model.layout, model.samples.size(), model.sampled_area) / model.sampled_area;
  const double scale = !terms_.divided ? samples_per_area : sum_.whole > 0 ? 1 / sum_.whole : 0.0;
  ExactReading out;
  out.value = scale * sum_.value;
  out.error = scale * error_;
  out.parts = parts(scale);
  out.rays = cast_;
  return out;
}

}  // namespace taxel
