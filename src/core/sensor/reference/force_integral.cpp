// The steps of the integral that force_integral.h defines, by adaptive quadrature over the contact polygons:
//
// 1. A polygon that is small against the fields near it is one leaf, integrated by three points on the ellipse of its
//    second moments; others are divided into triangles no larger than the smallest field. The nearest point s(x) is
//    searched from the face of the last polygon in the same tet.
// 2. Each leaf has an error: the difference of two rules at the same points, or at the edge of all fields a tenth of
//    its force, since all points may be on one side.
// 3. Leaves above the tolerance are divided into four. A triangle that the edge of the fields crosses is first cut
//    along the chord between the points at which the margin is 0, found by regula falsi; the area of the arc above the
//    chord is added.
//
// The tolerance refers to the covered force of all leaves, so the work goes where the error is. Every rule is exact for
// a linear pressure, so taxels and the rest add up to the elastic force whatever the weights. Pitfall: sums run over
// taxels by id and polygons in their order, for the same bits with any order of the taxels. Theory:
// docs/theory/sensor.md, "Force".
#include "core/sensor/reference/force_integral.h"

#include "core/base/math.h"
#include "core/hydro/quadrature.h"
#include "core/sensor/reference/moments.h"
#include "core/sensor/sensor_model.h"

namespace taxel {
namespace {

/// Largest error of a triangle as a fraction of kAccuracy. Only triangles at the edge of the fields have such errors,
/// and the errors of many of them cancel.
constexpr double kTrianglePart = 0.04;
constexpr double kLeastForcePart = 1e-3;  // smallest fraction of the whole force that the accuracy refers to
constexpr int kMaxForceLevel = 24;
/// Near the edge of the fields all points of the rule may be on one side of it. kMissedPart is the fraction of a
/// triangle that may be missed then. kNearEdge is the distance that is near, in circumradii: below convex skin s(x)
/// moves faster than x.
constexpr double kMissedPart = 0.1, kNearEdge = 1.2;

/// Largest size of a small polygon as a fraction of the smallest field's radius.
constexpr double kSmallPolygon = 0.25;

/// Returns the normal of the skin at s, its point nearest to x: the normal of the face, or the direction from x to s on
/// an edge or a corner, where several faces are equally near. That direction turns from one face's normal to the next
/// as x moves, so that the result does not depend on the choice of a face.
dvec3 normal_at(const TriMesh& skin, const SurfacePoint& s, const dvec3& x) {
  constexpr double kInSkin = 1e-9;  // fraction of the skin's size below which the direction is rounding
  const dvec3& b = s.barycentric;
  const bool in_face = b.x != 0 && b.y != 0 && b.z != 0;
  if (in_face || !(s.distance > kInSkin * skin.bounds().diagonal())) return skin.face_normals()[at(s.face)];
  return (s.position - x) / s.distance;
}

double longest_edge_of_piece(const std::array<dvec3, 3>& c) {
  return std::max({glm::distance(c[0], c[1]), glm::distance(c[1], c[2]), glm::distance(c[2], c[0])});
}

}  // namespace

ForceIntegral::Triangle ForceIntegral::Triangle::child(int number) const {
  const dvec3 ab = 0.5 * (corners[0] + corners[1]), bc = 0.5 * (corners[1] + corners[2]),
              ca = 0.5 * (corners[2] + corners[0]);
  const std::array<std::array<dvec3, 3>, 4> parts{
      {{corners[0], ab, ca}, {ab, corners[1], bc}, {ca, bc, corners[2]}, {bc, ca, ab}}};
  return {parts[at(number)], 0.25 * area, level + 1};
}

double ForceIntegral::Polygon::pressure(const dvec3& x) const {
  return polygon->pressure + glm::dot(polygon->gradient, x - polygon->centroid);
}

/// Computes the weights at the skin's point nearest to x in at_.
void ForceIntegral::evaluate(const Polygon& polygon, const dvec3& x) {
  ++out_->evaluations;
  const SurfacePoint s = fields_->nearest->closest_point(x, face_);
  const dvec3& b = s.barycentric;
  if (b.x > 0 && b.y > 0 && b.z > 0) {
    set_weights(s.face, s.position);
  } else {
    fields_->weights->at(s.face, s.position, normal_at(model_->skin->mesh(), s, x),
                         discs_near(*polygon.polygon, polygon.radius), at_);
  }
  at_.margin = std::min(at_.margin, model_->max_depth - s.distance);
  if (s.distance > model_->max_depth) at_.weights.clear();
}

/// Returns the discs that may reach points of a polygon, whose corners are within `radius` of its centroid c. As
/// |s(x) - x| <= |s(c) - c| + |x - c|, all these points are within |s(c) - c| + 2 radius of c.
std::span<const int> ForceIntegral::discs_near(const ContactPolygon& polygon, double radius) {
  if (near_of_ != &polygon) {
    int face = face_;
    const SurfacePoint s = fields_->nearest->closest_point(polygon.centroid, face);
    fields_->weights->near(polygon.centroid, s.distance + 2 * radius, near_);
    near_of_ = &polygon;
  }
  return near_;
}

/// Computes the weights at a point of a face in at_.
void ForceIntegral::set_weights(int face, const dvec3& on_skin) {
  const FaceFields& faces = fields_->faces;
  const FaceFields::Range& range = faces.range(face);
  const dvec2 q = faces.plane(face).project(on_skin);
  faces.at(face, q, of_face_);
  at_.weights.clear();
  at_.margin = -std::numeric_limits<double>::infinity();
  at_.cover = 0;
  for (std::size_t i = 0; i < range.count(); ++i) {
    const double left = faces.radius(range.first + i) - of_face_.away[i], facing = of_face_.facing[i];
    if (!(facing > 0)) continue;
    at_.margin = std::max(at_.margin, left >= 0 ? left : std::min(0.0, faces.straight_margin(range.first + i, q)));
    if (left < 0 || (range.subtaxels && !faces.is_nearest(range, i, of_face_))) continue;
    if (left > 0) at_.cover = std::max(at_.cover, facing);
    at_.weights.push_back({faces.taxel(range.first + i), left * left * facing, facing});
  }
}

/// Integrates by the nodes of a rule. The error is the difference of the two rules, or near the edge of the fields the
/// largest force between the points of the rules.
ForceIntegral::Estimate ForceIntegral::estimate(const Polygon& polygon, std::span<const Node> nodes, double area,
                                                double radius) {
  Estimate e;
  e.first = static_cast<std::uint32_t>(shares_.size());
  e.whole = area * polygon.pressure(nodes[0].x);
  double coarse_covered = 0, margin = 0;
  for (const Node& node : nodes) {
    evaluate(polygon, node.x);
    if (&node == nodes.data()) margin = std::abs(at_.margin);
    double sum = 0;
    for (const FieldWeights::Weight& w : at_.weights) sum += w.value;
    if (!(sum > 0)) continue;
    const double pressure = polygon.pressure(node.x), force = pressure * area;
    e.covered += node.weight * at_.cover * force;
    coarse_covered += node.coarse * at_.cover * force;
    dvec3 friction(0);
    if (polygon.motion != nullptr)
      friction = node.weight * area * polygon.motion->friction(pressure, polygon.polygon->normal, node.x);
    for (const FieldWeights::Weight& w : at_.weights) {
      const double phi = at_.cover * w.value / sum;
      Share& share = share_of(e.first, w.taxel);
      share.value += node.weight * phi * force;
      share.coarse += node.coarse * phi * force;
      share.friction += phi * friction;
    }
  }
  e.end = static_cast<std::uint32_t>(shares_.size());
  e.error = std::abs(e.covered - coarse_covered);
  for (std::uint32_t i = e.first; i < e.end; ++i) e.error += std::abs(shares_[i].value - shares_[i].coarse);
  if (margin < kNearEdge * radius) e.error = std::max(e.error, kMissedPart * std::abs(e.whole));
  return e;
}

/// Integrates by the rule of degree 5, compared with the rule of degree 2 at the same points.
ForceIntegral::Estimate ForceIntegral::estimate(const Polygon& polygon, const Triangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  std::array<Node, kTriangleDegree5.size()> nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const EmbeddedPoint& q = kTriangleDegree5[i];
    nodes[i] = {q.u * a + q.v * b + (1 - q.u - q.v) * c, q.weight, q.coarse};
  }
  const dvec3& middle = nodes[0].x;
  const double radius = std::max({glm::distance(middle, a), glm::distance(middle, b), glm::distance(middle, c)});
  return estimate(polygon, nodes, triangle.area, radius);
}

