// Contact of a rigid surface beyond the tets of a pad, where p = (E/H) D and D is the distance to the skin.
//
// D is not linear, but a contact polygon needs a linear pressure. So a facet, or the plane of a half-space, is divided
// until D is nearly linear on each piece:
//
//    +-------+---+---+     Facets are divided into quarters by the middles of their edges. Corners are points of an
//    |       |   |   |     integer lattice of the facet, so pieces share corners exactly and each D is computed once.
//    |       +---+---+     Elongated facets are cut across their length instead: quarters would be as narrow as they
//    |       |   |   |     are short, and their number would be the square of the number of strips.
//    +-------+---+---+
//
// 1. A piece is dropped if it is outside of the body (D is 1-Lipschitz) or if polygons of the tets cover it.
// 2. It is divided while D deviates by more than the tolerance from linear and the piece is longer than the shortest
//    edge, or while it is longer than the longest edge allowed.
// 3. Otherwise the part that the polygons of the tets leave (covered_region.h) gets the linear pressure whose mean is
//    that of a quadratic D, so that the force of such a D is exact.
//
// Cost: one value of D per corner and middle of an edge, each a search among the faces near it (nearest.h). Pitfalls:
// lengths are multiplied by kNoTie, or rounding would decide comparisons with round sizes. A hole shallower than half
// the tolerance is an error of D and is left out. Theory: docs/theory/hydro.md, "Beyond the tets".
#include "core/hydro/kernel/depth_pieces.h"

#include "core/base/math.h"

