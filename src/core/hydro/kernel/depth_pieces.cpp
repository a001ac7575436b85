#include "core/hydro/kernel/depth_pieces.h"

#include "core/base/index.h"
#include "core/hydro/kernel/plane/lattice_corner.h"
#include "core/hydro/kernel/polygon_ends.h"

namespace taxel {
namespace {

/// Edges of a facet are 2^kFacetLevels units of the lattice long, the squares of a plane 2^kSquareLevels.
constexpr int kFacetLevels = 24, kSquareLevels = 12;

/// The pieces of one plane, x = origin + (i u + j v)/units.
class PlanePieces {
 public:
  PlanePieces(const DepthFieldPtr& depth, const FieldIndex& tets, const DepthPieceSize& size,
              const SurfaceTriangle& triangle, const dvec3& normal_S, int face, double units, SurfaceWriter& writer,
              DepthWorkspace& workspace)
      : depth_(*depth),
        near_(workspace.near_faces(depth)),
        tets_(tets),
        triangle_(triangle),
        normal_(normal_S),
        face_(face),
        per_unit_(1 / units),
        u_(triangle.x_S[1] - triangle.x_S[0]),
        v_(triangle.x_S[2] - triangle.x_S[0]),
        unit_area_(2 * triangle.area),
        least_depth_(kClipped * size.tolerance * depth_.thickness()),
        tolerance_(kNoTie * size.tolerance * depth_.thickness()),
        min_edge_(kNoTie * size.min_edge * depth_.thickness()),
        writer_(writer),
        w_(workspace) {
    w_.samples.begin();
    w_.covered.clear();
    body_ = depth_.skin()->bounds();
  }

  /// Records that the surface's polygons [first, last) lie in the plane. Pieces fill only the part outside of them.
  void cover(std::size_t first, std::size_t last) {
    const ContactSurface& surface = writer_.surface();
    const PlaneMetric& m = triangle_.metric;
    const double determinant = m.uu * m.vv - m.uv * m.uv;
    for (std::size_t p = first; p < last; ++p) {
      const ContactPolygon& polygon = surface.polygons[p];
      FlatPolygon flat;
      flat.count = std::min(polygon.count, FlatPolygon::kMaxStored);
      std::array<dvec3, FlatPolygon::kMaxStored> x_S;
      for (int k = 0; k < flat.count; ++k) {
        const int from = writer_.reverse() ? flat.count - 1 - k : k;
        const dvec3& x_A = surface.vertices[at(polygon.first + from)];
        const double a = glm::dot(x_A - triangle_.origin_A, triangle_.u_A);
        const double b = glm::dot(x_A - triangle_.origin_A, triangle_.v_A);
        flat.x[at(k)] = dvec2(m.vv * a - m.uv * b, m.uu * b - m.uv * a) / determinant;
        x_S[at(k)] = writer_.point_S(x_A);
      }
      w_.covered.add(flat, ends_of(tets_.tets()[at(polygon.tet)], {x_S.data(), at(flat.count)}));
    }
    all_ = w_.covered.list_all();
  }

  void add(const std::array<LatticeCorner, 3>& corners, int levels) { refine({corners, levels, all_}); }

  /// Adds the parallelogram with the corners (0, 0), (leg, 0), (leg, leg) and (0, leg).
  void add_parallelogram(std::int32_t leg, int levels) {
    const LatticeCorner o{0, 0}, u{leg, 0}, uv{leg, leg}, v{0, leg};
    const double along_u = glm::distance(point(o), point(u)), along_v = glm::distance(point(o), point(v));
    if (along_u > kElongated * along_v) {
      cut_across({{o, u}, {v, uv}, 1}, along_u, along_v, levels, all_);
    } else if (along_v > kElongated * along_u) {
      cut_across({{u, uv}, {o, v}, 1}, along_v, along_u, levels, all_);
    } else {
      add({o, u, uv}, levels);
      add({o, uv, v}, levels);
    }
  }