/// Integrates a whole polygon that is small against the fields, by three points on the ellipse of its second moments
/// (moments.h), compared with the centroid alone.
ForceIntegral::Estimate ForceIntegral::estimate_whole(const Polygon& polygon, double radius) {
  const ContactPolygon& p = *polygon.polygon;
  const dvec3 u = any_perpendicular(p.normal), v = glm::cross(p.normal, u);
  double uu = 0, uv = 0, vv = 0;
  for_each_triangle(*polygon.surface, p, [&](const dvec3& a, const dvec3& b, const dvec3& c, double area) {
    dvec2 sum(0);
    for (const dvec3& corner : {a, b, c}) {
      const dvec2 x(glm::dot(corner - p.centroid, u), glm::dot(corner - p.centroid, v));
      uu += area * x.x * x.x, uv += area * x.x * x.y, vv += area * x.y * x.y;
      sum += x;
    }
    uu += area * sum.x * sum.x, uv += area * sum.x * sum.y, vv += area * sum.y * sum.y;
  });
  const double scale = 1 / (12 * p.area);
  const std::array<dvec2, 3> offsets = three_points(uu * scale, uv * scale, vv * scale);
  std::array<Node, 4> nodes{{{p.centroid, 0.0, 1.0}, {}, {}, {}}};
  for (std::size_t i = 1; i < 4; ++i)
    nodes[i] = {p.centroid + offsets[i - 1].x * u + offsets[i - 1].y * v, 1.0 / 3, 0.0};
  return estimate(polygon, nodes, p.area, radius);
}

