#include "core/sensor/explain/field_integral.h"

#include <map>
#include <queue>

#include "core/layout/field/dense_fields.h"

namespace taxel {
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
