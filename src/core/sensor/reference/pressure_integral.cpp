// The steps of the integral that pressure_integral.h defines:
//
// 1. Each polygon is projected to the faces of the prisms that its tet intersects, cut at their sides and at the
//    allowed depth, and kept as a piece: corners in the face's plane, with a linear depth and pressure.
// 2. Pieces of one surface and one orientation do not overlap in a prism, since a ray passes a closed surface
//    alternately inward and outward. Where a prism has pieces of several kinds, the part of a piece that is inside of
//    another one and deeper is hidden, and its integral is subtracted.
// 3. A piece is integrated over each disc: for `mean` exactly by the moments of its part inside of the disc
//    (moments.h), with weights by one point, three points or a rule of degree 4, as the piece is small against the
//    smallest field.
//
// Cost: in proportion to the pieces times the fields at a face. Pitfalls: a piece that is nearly along the rays has no
// depth function (kEdgeOn), and slivers are dropped (kSliver). The points of rules decide about the inside of a field
// one by one, so finer parts are used where the field has no weight that falls to 0. Theory: docs/theory/sensor.md,
// "Exact means".
#include "core/sensor/reference/pressure_integral.h"

#include <limits>

#include "core/base/math.h"
#include "core/hydro/quadrature.h"
#include "core/sensor/reference/moments.h"

namespace taxel {
namespace {

/// Largest circumradius of a piece that its centroid integrates, of one that three points integrate, and of a triangle
/// that six points integrate, as fractions of the smallest field. A third one applies where points decide about the
/// inside of a field.
constexpr double kTinyPiece = 0.04, kSmallPiece = 0.12, kSmallTriangle = 0.2, kFinePiece = 0.06;
constexpr double kDeeper = 1e-9;          // least difference of depths that hides, as a fraction of the rays' length
constexpr std::size_t kManyCorners = 64;  // more than pieces have, so that no later step allocates
constexpr double kSliver = 1e-8;  // smallest area of a piece as a fraction of the square of its polygon's radius
constexpr double kEdgeOn = 1e-9;  // smallest |cos| between a polygon's normal and the rays

double twice_area(std::span<const dvec2> corners) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const dvec2 b = corners[i] - corners[0], c = corners[i + 1] - corners[0];
    sum += b.x * c.y - b.y * c.x;
  }
  return sum;
}

double value_at(const dvec3& linear, const dvec2& q) {
  return linear.x + linear.y * q.x + linear.z * q.y;
}

}  // namespace

/// Replaces part_ by its part on the inner side of a line. Returns false if nothing is left.
bool PressureIntegral::cut(const FaceLine& line) {
  const std::size_t count = part_.size();
  values_.resize(count + 1);
  std::size_t inside = 0;
  for (std::size_t i = 0; i < count; ++i) {
    values_[i] = line(part_[i]);
    inside += values_[i] >= 0 ? 1 : 0;
  }
  if (inside == count) return count > 0;
  if (inside == 0) return false;
  values_[count] = values_[0];
  part_.push_back(part_[0]);
  next_.resize(2 * count);  // an edge adds at most two corners
  dvec2* out = next_.data();
  for (std::size_t i = 0; i < count; ++i) {
    const double from = values_[i], to = values_[i + 1];
    if (from >= 0) *out++ = part_[i];
    if ((from >= 0) != (to >= 0)) *out++ = part_[i] + from / (from - to) * (part_[i + 1] - part_[i]);
  }
  next_.resize(static_cast<std::size_t>(out - next_.data()));
  std::swap(part_, next_);
  return true;
}