namespace taxel {

CoveredRegion::Ends ends_of(const PackedTet& tet, std::span<const dvec3> x) {
  constexpr double kOnFace = 1e-5;  // of the tet's size: ten times the distance below which vertices are merged
  CoveredRegion::Ends ends;
  for (std::size_t face = 0; face < 4; ++face) {
    if (tet.neighbour[face] >= 0) continue;
    const bool is_skin = (tet.core_faces >> face & 1u) == 0;
    const dvec3 normal(tet.nx[face], tet.ny[face], tet.nz[face]);
    const auto on_face = [&](std::size_t i) {
      return std::abs(glm::dot(normal, x[i]) + tet.offset[face]) <= kOnFace * tet.size;
    };
    bool before = on_face(0);
    for (std::size_t k = 0; k < x.size(); ++k) {
      const bool after = on_face((k + 1) % x.size());
      if (before && after) {
        ends.all |= 1u << k;
        if (is_skin) ends.at_skin |= 1u << k;
      }
      before = after;
    }
  }
  return ends;
}

namespace {

constexpr double kClipped = 0.5;  // tolerances: a shallower hole is an error of D, not a hole
/// A factor of lengths: sizes of bodies are rarely multiples of them then, so that no rounding decides.
constexpr double kNoTie = 1.0137;
constexpr double kCutEdge = 2;    // thicknesses: longest edge of a piece that the skin cuts
constexpr double kLongEdge = 8;   // thicknesses: longest edge of any piece
constexpr double kElongated = 4;  // shortest edges: a longer piece is cut across, not quartered

}  // namespace

PlanePieces::PlanePieces(const DepthFieldPtr& depth, const FieldIndex& tets, const DepthPieceSize& size,
                         const LatticePlane& plane, SurfaceWriter& writer, DepthWorkspace& workspace)
    : depth_(*depth),
      near_(workspace.near_faces(depth)),
      tets_(tets),
      plane_(plane),
      per_unit_(1.0 / plane.units),
      u_(plane.triangle.x_S[1] - plane.triangle.x_S[0]),
      v_(plane.triangle.x_S[2] - plane.triangle.x_S[0]),
      unit_area_(2 * plane.triangle.area),
      least_depth_(kClipped * size.tolerance * depth_.thickness()),
      tolerance_(kNoTie * size.tolerance * depth_.thickness()),
      min_edge_(kNoTie * size.min_edge * depth_.thickness()),
      writer_(writer),
      w_(workspace),
      body_(depth_.skin()->bounds()) {
  w_.samples.begin();
  w_.covered.clear();
}

void PlanePieces::cover(std::size_t first, std::size_t last) {
  const ContactSurface& surface = writer_.surface();
  const SurfaceTriangle& triangle = plane_.triangle;
  const PlaneMetric& m = triangle.metric;
  const double determinant = m.uu * m.vv - m.uv * m.uv;
  for (std::size_t p = first; p < last; ++p) {
    const ContactPolygon& polygon = surface.polygons[p];
    FlatPolygon flat;
    flat.count = std::min(polygon.count, FlatPolygon::kMaxStored);
    std::array<dvec3, FlatPolygon::kMaxStored> x_S;
    for (int k = 0; k < flat.count; ++k) {
      const int from = writer_.reverse() ? flat.count - 1 - k : k;
      const dvec3& x_A = surface.vertices[at(polygon.first + from)];
      const double a = glm::dot(x_A - triangle.origin_A, triangle.u_A);
      const double b = glm::dot(x_A - triangle.origin_A, triangle.v_A);
      flat.x[at(k)] = dvec2(m.vv * a - m.uv * b, m.uu * b - m.uv * a) / determinant;
      x_S[at(k)] = writer_.point_S(x_A);
    }
    w_.covered.add(flat, ends_of(tets_.tets()[at(polygon.tet)], {x_S.data(), at(flat.count)}));
  }
  all_ = w_.covered.list_all();
}

PlanePieces::Outline PlanePieces::outline_of(const LatticePolygon& polygon) const {
  Outline outline;
  outline.flat.count = polygon.count;
  for (std::size_t k = 0; k < at(polygon.count); ++k) {
    outline.flat.x[k] = plane_point(polygon.corner[k]);
    outline.x[k] = point(polygon.corner[k]);
  }
  return outline;
}

/// Returns D at a corner. The result is valid until the next call.
const DepthField::Sample& PlanePieces::sample(const LatticeCorner& c) {
  bool is_new = false;
  const std::uint64_t key = std::uint64_t{static_cast<std::uint32_t>(c.i)} << 32 | static_cast<std::uint32_t>(c.j);
  DepthField::Sample& found = w_.samples.at(key, is_new);
  if (is_new) found = DepthField::at(point(c), near_);
  return found;
}

/// Returns true if the body, by its grid of distances, is farther from the middle of a piece than its corners.
bool PlanePieces::is_far(std::span<const dvec3> x) const {
  dvec3 middle(0);
  for (const dvec3& corner : x) middle += corner / static_cast<double>(x.size());
  const double distance = tets_.grid().cell_of(middle).distance;
  return std::all_of(x.begin(), x.end(), [&](const dvec3& corner) { return glm::distance(corner, middle) < distance; });
}

/// `first` is a corner of the piece. The polygons near the piece are among those in `parent`.
PlanePieces::Left PlanePieces::left_of(const Outline& outline, const LatticeCorner& first,
                                       const CoveredRegion::List& parent) {
  Aabb box;
  for (const dvec3& corner : outline.corners()) box.include(corner);
  if (!box.overlaps(body_) || is_far(outline.corners())) return {};
  const CoveredRegion::List near = w_.covered.list_near(outline.flat, parent);
  const CoveredRegion::Cover cover = w_.covered.cover_of(outline.flat, near);
  if (cover == CoveredRegion::Cover::whole) return {};
  if (cover == CoveredRegion::Cover::part || tets_.grid().may_hold_gap(box)) return {false, cover, near};
  // Without a gap, a way through the piece into the body or out of it meets the end of a polygon at the skin.
  const bool is_outside = cover == CoveredRegion::Cover::up_to_skin || sample(first).depth < 0;
  return {is_outside, cover, near};
}

void PlanePieces::refine(const Piece& piece) {
  const std::size_t lists = w_.covered.lists_end();
  const Outline outline = outline_of(piece.polygon);
  const Left left = left_of(outline, piece.polygon.corner[0], piece.near);
  if (!left.nothing) refine_left(piece, outline, left);
  w_.covered.forget_lists(lists);
}

void PlanePieces::refine_left(const Piece& piece, const Outline& outline, const Left& left) {
  Depths d;
  switch (step_of(piece, outline, d)) {
    case Step::drop:
      return;
    case Step::halve:
      return halve(piece, left.near);
    case Step::divide:
      return divide(piece, d, left.near);
    case Step::keep:
      return keep(outline.flat, left.near, d);
  }
}

PlanePieces::Step PlanePieces::step_of(const Piece& piece, const Outline& outline, Depths& d) {
  const auto& c = piece.polygon.corner;
  d.count = at(piece.polygon.count);
  for (std::size_t k = 0; k < d.count; ++k) {
    d.edge[k] = glm::distance(outline.x[k], outline.x[(k + 1) % d.count]);
    d.longest = std::max(d.longest, d.edge[k]);
  }
  if (d.count == 4)
    d.longest =
        std::max({d.longest, glm::distance(outline.x[0], outline.x[2]), glm::distance(outline.x[1], outline.x[3])});
  if (piece.levels > 1 && d.longest > longest_piece(false)) return Step::divide;  // whatever D is
  double deepest = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < d.count; ++k) {
    d.at_corner[k] = sample(c[k]);
    deepest = std::max(deepest, d.at_corner[k].depth);
    // D is 1-Lipschitz: no point of the piece is deeper than this.
    if (d.at_corner[k].depth + d.longest < least_depth_) return Step::drop;
  }
  // No point of a triangle is farther from its nearest corner than L/sqrt(3), and a parallelogram is two triangles.
  if (deepest + d.longest / std::sqrt(3.0) < least_depth_) return Step::drop;
  for (std::size_t k = 0; k < d.count; ++k) d.at_middle[k] = sample(middle(c[k], c[(k + 1) % d.count]));
  if (piece.levels > 1 && must_divide(d)) return Step::divide;
  return d.count == 4 && is_cut(d) ? Step::halve : Step::keep;
}