ForceIntegral::Share& ForceIntegral::share_of(std::uint32_t first, int taxel) {
  for (std::size_t i = first; i < shares_.size(); ++i)
    if (shares_[i].taxel == taxel) return shares_[i];
  return shares_.emplace_back(Share{taxel, 0, 0, dvec3(0)});
}

void ForceIntegral::take(const Polygon& polygon, const Estimate& e) {
  const dvec3& n = polygon.polygon->normal;
  for (std::uint32_t i = e.first; i < e.end; ++i) {
    const Share& share = shares_[i];
    out_->values[at(share.taxel)] += share.value;
    out_->normal[at(share.taxel)] += share.value * n;
    out_->friction[at(share.taxel)] += share.friction;
  }
  out_->covered += e.covered;
  out_->uncovered += e.whole - e.covered;
  out_->uncovered_normal += (e.whole - e.covered) * n;
}

void ForceIntegral::refine(const Polygon& polygon, const Triangle& triangle, double tolerance) {
  for (int i = 0; i < 4; ++i) settle(polygon, triangle.child(i), tolerance);
}

void ForceIntegral::settle(const Polygon& polygon, const Triangle& triangle, double tolerance) {
  Estimate e = estimate(polygon, triangle);
  if (e.error > tolerance && triangle.level < kMaxForceLevel) {
    shares_.resize(e.first);
    e = cut(polygon, triangle);
  }
  const bool fine = e.error <= tolerance || triangle.level >= kMaxForceLevel;
  if (fine) take(polygon, e);
  shares_.resize(e.first);
  if (!fine) refine(polygon, triangle, tolerance);
}