 private:
  static constexpr double kClipped = 0.5;  // tolerances: a shallower hole is an error of D, not a hole
  /// A factor of lengths: sizes of bodies are rarely multiples of them then, so that no rounding decides.
  static constexpr double kNoTie = 1.0137;
  static constexpr double kCutEdge = 2;    // thicknesses: longest edge of a piece that the skin cuts
  static constexpr double kLongEdge = 8;   // thicknesses: longest edge of any piece
  static constexpr double kElongated = 4;  // shortest edges: a longer triangle is cut across, not quartered

  struct Piece {
    std::array<LatticeCorner, 3> corners;
    int levels;                ///< halvings that are left
    CoveredRegion::List near;  ///< polygons of the tets near the piece of which this one is a part
  };

  [[nodiscard]] dvec2 plane_point(const LatticeCorner& c) const { return {c.i * per_unit_, c.j * per_unit_}; }
  [[nodiscard]] dvec3 point(const LatticeCorner& c) const {
    return triangle_.x_S[0] + (c.i * per_unit_) * u_ + (c.j * per_unit_) * v_;
  }

  DepthField::Sample sample(const LatticeCorner& c) {
    bool is_new = false;
    const std::uint64_t key = std::uint64_t{static_cast<std::uint32_t>(c.i)} << 32 | static_cast<std::uint32_t>(c.j);
    DepthField::Sample& found = w_.samples.at(key, is_new);
    if (is_new) found = DepthField::at(point(c), near_);
    return found;
  }

  /// The part of a piece that the polygons of the tets leave.
  struct Left {
    bool nothing = true;  ///< the piece is outside of the body or covered
    CoveredRegion::Cover cover = CoveredRegion::Cover::none;
    CoveredRegion::List near;  ///< polygons near the piece; whoever called left_of() removes the list
  };

  /// What refine() needs to know of a piece.
  struct Evaluation {
    FlatPolygon flat;
    Left left;
    std::array<DepthField::Sample, 3> at_corner, at_middle;
    std::array<double, 3> edge;  ///< lengths; edge k runs from corner k to the next one [m]
    double longest = 0;          ///< longest edge [m]
  };

  /// Returns true if the body, by its grid of distances, is farther from the middle of a piece than its corners.
  [[nodiscard]] bool is_far(std::span<const dvec3> x) const {
    dvec3 middle(0);
    for (const dvec3& corner : x) middle += corner / static_cast<double>(x.size());
    const double distance = tets_.grid().cell_of(middle).distance;
    return std::all_of(x.begin(), x.end(),
                       [&](const dvec3& corner) { return glm::distance(corner, middle) < distance; });
  }

  /// `first` is a corner of the piece. The polygons near the piece are among those in `parent`.
  Left left_of(const FlatPolygon& flat, std::span<const dvec3> x, const LatticeCorner& first,
               const CoveredRegion::List& parent) {
    Aabb box;
    for (const dvec3& corner : x) box.include(corner);
    if (!box.overlaps(body_) || is_far(x)) return {};
    const CoveredRegion::List near = w_.covered.list_near(flat, parent);
    const CoveredRegion::Cover cover = w_.covered.cover_of(flat, near);
    if (cover == CoveredRegion::Cover::whole) return {};
    if (cover == CoveredRegion::Cover::part || tets_.grid().may_hold_gap(box)) return {false, cover, near};
    // Without a gap, a way through the piece into the body or out of it meets the end of a polygon at the skin.
    const bool is_outside = cover == CoveredRegion::Cover::up_to_skin || sample(first).depth < 0;
    return {is_outside, cover, near};
  }

  /// Returns false if the piece is left out.
  bool evaluate(const Piece& piece, Evaluation& e) {
    const auto& c = piece.corners;
    const std::array<dvec3, 3> x{point(c[0]), point(c[1]), point(c[2])};
    e.flat.count = 3;
    for (std::size_t k = 0; k < 3; ++k) e.flat.x[k] = plane_point(c[k]);
    e.left = left_of(e.flat, x, c[0], piece.near);
    if (e.left.nothing) return false;
    for (std::size_t k = 0; k < 3; ++k) e.edge[k] = glm::distance(x[k], x[(k + 1) % 3]);
    e.longest = std::max({e.edge[0], e.edge[1], e.edge[2]});
    if (piece.levels > 1 && e.longest > longest_piece(false)) return true;  // divided, whatever D is
    double deepest = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
      e.at_corner[k] = sample(c[k]);
      deepest = std::max(deepest, e.at_corner[k].depth);
      // D is 1-Lipschitz: no point of the triangle is deeper than this.
      if (e.at_corner[k].depth + e.longest < least_depth_) return false;
    }
    // No point of a triangle is farther from its nearest corner than L/sqrt(3).
    if (deepest + e.longest / std::sqrt(3.0) < least_depth_) return false;
    for (std::size_t k = 0; k < 3; ++k) e.at_middle[k] = sample(middle(c[k], c[(k + 1) % 3]));
    return true;
  }