/// Returns true if D is not nearly linear along the edges and in the middle, if it is twisted, or if the piece is too
/// large.
bool PlanePieces::must_divide(const Depths& d) const {
  double error = 0, bulge = 0;  // bulge: sum of the edges' deviations, which is twice the deviation in the middle
  for (std::size_t k = 0; k < d.count; ++k) {
    const double mean = 0.5 * (d.at_corner[k].depth + d.at_corner[(k + 1) % d.count].depth);
    error = std::max(error, std::abs(d.at_middle[k].depth - mean));
    bulge += d.at_middle[k].depth - mean;
  }
  if (d.count == 4) {
    const auto& c = d.at_corner;
    const double twist = 0.25 * std::abs(c[0].depth - c[1].depth + c[2].depth - c[3].depth);
    error = std::max({error, 0.5 * std::abs(bulge), twist});
  }
  return (d.longest > min_edge_ && error > tolerance_) || d.longest > longest_piece(is_cut(d));
}

/// Returns true if the skin cuts the piece.
bool PlanePieces::is_cut(const Depths& d) const {
  bool inside = false, outside = false;
  for (std::size_t k = 0; k < d.count; ++k) {
    for (const double depth : {d.at_corner[k].depth, d.at_middle[k].depth})
      (depth < least_depth_ ? outside : inside) = true;
  }
  return inside && outside;
}

/// Returns the largest length of a piece, which is shorter where the skin cuts it [m].
double PlanePieces::longest_piece(bool is_cut) const {
  return kNoTie * (is_cut ? kCutEdge : kLongEdge) * depth_.thickness();
}

/// Divides a parallelogram into two triangles.
void PlanePieces::halve(const Piece& piece, const CoveredRegion::List& near) {
  const auto& c = piece.polygon.corner;
  refine({{{c[0], c[1], c[2]}, 3}, piece.levels, near});
  refine({{{c[0], c[2], c[3]}, 3}, piece.levels, near});
}

void PlanePieces::divide(const Piece& piece, const Depths& d, const CoveredRegion::List& near) {
  const auto& c = piece.polygon.corner;
  std::size_t base = 0;  // the shortest edge
  for (std::size_t k = 1; k < d.count; ++k) base = d.edge[k] < d.edge[base] ? k : base;
  const std::size_t side = (base + 1) % d.count;
  if ((d.count == 3 ? d.longest : d.edge[side]) <= kElongated * d.edge[base]) return quarter(piece, near);
  const LatticeCorner &a = c[base], &b = c[side], &tip = c[(base + 2) % d.count];
  const LatticeStrips strips =
      d.count == 3 ? LatticeStrips{{tip, a}, {tip, b}, 1} : LatticeStrips{{b, tip}, {a, c[(base + 3) % d.count]}, 1};
  cut_across(strips, d.edge[side], d.edge[base], piece.levels, near);
}