void ForceIntegral::settle(const Leaf& leaf, double tolerance) {
  const Polygon& polygon = polygons_[leaf.polygon];
  if (leaf.estimate.error <= tolerance) {
    take(polygon, leaf.estimate);
  } else if (!leaf.whole) {
    refine(polygon, leaf.triangle, tolerance);
  } else if (!for_each_part(polygon, [&](const Triangle& triangle) { settle(polygon, triangle, tolerance); })) {
    take(polygon, leaf.estimate);
  }
}

/// Adds triangles that are at most as large as the smallest field nearby.
void ForceIntegral::add_leaves(const Triangle& triangle, double largest_edge) {
  if (triangle.level < kMaxForceLevel / 2 && longest_edge_of_piece(triangle.corners) > largest_edge) {
    for (int i = 0; i < 4; ++i) add_leaves(triangle.child(i), largest_edge);
    return;
  }
  const auto polygon = static_cast<std::uint32_t>(polygons_.size() - 1);
  leaves_.push_back({triangle, polygon, false, estimate(polygons_.back(), triangle)});
}

void ForceIntegral::add_polygon(const ContactSurface& surface, const ContactPolygon& polygon,
                                const SurfaceMotion* motion) {
  const double force = polygon.area * polygon.pressure;
  if (!(force > 0)) return;
  double radius = 0;
  for (int i = 0; i < polygon.count; ++i)
    radius = std::max(radius, glm::distance(surface.vertices[at(polygon.first + i)], polygon.centroid));
  Polygon& p = polygons_.emplace_back(Polygon{&surface, &polygon, motion, radius});
  if (polygon.tet >= 0) {
    if (at(polygon.tet) >= face_of_tet_.size()) face_of_tet_.resize(at(polygon.tet) + 1, -1);
    if (face_of_tet_[at(polygon.tet)] >= 0) face_ = face_of_tet_[at(polygon.tet)];
  }
  double smallest = std::numeric_limits<double>::infinity();
  if (fields_->nearest->closest_point(polygon.centroid, face_).face >= 0)
    smallest = fields_->faces.range(face_).least_radius;
  if (polygon.tet >= 0) face_of_tet_[at(polygon.tet)] = face_;
  if (!std::isfinite(smallest)) smallest = fields_->weights->smallest_radius(discs_near(polygon, radius));
  const auto number = static_cast<std::uint32_t>(polygons_.size() - 1);
  if (!std::isfinite(smallest)) {  // no field is near
    const auto none = static_cast<std::uint32_t>(shares_.size());
    leaves_.push_back({{}, number, true, {none, none, 0, force, 0}});
  } else if (radius <= kSmallPolygon * smallest ||
             !for_each_part(p, [&](const Triangle& triangle) { add_leaves(triangle, smallest); })) {
    leaves_.push_back({{}, number, true, estimate_whole(p, radius)});
  }
}

/// Calls f with the triangles of a polygon's fan. Their force is made the polygon's, from which rounding and merged
/// corners may have moved it a little. False, without a call, where merging left a sliver no triangle.
template <class F>
bool ForceIntegral::for_each_part(const Polygon& p, const F& f) {
  const double force = p.polygon->area * p.polygon->pressure;
  double sum = 0;
  for_each_triangle(*p.surface, *p.polygon, [&](const dvec3& a, const dvec3& b, const dvec3& c, double area) {
    sum += area * p.pressure((a + b + c) / 3.0);
  });
  if (!(sum > 0.5 * force)) return false;
  for_each_triangle(*p.surface, *p.polygon, [&](const dvec3& a, const dvec3& b, const dvec3& c, double area) {
    f(Triangle{{a, b, c}, area * (force / sum), 0});
  });
  return true;
}