void PressureIntegral::add_piece(int surface, const ContactPolygon& polygon, double radius, std::int32_t number) {
  const RayPrism& prism = fields_->prisms->prisms()[at(number)];
  const FacePlane& plane = prism.plane;
  const double cosine = glm::dot(polygon.normal, plane.outward);
  if (!(std::abs(cosine) > kEdgeOn)) return;
  const dvec2 middle = plane.project(polygon.centroid);
  std::array<bool, 3> crossed{};
  for (std::size_t e = 0; e < 3; ++e) {
    const double distance = prism.edges[e](middle);
    if (distance < -radius) return;
    crossed[e] = distance < radius;
  }
  // The plane of the polygon is at depth [0] + [1] u + [2] v below the face.
  const dvec3 from = plane.origin - polygon.centroid;
  const dvec3 depth =
      dvec3(glm::dot(polygon.normal, from), glm::dot(polygon.normal, plane.e1), glm::dot(polygon.normal, plane.e2)) /
      cosine;
  const double most = fields_->prisms->depth(), lead = fields_->prisms->lead();
  const dvec3* corners = surfaces_[at(surface)]->vertices.data() + polygon.first;
  part_.clear();
  double deepest = -std::numeric_limits<double>::infinity(), highest = -deepest;
  for (int i = 0; i < polygon.count; ++i) {
    const dvec2& q = part_.emplace_back(plane.project(corners[i]));
    const double below = value_at(depth, q);
    deepest = std::max(deepest, below), highest = std::min(highest, below);
  }
  if (deepest < -lead || highest > most) return;
  for (std::size_t e = 0; e < 3; ++e)
    if (crossed[e] && !cut(prism.edges[e])) return;
  if (highest < -lead && !cut({{depth.y, depth.z}, depth.x + lead})) return;
  if (deepest > most && !cut({{-depth.y, -depth.z}, most - depth.x})) return;
  if (!(std::abs(twice_area(part_)) > kSliver * radius * radius)) return;
  Piece piece{static_cast<std::uint32_t>(corners_.size()), 0, number, -1, surface, &polygon, {}, depth};
  const double along = glm::dot(polygon.gradient, plane.outward);
  piece.pressure = dvec3(polygon.pressure + glm::dot(polygon.gradient, from), glm::dot(polygon.gradient, plane.e1),
                         glm::dot(polygon.gradient, plane.e2)) -
                   along * depth;
  corners_.insert(corners_.end(), part_.begin(), part_.end());
  piece.end = static_cast<std::uint32_t>(corners_.size());
  OfPrism& all = of_prisms_[at(number)];
  const std::int32_t kind = 2 * surface + (cosine > 0 ? 1 : 0);
  if (all.last < 0) touched_.push_back(number), all.kind = kind;
  all.mixed = all.mixed || all.kind != kind;
  piece.next = all.last;
  all.last = static_cast<std::int32_t>(pieces_.size());
  pieces_.push_back(piece);
}

void PressureIntegral::add_polygon(int surface, const ContactPolygon& polygon) {
  if (!(polygon.area > 0)) return;
  const RayPrisms& prisms = *fields_->prisms;
  Aabb box;
  double radius2 = 0;
  for (int i = 0; i < polygon.count; ++i) {
    const dvec3& x = surfaces_[at(surface)]->vertices[at(polygon.first + i)];
    const dvec3 away = x - polygon.centroid;
    radius2 = std::max(radius2, glm::dot(away, away));
    box.include(x);
  }
  const double radius = std::sqrt(radius2);
  if (prisms.has(polygon.tet)) {
    const dvec3& c = polygon.centroid;
    const std::array<float, 3> middle{static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z)};
    const auto reach = static_cast<float>(radius + prisms.slack());
    for (const RayPrisms::InTet& in_tet : prisms.of_tet(polygon.tet))
      if (in_tet.may_reach(middle, reach)) add_piece(surface, polygon, radius, in_tet.prism);
    return;
  }
  near_.clear();
  prisms.visit_near(box, [&](std::int32_t number) { near_.push_back(number); });
  std::sort(near_.begin(), near_.end());
  for (const std::int32_t number : near_) add_piece(surface, polygon, radius, number);
}

void PressureIntegral::add(std::size_t taxel, double weight, double pressure, const dvec3& friction) {
  out_->pressure[taxel] += weight * pressure;
  out_->hit[taxel] += weight;
  if (!motions_.empty()) out_->friction[taxel] += weight * friction;
}

/// Adds a point of the face that stands for an area of it.
void PressureIntegral::add_point(const Piece& piece, const dvec2& q, double area) {
  const RayPrism& prism = fields_->prisms->prisms()[at(piece.prism)];
  const double depth = value_at(piece.depth, q);
  if (depth > prism.free_depth && depth > fields_->prisms->end_of_ray(prism, q)) return;
  ++out_->points;
  const FaceFields& faces = fields_->faces;
  const FaceFields::Range& range = faces.range(prism.face);
  faces.at(prism.face, q, at_);
  const double pressure = std::max(0.0, value_at(piece.pressure, q));
  dvec3 friction(0);
  if (!motions_.empty())
    friction = motions_[at(piece.surface)].friction(pressure, piece.polygon->normal,
                                                    prism.plane.point(q) - depth * prism.plane.outward);
  for (std::size_t i = 0; i < range.count(); ++i) {
    const double left = faces.radius(range.first + i) - at_.away[i];
    if (!(left >= 0 && at_.facing[i] > 0)) continue;
    if (range.subtaxels && !faces.is_nearest(range, i, at_)) continue;
    const double weight = weighted_ ? left * left * at_.facing[i] : 1.0;
    add(at(faces.taxel(range.first + i)), area * weight, pressure, friction);
  }
}