void PlanePieces::quarter(const Piece& piece, const CoveredRegion::List& near) {
  const auto& c = piece.polygon.corner;
  const int levels = piece.levels - 1;
  const auto between = [&](std::size_t k) { return middle(c[k], c[(k + 1) % at(piece.polygon.count)]); };
  const LatticeCorner m0 = between(0), m1 = between(1), m2 = between(2);
  if (piece.polygon.count == 3) {
    refine({{{c[0], m0, m2}, 3}, levels, near});
    refine({{{m0, c[1], m1}, 3}, levels, near});
    refine({{{m2, m1, c[2]}, 3}, levels, near});
    refine({{{m1, m2, m0}, 3}, levels, near});
  } else {
    const LatticeCorner m3 = between(3), center = middle(c[0], c[2]);
    refine({{{c[0], m0, center, m3}, 4}, levels, near});
    refine({{{m0, c[1], m1, center}, 4}, levels, near});
    refine({{{center, m1, c[2], m2}, 4}, levels, near});
    refine({{{m3, center, m2, c[3]}, 4}, levels, near});
  }
}

void PlanePieces::cut_across(LatticeStrips strips, double long_edge, double width, int levels,
                             const CoveredRegion::List& near) {
  double length = 0.5 * long_edge;
  for (; strips.halvings < levels - 1 && length > width; length *= 0.5) ++strips.halvings;
  const std::int32_t half = 1 << (strips.halvings - 1);
  refine_strips(strips, 0, half, levels - strips.halvings, near);
  refine_strips(strips, half, 2 * half, levels - strips.halvings, near);
}

/// Halves the strips from `begin` to `end` while D is not nearly linear along them. `levels` are left in a strip.
void PlanePieces::refine_strips(const LatticeStrips& s, std::int32_t begin, std::int32_t end, int levels,
                                const CoveredRegion::List& parent) {
  const std::size_t lists = w_.covered.lists_end();
  const LatticeCorner a0 = s.on(s.a, begin), a1 = s.on(s.a, end), b0 = s.on(s.b, begin), b1 = s.on(s.b, end);
  const bool is_tip = begin == 0 && s.has_tip();
  const LatticePolygon whole{{a0, a1, b1, b0}, is_tip ? 3 : 4};
  const Outline outline = outline_of(whole);
  const Left left = left_of(outline, a0, parent);
  if (!left.nothing) {
    const Piece piece{whole, levels, left.near};
    if (end - begin > 1 && are_too_large(s, begin, end, left.cover)) {
      const std::int32_t between = begin + (end - begin) / 2;
      refine_strips(s, begin, between, levels, left.near);
      refine_strips(s, between, end, levels, left.near);
    } else if (is_tip || !s.has_tip()) {
      refine_left(piece, outline, left);
    } else {
      halve(piece, left.near);
    }
  }
  w_.covered.forget_lists(lists);
}

/// Returns true if D is not nearly linear along the two long sides of the strips from `begin` to `end`, or if that is
/// not worth knowing because the strips reach beyond the hole that they are to fill.
bool PlanePieces::are_too_large(const LatticeStrips& s, std::int32_t begin, std::int32_t end,
                                CoveredRegion::Cover cover) {
  double longest = 0;
  for (const LatticeStrips::LongEdge& side : {s.a, s.b}) {
    const LatticeCorner from = s.on(side, begin), to = s.on(side, end);
    longest = std::max(longest, glm::distance(point(from), point(to)));
  }
  if (longest > longest_piece(cover != CoveredRegion::Cover::none)) return true;
  double error = 0;
  bool inside = false, outside = false;
  for (const LatticeStrips::LongEdge& side : {s.a, s.b}) {
    const double from = sample(s.on(side, begin)).depth, to = sample(s.on(side, end)).depth;
    const double between = sample(s.on(side, begin + (end - begin) / 2)).depth;
    error = std::max(error, std::abs(between - 0.5 * (from + to)));
    for (const double depth : {from, to, between}) (depth < least_depth_ ? outside : inside) = true;
  }
  return (longest > min_edge_ && error > tolerance_) || longest > longest_piece(inside && outside);
}