  void refine(const Piece& piece) {
    const std::size_t lists = w_.covered.lists_end();
    Evaluation e;
    if (evaluate(piece, e)) {
      const bool is_small = piece.levels <= 1 || (e.longest <= longest_piece(false) && !must_split(e));
      if (is_small) {
        add_piece(e.flat, e.left.near, e.at_corner, e.at_middle, e.longest);
      } else if (e.longest > kElongated * std::min({e.edge[0], e.edge[1], e.edge[2]})) {
        cut_triangle_across(piece, e.edge, e.left.near);
      } else {
        quarter(piece, e.left.near);
      }
    }
    w_.covered.forget_lists(lists);
  }

  void quarter(const Piece& piece, const CoveredRegion::List& near) {
    const auto& c = piece.corners;
    const std::array<LatticeCorner, 3> m{middle(c[0], c[1]), middle(c[1], c[2]), middle(c[2], c[0])};
    const int levels = piece.levels - 1;
    refine({{c[0], m[0], m[2]}, levels, near});
    refine({{m[0], c[1], m[1]}, levels, near});
    refine({{m[2], m[1], c[2]}, levels, near});
    refine({{m[1], m[2], m[0]}, levels, near});
  }

  void cut_triangle_across(const Piece& piece, const std::array<double, 3>& edge, const CoveredRegion::List& near) {
    std::size_t base = 0;  // the shortest edge
    for (std::size_t k = 1; k < 3; ++k) base = edge[k] < edge[base] ? k : base;
    const LatticeCorner &tip = piece.corners[(base + 2) % 3], &a = piece.corners[base],
                        &b = piece.corners[(base + 1) % 3];
    cut_across({{tip, a}, {tip, b}, 1}, edge[(base + 1) % 3], edge[base], piece.levels, near);
  }

  /// Quarters are as narrow as they are short: an elongated facet would need the square of the number of strips.
  void cut_across(LatticeStrips strips, double long_edge, double width, int levels, const CoveredRegion::List& near) {
    double length = 0.5 * long_edge;
    for (; strips.halvings < levels - 1 && length > width; length *= 0.5) ++strips.halvings;
    const std::int32_t half = 1 << (strips.halvings - 1);
    refine_strips(strips, 0, half, levels - strips.halvings, near);
    refine_strips(strips, half, 2 * half, levels - strips.halvings, near);
  }

  /// Halves the strips from `begin` to `end` while D is not nearly linear along them. `levels` are left in a strip.
  void refine_strips(const LatticeStrips& s, std::int32_t begin, std::int32_t end, int levels,
                     const CoveredRegion::List& parent) {
    const std::size_t lists = w_.covered.lists_end();
    const LatticeCorner a0 = s.on(s.a, begin), a1 = s.on(s.a, end), b0 = s.on(s.b, begin), b1 = s.on(s.b, end);
    const bool is_tip = begin == 0 && s.has_tip();
    const std::array<dvec3, 4> x{point(a0), point(a1), point(b1), point(b0)};
    FlatPolygon flat;
    flat.count = is_tip ? 3 : 4;
    flat.x[0] = plane_point(a0), flat.x[1] = plane_point(a1), flat.x[2] = plane_point(b1), flat.x[3] = plane_point(b0);
    const Left left = left_of(flat, {x.data(), at(flat.count)}, a0, parent);
    if (!left.nothing) {
      if (end - begin > 1 && are_too_large(s, begin, end, left.cover)) {
        const std::int32_t between = begin + (end - begin) / 2;
        refine_strips(s, begin, between, levels, left.near);
        refine_strips(s, between, end, levels, left.near);
      } else {
        refine({{a0, a1, b1}, levels, left.near});
        if (!is_tip) refine({{a0, b1, b0}, levels, left.near});
      }
    }
    w_.covered.forget_lists(lists);
  }