/// Integrates a triangle by points, in four parts while it is larger than `largest`.
void PressureIntegral::integrate_triangle(const Piece& piece, const std::array<dvec2, 3>& corners, double area,
                                          double largest) {
  const auto& [a, b, c] = corners;
  const dvec2 middle = (a + b + c) / 3.0;
  if (std::max({glm::distance(middle, a), glm::distance(middle, b), glm::distance(middle, c)}) <= largest) {
    for (const QuadraturePoint& q : kTriangleDegree4)
      add_point(piece, q.u * a + q.v * b + (1 - q.u - q.v) * c, q.weight * area);
    return;
  }
  const dvec2 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
  for (const std::array<dvec2, 3>& part :
       {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}, std::array{bc, ca, ab}})
    integrate_triangle(piece, part, 0.25 * area, largest);
}

/// Integrates a piece by points: three points if it is small, otherwise the triangles of its fan.
void PressureIntegral::integrate_points(const Piece& piece, std::span<const dvec2> corners, double sign) {
  const RayPrism& prism = fields_->prisms->prisms()[at(piece.prism)];
  const double field = fields_->faces.range(prism.face).least_radius;
  const bool fine = !weighted_;
  double twice = 0, uu = 0, uv = 0, vv = 0;
  dvec2 middle(0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const dvec2 b = corners[i] - corners[0], c = corners[i + 1] - corners[0], sum = b + c;
    const double area = b.x * c.y - b.y * c.x;
    twice += area;
    middle += area * sum;
    uu += area * (b.x * b.x + c.x * c.x + sum.x * sum.x);
    uv += area * (b.x * b.y + c.x * c.y + sum.x * sum.y);
    vv += area * (b.y * b.y + c.y * c.y + sum.y * sum.y);
  }
  if (!(std::abs(twice) > 0)) return;
  middle /= 3 * twice;
  const dvec2 centroid = corners[0] + middle;
  double radius = 0;
  for (const dvec2& q : corners) radius = std::max(radius, glm::distance(q, centroid));
  if (radius <= kTinyPiece * field) return add_point(piece, centroid, sign * 0.5 * std::abs(twice));
  if (!fine && radius <= kSmallPiece * field) {
    const double scale = 1 / (12 * twice), third = sign * std::abs(twice) / 6;
    for (const dvec2& offset : three_points(uu * scale - middle.x * middle.x, uv * scale - middle.x * middle.y,
                                            vv * scale - middle.y * middle.y))
      add_point(piece, centroid + offset, third);
    return;
  }
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const std::array<dvec2, 3> triangle{corners[0], corners[i], corners[i + 1]};
    integrate_triangle(piece, triangle, sign * 0.5 * std::abs(twice_area(triangle)),
                       (fine ? kFinePiece : kSmallTriangle) * field);
  }
}

/// Integrates the exact parts of a piece inside of the discs.
void PressureIntegral::integrate_disc_parts(const Piece& piece, std::span<const dvec2> corners, double sign) {
  const RayPrism& prism = fields_->prisms->prisms()[at(piece.prism)];
  const FaceFields& faces = fields_->faces;
  const FaceFields::Range& range = faces.range(prism.face);
  for (std::size_t i = range.first; i < range.end; ++i) {
    const dvec3 center = faces.center(i);
    const double radius2 = faces.radius(i) * faces.radius(i) - center.z;
    if (!(radius2 > 0)) continue;
    const dvec2 c(center);
    DiscMoments moments = disc_moments(corners, c, std::sqrt(radius2));
    if (moments.area < 0) moments.area = -moments.area, moments.first = -moments.first;
    if (!(moments.area > 0)) continue;
    ++out_->points;
    const dvec2 middle = c + moments.first / moments.area;
    const double pressure = std::max(0.0, value_at(piece.pressure, middle));
    dvec3 friction(0);
    if (!motions_.empty()) {
      const double depth = value_at(piece.depth, middle);
      friction = motions_[at(piece.surface)].friction(pressure, piece.polygon->normal,
                                                      prism.plane.point(middle) - depth * prism.plane.outward);
    }
    add(at(faces.taxel(i)), sign * moments.area, pressure, friction);
  }
}