void ForceIntegral::integrate(const SensorModel& model, const SkinFields& fields,
                              std::span<const ContactSurface* const> surfaces, std::span<const SurfaceMotion> motions,
                              ForceReading& out) {
  model_ = &model, fields_ = &fields, out_ = &out;
  const std::size_t taxels = at(model.taxel_count());
  out.values.assign(taxels, 0.0);
  out.normal.assign(taxels, dvec3(0));
  out.friction.assign(taxels, dvec3(0));
  out.covered = out.uncovered = 0;
  out.uncovered_normal = dvec3(0);
  out.evaluations = 0;
  polygons_.clear(), leaves_.clear(), shares_.clear();
  face_ = -1, near_of_ = nullptr;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (surfaces[i] == nullptr) continue;
    for (const ContactPolygon& polygon : surfaces[i]->polygons)
      add_polygon(*surfaces[i], polygon, motions.empty() ? nullptr : &motions[i]);
  }
  double covered = 0, whole = 0;
  for (const Leaf& leaf : leaves_) covered += leaf.estimate.covered, whole += leaf.estimate.whole;
  const double tolerance = kTrianglePart * kAccuracy * std::max(covered, kLeastForcePart * whole);
  for (const Leaf& leaf : leaves_) settle(leaf, tolerance);
}

bool ForceIntegral::covered() const {
  return std::any_of(at_.weights.begin(), at_.weights.end(), [](const FieldWeights::Weight& w) { return w.value > 0; });
}

/// Returns the edge of the fields between a point inside and a point outside, by the regula falsi on the margin
/// (Illinois variant). Returns nothing if the margin jumps there, as at a face that is turned away too far.
std::optional<dvec3> ForceIntegral::edge_of_cover(const Polygon& polygon, dvec3 inside, double inner, dvec3 outside,
                                                  double outer) {
  constexpr int kMost = 10;
  constexpr double kNear = 0.002;
  const double near = kNear * glm::distance(inside, outside);
  int side = 0;
  for (int i = 0; i < kMost; ++i) {
    const double part = outer < 0 && std::isfinite(outer) ? inner / (inner - outer) : 0.5;
    const dvec3 x = inside + part * (outside - inside);
    evaluate(polygon, x);
    if (std::abs(at_.margin) <= near) return x;
    if (covered()) {
      if (side > 0) outer *= 0.5;
      inside = x, inner = at_.margin, side = 1;
    } else {
      if (side < 0) inner *= 0.5;
      outside = x, outer = at_.margin, side = -1;
    }
  }
  return std::nullopt;
}

/// Adds the shares of a covered triangle to the shares of `e`, and its force to `pushed`, by the rule of degree 2.
void ForceIntegral::share_out(const Polygon& polygon, const std::array<dvec3, 3>& c, double area, Estimate& e,
                              double& pushed) {
  for (std::size_t i = 0; i < 3; ++i) {
    const dvec3 x = (c[0] + c[1] + c[2] + 3.0 * c[i]) / 6.0;
    evaluate(polygon, x);
    double sum = 0;
    for (const FieldWeights::Weight& w : at_.weights) sum += w.value;
    if (!(sum > 0)) continue;
    const double pressure = polygon.pressure(x);
    pushed += area / 3 * pressure;
    dvec3 friction(0);
    if (polygon.motion != nullptr) friction = polygon.motion->friction(pressure, polygon.polygon->normal, x);
    for (const FieldWeights::Weight& w : at_.weights) {
      Share& share = share_of(e.first, w.taxel);
      share.value += area / 3 * (at_.cover * w.value / sum) * pressure;
      share.friction += area / 3 * (at_.cover * w.value / sum) * friction;
    }
  }
}