  /// Returns true if D is not nearly linear along the two long sides of the strips from `begin` to `end`, or if that is
  /// not worth knowing because the strips reach beyond the hole that they are to fill.
  bool are_too_large(const LatticeStrips& s, std::int32_t begin, std::int32_t end, CoveredRegion::Cover cover) {
    double longest = 0;
    for (const LatticeStrips::LongEdge& side : {s.a, s.b}) {
      const LatticeCorner from = s.on(side, begin), to = s.on(side, end);
      longest = std::max(longest, glm::distance(point(from), point(to)));
    }
    if (longest > longest_piece(cover != CoveredRegion::Cover::none)) return true;
    double error = 0;
    bool inside = false, outside = false;
    for (const LatticeStrips::LongEdge& side : {s.a, s.b}) {
      const DepthField::Sample from = sample(s.on(side, begin)), to = sample(s.on(side, end));
      const DepthField::Sample between = sample(s.on(side, begin + (end - begin) / 2));
      error = std::max(error, std::abs(between.depth - 0.5 * (from.depth + to.depth)));
      for (const double depth : {from.depth, to.depth, between.depth}) (depth < least_depth_ ? outside : inside) = true;
    }
    return (longest > min_edge_ && error > tolerance_) || longest > longest_piece(inside && outside);
  }

  /// Returns the largest length of a piece, which is shorter where the skin cuts it [m].
  [[nodiscard]] double longest_piece(bool is_cut) const {
    return kNoTie * (is_cut ? kCutEdge : kLongEdge) * depth_.thickness();
  }

  [[nodiscard]] bool must_split(const Evaluation& e) const {
    double error = 0;
    bool inside = false, outside = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const double mean = 0.5 * (e.at_corner[k].depth + e.at_corner[(k + 1) % 3].depth);
      error = std::max(error, std::abs(e.at_middle[k].depth - mean));
      for (const double depth : {e.at_corner[k].depth, e.at_middle[k].depth})
        (depth < least_depth_ ? outside : inside) = true;
    }
    return (e.longest > min_edge_ && error > tolerance_) || e.longest > longest_piece(inside && outside);
  }

  /// The linear function with these values at the corners of a triangle, in the coordinates of the plane.
  static PlanePressure through(const FlatPolygon& flat, const std::array<double, 3>& value) {
    const dvec2 a = flat.x[1] - flat.x[0], b = flat.x[2] - flat.x[0];
    const double area = a.x * b.y - a.y * b.x, da = value[1] - value[0], db = value[2] - value[0];
    PlanePressure p;
    p.pu = (da * b.y - db * a.y) / area;
    p.pv = (db * a.x - da * b.x) / area;
    p.p0 = value[0] - p.pu * flat.x[0].x - p.pv * flat.x[0].y;
    return p;
  }

  /// Adds the part of a piece that the tets do not cover. D is there the linear function through its values at the
  /// middles of the edges; then the force of a quadratic D is exact (Crouzeix, Raviart 1973).
  void add_piece(const FlatPolygon& flat, const CoveredRegion::List& near,
                 const std::array<DepthField::Sample, 3>& corner, const std::array<DepthField::Sample, 3>& at_middle,
                 double longest) {
    const FlatPolygon deep = clip_by_depth(flat, {corner[0].depth, corner[1].depth, corner[2].depth});
    if (deep.count < 3) return;
    const double least = kMinPart * std::min(flat.area(), depth_.thickness() * depth_.thickness() / unit_area_);
    w_.rest.clear();
    w_.covered.add_rest(deep, near, least, w_.rest);
    if (w_.rest.empty()) return;
    double rise = 0;
    for (std::size_t k = 0; k < 3; ++k) rise += (at_middle[k].depth - corner[k].depth) / 3;
    PlanePressure p = through(flat, {corner[0].depth + rise, corner[1].depth + rise, corner[2].depth + rise});
    const double k = depth_.stiffness();
    p = {k * p.p0, k * p.pu, k * p.pv};
    const dvec3 gradient = gradient_of(p, corner);
    for (const FlatPolygon& polygon : w_.rest) writer_.add_flat(polygon, triangle_, p, gradient, face_, longest);
  }