/// Integrates a part of a piece, which counts as often as `sign`.
void PressureIntegral::integrate_part(const Piece& piece, std::span<const dvec2> corners, double sign) {
  const RayPrism& prism = fields_->prisms->prisms()[at(piece.prism)];
  const bool all_free = prism.free_depth >= fields_->prisms->depth() ||
                        std::all_of(corners.begin(), corners.end(),
                                    [&](const dvec2& q) { return value_at(piece.depth, q) <= prism.free_depth; });
  const bool exact_discs =
      !weighted_ && fields_->faces.flat() && !fields_->faces.range(prism.face).subtaxels && all_free;
  if (exact_discs) {
    integrate_disc_parts(piece, corners, sign);
  } else {
    integrate_points(piece, corners, sign);
  }
}

/// Subtracts the parts of a piece that other pieces of its prism hide. Two pieces of one kind do not overlap: between
/// two passages of a ray through a closed surface in one direction there is one in the other direction.
void PressureIntegral::subtract_hidden(const Piece& piece) {
  const auto own = std::span(corners_).subspan(piece.first, piece.end - piece.first);
  const auto kind_of = [&](const Piece& p) {
    const dvec3& outward = fields_->prisms->prisms()[at(p.prism)].plane.outward;
    return std::pair(p.surface, glm::dot(p.polygon->normal, outward) > 0);
  };
  for (std::int32_t i = of_prisms_[at(piece.prism)].last; i >= 0; i = pieces_[at(i)].next) {
    const Piece& other = pieces_[at(i)];
    if (kind_of(other) == kind_of(piece)) continue;
    const auto corners = std::span(corners_).subspan(other.first, other.end - other.first);
    const double turn = twice_area(corners) > 0 ? 1.0 : -1.0;
    // The part that is inside of the other piece and deeper.
    part_.assign(own.begin(), own.end());
    const dvec3 deeper = piece.depth - other.depth;
    bool left = cut({{deeper.y, deeper.z}, deeper.x - kDeeper * fields_->prisms->depth()});
    for (std::size_t c = 0; c < corners.size() && left; ++c) {
      const dvec2 along = turn * (corners[c + 1 < corners.size() ? c + 1 : 0] - corners[c]);
      const dvec2 inward(-along.y, along.x);
      left = cut({inward, -glm::dot(inward, corners[c])});
    }
    if (left && part_.size() > 2) integrate_part(piece, part_, -1.0);
  }
}

void PressureIntegral::integrate(const Piece& piece) {
  integrate_part(piece, std::span(corners_).subspan(piece.first, piece.end - piece.first), 1.0);
  if (of_prisms_[at(piece.prism)].mixed) subtract_hidden(piece);
}

void PressureIntegral::integrate(const SkinFields& fields, int taxels, bool weighted,
                                 std::span<const ContactSurface* const> surfaces,
                                 std::span<const SurfaceMotion> motions, PressureSums& out) {
  fields_ = &fields, out_ = &out, surfaces_ = surfaces, motions_ = motions, weighted_ = weighted;
  out.pressure.assign(at(taxels), 0.0);
  out.hit.assign(at(taxels), 0.0);
  out.friction.assign(at(taxels), dvec3(0));
  out.points = 0;
  of_prisms_.resize(fields.prisms->prisms().size());
  for (const std::int32_t number : touched_) of_prisms_[at(number)] = {};
  touched_.clear(), pieces_.clear(), corners_.clear();
  part_.reserve(kManyCorners), next_.reserve(kManyCorners), values_.reserve(kManyCorners);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (surfaces[i] == nullptr) continue;
    for (const ContactPolygon& polygon : surfaces[i]->polygons) add_polygon(static_cast<int>(i), polygon);
  }
  for (const Piece& piece : pieces_) integrate(piece);
}

std::vector<double> PressureIntegral::of_whole_fields(const SkinFields& fields, int taxels, bool weighted) {
  PressureIntegral integral;
  PressureSums sums;
  integral.integrate(fields, taxels, weighted, {}, {}, sums);
  integral.of_prisms_.resize(fields.prisms->prisms().size());
  static const ContactPolygon none;
  for (std::size_t i = 0; i < fields.prisms->prisms().size(); ++i) {
    const FacePlane& plane = fields.prisms->prisms()[i].plane;
    integral.corners_ = {dvec2(0), dvec2(plane.second, 0), plane.third};
    Piece piece;
    piece.end = 3, piece.prism = static_cast<std::int32_t>(i), piece.polygon = &none;
    integral.integrate(piece);
  }
  return sums.hit;
}

}  // namespace taxel