/// Integrates a triangle whose corner `lone` is the only covered one, or the only one that is not covered, cut along
/// the chord of the edge of the fields. The margin at the chord's middle is the height of the edge over the chord; the
/// covered area is larger by two thirds of the product of chord and height.
ForceIntegral::Estimate ForceIntegral::cut_at(const Polygon& polygon, const Triangle& triangle, int lone,
                                              bool lone_covered, const std::array<double, 3>& margins) {
  constexpr double kLeftOver = 0.3, kFlat = 0.25;  // error as a fraction of the correction; largest height over chord
  Estimate e;
  e.first = e.end = static_cast<std::uint32_t>(shares_.size());
  e.error = std::numeric_limits<double>::infinity();
  const std::size_t l = at(lone), n = (l + 1) % 3, m = (l + 2) % 3;
  const auto& c = triangle.corners;
  const auto find = [&](std::size_t other) {
    const std::size_t in = lone_covered ? l : other, out = lone_covered ? other : l;
    return edge_of_cover(polygon, c[in], margins[in], c[out], margins[out]);
  };
  const std::optional<dvec3> a = find(n), b = a ? find(m) : std::nullopt;
  if (!b) return e;
  const dvec3 middle = 0.5 * (*a + *b);
  evaluate(polygon, middle);
  const double chord = glm::distance(*a, *b), height = at_.margin;
  if (!(std::abs(height) <= kFlat * chord)) return e;
  const double scale = triangle.area / glm::length(glm::cross(c[1] - c[0], c[2] - c[0]));  // divides twice an area
  const auto area_of = [&](const std::array<dvec3, 3>& t) {
    return scale * glm::length(glm::cross(t[1] - t[0], t[2] - t[0]));
  };
  const std::array<dvec3, 3> tip{c[l], *a, *b}, near{*a, c[n], c[m]}, far{*a, c[m], *b};
  const auto force_of = [&](const std::array<dvec3, 3>& t) {
    return area_of(t) * polygon.pressure((t[0] + t[1] + t[2]) / 3.0);
  };
  const double correction = 2.0 / 3 * 2 * scale * chord * height * polygon.pressure(middle);
  e.whole = triangle.area * polygon.pressure((c[0] + c[1] + c[2]) / 3.0);
  e.covered = correction + (lone_covered ? force_of(tip) : e.whole - force_of(tip));
  double pushed = 0;
  if (lone_covered) {
    share_out(polygon, tip, area_of(tip), e, pushed);
  } else {
    share_out(polygon, near, area_of(near), e, pushed);
    share_out(polygon, far, area_of(far), e, pushed);
  }
  e.end = static_cast<std::uint32_t>(shares_.size());
  if (!(pushed > 0) || !(e.covered >= 0)) return e;
  const double scaled = e.covered / pushed;
  e.covered = 0;
  for (std::uint32_t i = e.first; i < e.end; ++i) {
    shares_[i].value *= scaled;
    shares_[i].friction *= scaled;
    e.covered += shares_[i].value;
  }
  e.error = kLeftOver * std::abs(correction);
  return e;
}

/// Integrates a triangle at the edge of the fields. The error is infinite unless the edge separates one corner from the
/// other two.
ForceIntegral::Estimate ForceIntegral::cut(const Polygon& polygon, const Triangle& triangle) {
  std::array<double, 3> margins{};
  std::array<bool, 3> in{};
  for (std::size_t i = 0; i < 3; ++i) {
    evaluate(polygon, triangle.corners[i]);
    margins[i] = at_.margin;
    in[i] = covered();
  }
  for (int i = 0; i < 3; ++i)
    if (in[at(i)] != in[at((i + 1) % 3)] && in[at(i)] != in[at((i + 2) % 3)])
      return cut_at(polygon, triangle, i, in[at(i)], margins);
  const auto none = static_cast<std::uint32_t>(shares_.size());
  return {none, none, 0, 0, std::numeric_limits<double>::infinity()};
}

}  // namespace taxel