  /// Returns the part of the piece that is deeper than errors of D; it may be empty.
  [[nodiscard]] FlatPolygon clip_by_depth(const FlatPolygon& flat, const std::array<double, 3>& depth) const {
    if (std::min({depth[0], depth[1], depth[2]}) >= least_depth_) return flat;
    FlatPolygon kept;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const double a = depth[k] - least_depth_, b = depth[next] - least_depth_;
      if (a >= 0) kept.x[at(kept.count++)] = flat.x[k];
      if ((a < 0) != (b < 0)) kept.x[at(kept.count++)] = flat.x[k] + a / (a - b) * (flat.x[next] - flat.x[k]);
    }
    return kept;
  }

  /// Computes the gradient: in the plane that of p, and across the plane that of (E/H) D at the corners.
  [[nodiscard]] dvec3 gradient_of(const PlanePressure& p, const std::array<DepthField::Sample, 3>& corner) const {
    const PlaneMetric& m = triangle_.metric;
    const double determinant = m.uu * m.vv - m.uv * m.uv;
    const dvec3 along = (m.vv * p.pu - m.uv * p.pv) / determinant * u_ + (m.uu * p.pv - m.uv * p.pu) / determinant * v_;
    const dvec3 mean = (corner[0].gradient + corner[1].gradient + corner[2].gradient) / 3.0;
    return along + depth_.stiffness() * glm::dot(mean, normal_) * normal_;
  }

  const DepthField& depth_;
  NearFaces& near_;
  const FieldIndex& tets_;
  const SurfaceTriangle& triangle_;
  dvec3 normal_;
  int face_;
  double per_unit_;
  dvec3 u_, v_;
  double unit_area_;  ///< area of the parallelogram of u and v [m^2]
  double least_depth_, tolerance_, min_edge_;
  SurfaceWriter& writer_;
  DepthWorkspace& w_;
  Aabb body_;
  CoveredRegion::List all_;
};

}  // namespace

void add_depth_pieces(const DepthFieldPtr& depth, const FieldIndex& tets, const FacetTree& rigid,
                      const RigidTransform& X_SR, const DepthPieceSize& size, SurfaceWriter& writer,
                      DepthWorkspace& workspace) {
  constexpr std::int32_t kLeg = 1 << kFacetLevels;
  for (const DepthWorkspace::DeepFacet& deep : workspace.facets) {
    const FacetTree::Facet& source = rigid.facets()[at(deep.facet)];
    std::array<dvec3, 3> x;
    for (std::size_t c = 0; c < 3; ++c) x[c] = X_SR(rigid.vertices()[at(source.vertex[c])]);
    const dvec3 normal = X_SR.R * source.normal;
    const SurfaceTriangle triangle = writer.triangle(x, normal);
    PlanePieces pieces(depth, tets, size, triangle, normal, source.face, kLeg, writer, workspace);
    pieces.cover(deep.first, deep.last);
    if (source.corners == 4) {
      pieces.add_parallelogram(kLeg, kFacetLevels);
    } else {
      pieces.add({LatticeCorner{0, 0}, {kLeg, 0}, {0, kLeg}}, kFacetLevels);
    }
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
  const SurfaceTriangle triangle = writer.triangle({origin, origin + u, origin + v}, normal);
  const std::size_t covered = writer.polygon_count();
  PlanePieces pieces(depth, tets, size, triangle, normal, -1, kUnits, writer, workspace);
  pieces.cover(0, covered);
  for (int j = static_cast<int>(std::floor(lo.y)); j < static_cast<int>(std::ceil(hi.y)); ++j) {
    for (int i = static_cast<int>(std::floor(lo.x)); i < static_cast<int>(std::ceil(hi.x)); ++i) {
      const LatticeCorner a{i * kUnits, j * kUnits}, b{a.i + kUnits, a.j}, c{a.i + kUnits, a.j + kUnits},
          d{a.i, a.j + kUnits};
      pieces.add({a, b, c}, kSquareLevels);
      pieces.add({a, c, d}, kSquareLevels);
    }
  }
}

}  // namespace taxel