namespace {

/// Returns the linear function that has the mean of D over the piece at its middle and the mean slopes of its edges.
/// The mean is that of a quadratic D through the samples; over a parallelogram with -1/12 of each corner and 1/3 of
/// each middle (the integrals of the shape functions of eight nodes: Zienkiewicz, Taylor 2000). So the force of a
/// quadratic D is exact.
PlanePressure linear_depth(const FlatPolygon& flat, std::size_t count, const std::array<double, 4>& corner,
                           double sum_of_middles) {
  const dvec2 a = flat.x[1] - flat.x[0], b = flat.x[count - 1] - flat.x[0];
  double da = corner[1] - corner[0], db = corner[count - 1] - corner[0], mean = sum_of_middles / 3;
  dvec2 center = flat.x[0] + (a + b) / 3.0;
  if (count == 4) {
    const double twist = corner[0] - corner[1] + corner[2] - corner[3];
    da += 0.5 * twist;
    db += 0.5 * twist;
    mean -= (corner[0] + corner[1] + corner[2] + corner[3]) / 12;
    center = flat.x[0] + 0.5 * (a + b);
  }
  const double area = cross_2d(a, b);
  PlanePressure p;
  p.pu = (da * b.y - db * a.y) / area;
  p.pv = (db * a.x - da * b.x) / area;
  p.p0 = mean - p.pu * center.x - p.pv * center.y;
  return p;
}

}  // namespace

/// Adds the part of a piece that the tets do not cover.
void PlanePieces::keep(const FlatPolygon& flat, const CoveredRegion::List& near, const Depths& d) {
  const FlatPolygon deep = clip_by_depth(flat, d);
  if (deep.count < 3) return;
  const double least = kMinPart * std::min(flat.area(), depth_.thickness() * depth_.thickness() / unit_area_);
  w_.rest.clear();
  w_.covered.add_rest(deep, near, least, w_.rest);
  if (w_.rest.empty()) return;
  std::array<double, 4> corner{};
  double sum_of_middles = 0;
  for (std::size_t k = 0; k < d.count; ++k) {
    corner[k] = d.at_corner[k].depth;
    sum_of_middles += d.at_middle[k].depth;
  }
  PlanePressure p = linear_depth(flat, d.count, corner, sum_of_middles);
  const double k = depth_.stiffness();
  p = {k * p.p0, k * p.pu, k * p.pv};
  const dvec3 gradient = gradient_of(p, d);
  for (const FlatPolygon& polygon : w_.rest)
    writer_.add_flat(polygon, plane_.triangle, p, gradient, plane_.face, d.longest);
}

/// Returns the part of the piece that is deeper than errors of D; it may be empty. Parallelograms are in whole or not.
FlatPolygon PlanePieces::clip_by_depth(const FlatPolygon& flat, const Depths& d) const {
  const auto is_deep = [&](std::size_t k) { return d.at_corner[k].depth >= least_depth_; };
  FlatPolygon kept;
  for (std::size_t k = 0; k < d.count; ++k) {
    const std::size_t next = (k + 1) % d.count;
    if (is_deep(k)) kept.x[at(kept.count++)] = flat.x[k];
    if (is_deep(k) == is_deep(next)) continue;
    const double a = d.at_corner[k].depth - least_depth_, b = d.at_corner[next].depth - least_depth_;
    kept.x[at(kept.count++)] = flat.x[k] + a / (a - b) * (flat.x[next] - flat.x[k]);
  }
  return kept;
}

/// Computes the gradient: in the plane that of p, and across the plane that of (E/H) D at the corners.
dvec3 PlanePieces::gradient_of(const PlanePressure& p, const Depths& d) const {
  const PlaneMetric& m = plane_.triangle.metric;
  const double determinant = m.uu * m.vv - m.uv * m.uv;
  const dvec3 along = (m.vv * p.pu - m.uv * p.pv) / determinant * u_ + (m.uu * p.pv - m.uv * p.pu) / determinant * v_;
  dvec3 mean(0);
  for (std::size_t k = 0; k < d.count; ++k) mean += d.at_corner[k].gradient / static_cast<double>(d.count);
  return along + depth_.stiffness() * glm::dot(mean, plane_.normal) * plane_.normal;
}

namespace {

/// Edges of a facet are 2^kFacetLevels units of the lattice long, the squares of a plane 2^kSquareLevels.
constexpr int kFacetLevels = 24, kSquareLevels = 12;

}  // namespace

void add_depth_pieces(const DepthFieldPtr& depth, const FieldIndex& tets, const FacetTree& rigid,
                      const RigidTransform& X_SR, const DepthPieceSize& size, SurfaceWriter& writer,
                      DepthWorkspace& workspace) {
  constexpr std::int32_t kLeg = 1 << kFacetLevels;
  constexpr LatticeCorner kO{0, 0}, kU{kLeg, 0}, kUV{kLeg, kLeg}, kV{0, kLeg};
  for (const DepthWorkspace::DeepFacet& deep : workspace.facets) {
    const FacetTree::Facet& facet = rigid.facets()[at(deep.facet)];
    std::array<dvec3, 3> x;
    for (std::size_t c = 0; c < 3; ++c) x[c] = X_SR(rigid.vertices()[at(facet.vertex[c])]);
    const dvec3 normal = X_SR.R * facet.normal;
    const LatticePlane plane{writer.triangle(x, normal), normal, facet.face, kLeg};
    PlanePieces pieces(depth, tets, size, plane, writer, workspace);
    pieces.cover(deep.first, deep.last);
    pieces.add(facet.corners == 4 ? LatticePolygon{{kO, kU, kUV, kV}, 4} : LatticePolygon{{kO, kU, kV}, 3},
               kFacetLevels);
  }
}

void add_depth_pieces(const DepthFieldPtr& depth, const FieldIndex& tets, const RigidTransform& X_SR,
                      const DepthPieceSize& size, SurfaceWriter& writer, DepthWorkspace& workspace) {
  constexpr std::int32_t kUnits = 1 << kSquareLevels;
  // Squares are counted from the point of the plane below the middle of the body, which slides along with it.
  const Aabb& body = depth->skin()->bounds();
  const double edge = std::max(2 * depth->thickness(), body.diagonal() / 1024);
  const dvec3 normal = X_SR.R[2], u = edge * X_SR.R[0], v = edge * X_SR.R[1];
  const dvec3 origin = body.center() - glm::dot(body.center() - X_SR.p, normal) * normal;
  dvec2 lo(std::numeric_limits<double>::infinity()), hi = -lo;
  for (int corner = 0; corner < 8; ++corner) {
    const dvec3 x((corner & 1) != 0 ? body.hi.x : body.lo.x, (corner & 2) != 0 ? body.hi.y : body.lo.y,
                  (corner & 4) != 0 ? body.hi.z : body.lo.z);
    const dvec2 uv(glm::dot(x - origin, X_SR.R[0]) / edge, glm::dot(x - origin, X_SR.R[1]) / edge);
    lo = glm::min(lo, uv);
    hi = glm::max(hi, uv);
  }
  const LatticePlane plane{writer.triangle({origin, origin + u, origin + v}, normal), normal, -1, kUnits};
  const std::size_t covered = writer.polygon_count();
  PlanePieces pieces(depth, tets, size, plane, writer, workspace);
  pieces.cover(0, covered);
  for (int j = static_cast<int>(std::floor(lo.y)); j < static_cast<int>(std::ceil(hi.y)); ++j) {
    for (int i = static_cast<int>(std::floor(lo.x)); i < static_cast<int>(std::ceil(hi.x)); ++i) {
      const LatticeCorner a{i * kUnits, j * kUnits};
      pieces.add({{a, {a.i + kUnits, a.j}, {a.i + kUnits, a.j + kUnits}, {a.i, a.j + kUnits}}, 4}, kSquareLevels);
    }
  }
}

}  // namespace taxel
