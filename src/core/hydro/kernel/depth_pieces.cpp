#include "core/hydro/kernel/depth_pieces.h"

namespace taxel {
namespace {

/// Corners have integer coordinates: a triangle's legs are 2^kTriangleLevels units long, the squares of a plane
/// 2^kSquareLevels.
constexpr int kTriangleLevels = 24, kSquareLevels = 12;

struct Corner {
  std::int32_t i = 0, j = 0;
};
Corner middle(const Corner& a, const Corner& b) {
  return {(a.i + b.i) / 2, (a.j + b.j) / 2};
}

/// The pieces of one plane, x = origin + (i u + j v)/units.
class PlanePieces {
 public:
  PlanePieces(const DepthField& depth, const DepthPieceSize& size, const SurfaceTriangle& triangle,
              const dvec3& normal_S, int face, double units, SurfaceWriter& writer, DepthWorkspace& workspace)
      : depth_(depth),
        triangle_(triangle),
        normal_(normal_S),
        face_(face),
        per_unit_(1 / units),
        u_(triangle.x_S[1] - triangle.x_S[0]),
        v_(triangle.x_S[2] - triangle.x_S[0]),
        unit_area_(2 * triangle.area),
        least_depth_(kClipped * size.tolerance * depth.thickness()),
        tolerance_(kNoTie * size.tolerance * depth.thickness()),
        min_edge_(kNoTie * size.min_edge * depth.thickness()),
        writer_(writer),
        w_(workspace) {
    w_.samples.begin();
    w_.covered.clear();
    w_.lists.clear();
    body_ = depth.skin()->bounds();
  }

  /// Notes that the surface's polygons [first, last) lie in the plane: pieces leave them free.
  void cover(std::size_t first, std::size_t last) {
    const ContactSurface& surface = writer_.surface();
    const PlaneMetric& m = triangle_.metric;
    const double determinant = m.uu * m.vv - m.uv * m.uv;
    for (std::size_t p = first; p < last; ++p) {
      const ContactPolygon& polygon = surface.polygons[p];
      DepthWorkspace::Covered& covered = w_.covered.emplace_back();
      covered.lo = dvec2(std::numeric_limits<double>::infinity());
      covered.hi = -covered.lo;
      covered.polygon.count = std::min(polygon.count, FlatPolygon::kMaxStored);
      for (int k = 0; k < covered.polygon.count; ++k) {
        const int from = writer_.reverse() ? covered.polygon.count - 1 - k : k;
        const dvec3 x = surface.vertices[static_cast<std::size_t>(polygon.first + from)] - triangle_.origin_A;
        const double a = glm::dot(x, triangle_.u_A), b = glm::dot(x, triangle_.v_A);
        const dvec2 uv((m.vv * a - m.uv * b) / determinant, (m.uu * b - m.uv * a) / determinant);
        covered.polygon.x[static_cast<std::size_t>(k)] = uv;
        covered.lo = glm::min(covered.lo, uv);
        covered.hi = glm::max(covered.hi, uv);
      }
      covered.area = covered.polygon.area();
      w_.lists.push_back(static_cast<std::int32_t>(w_.covered.size()) - 1);
    }
  }

  void add(const std::array<Corner, 3>& corners, int levels) { refine({corners, levels, 0, w_.lists.size()}); }

 private:
  static constexpr double kClipped = 0.5;  // tolerances: a shallower hole is an error of D, not a hole
  /// A factor of lengths: sizes of bodies are rarely multiples of them then, so that no rounding decides.
  static constexpr double kNoTie = 1.0137;
  static constexpr double kCutEdge = 2;    // thicknesses: longest edge of a piece that the skin cuts
  static constexpr double kLongEdge = 8;   // thicknesses: longest edge of any piece
  static constexpr double kElongated = 4;  // shortest edges: a longer triangle is cut across, not quartered

  struct Piece {
    std::array<Corner, 3> corners;
    int levels;               ///< halvings that are left
    std::size_t first, last;  ///< range in the lists: covered polygons near the parent
  };

  [[nodiscard]] dvec2 plane_point(const Corner& c) const { return {c.i * per_unit_, c.j * per_unit_}; }
  [[nodiscard]] dvec3 point(const Corner& c) const {
    return triangle_.x_S[0] + (c.i * per_unit_) * u_ + (c.j * per_unit_) * v_;
  }

  DepthField::Sample sample(const Corner& c, double within = std::numeric_limits<double>::infinity()) {
    bool is_new = false;
    const std::uint64_t key = std::uint64_t{static_cast<std::uint32_t>(c.i)} << 32 | static_cast<std::uint32_t>(c.j);
    DepthField::Sample& found = w_.samples.at(key, is_new);
    if (is_new) found = depth_.at(point(c), within);
    return found;
  }

  /// Lists the covered polygons near a piece at the end of the lists; returns their area within the parent's list.
  double list_near(const Piece& piece, const FlatPolygon& flat) {
    dvec2 lo = flat.x[0], hi = lo;
    for (std::size_t k = 1; k < 3; ++k) {
      lo = glm::min(lo, flat.x[k]);
      hi = glm::max(hi, flat.x[k]);
    }
    double area = 0;
    for (std::size_t n = piece.first; n < piece.last; ++n) {
      const std::int32_t number = w_.lists[n];
      const DepthWorkspace::Covered& covered = w_.covered[static_cast<std::size_t>(number)];
      if (covered.lo.x > hi.x || covered.lo.y > hi.y || covered.hi.x < lo.x || covered.hi.y < lo.y) continue;
      w_.lists.push_back(number);
      area += covered.area;
    }
    return area;
  }

  /// Returns true if the tets' polygons fill a piece.
  [[nodiscard]] bool is_covered(const FlatPolygon& flat, std::size_t first, double listed_area) const {
    constexpr double kWhole = 1 - kMinPart;
    const double whole = kWhole * flat.area();
    if (listed_area < whole) return false;
    double area = 0;
    for (std::size_t n = first; n < w_.lists.size(); ++n)
      area += shared_area(flat, w_.covered[static_cast<std::size_t>(w_.lists[n])].polygon);
    return area >= whole;
  }

  /// What refine() needs to know of a piece.
  struct Evaluation {
    FlatPolygon flat;
    std::array<DepthField::Sample, 3> at_corner, at_middle;
    std::array<double, 3> edge;  ///< lengths; edge k runs from corner k to the next one [m]
    double longest = 0;          ///< longest edge [m]
  };

  /// False if the piece is outside of the body or covered by the tets' polygons. Lists the covered polygons near the
  /// piece at the end of the lists; the caller removes them.
  bool evaluate(const Piece& piece, Evaluation& e) {
    const auto& c = piece.corners;
    const std::array<dvec3, 3> x{point(c[0]), point(c[1]), point(c[2])};
    Aabb box;
    for (const dvec3& corner : x) box.include(corner);
    if (!box.overlaps(body_)) return false;
    e.flat.count = 3;
    for (std::size_t k = 0; k < 3; ++k) e.flat.x[k] = plane_point(c[k]);
    const std::size_t first = w_.lists.size();
    const double listed = list_near(piece, e.flat);
    if (is_covered(e.flat, first, listed)) return false;
    for (std::size_t k = 0; k < 3; ++k) e.edge[k] = glm::distance(x[k], x[(k + 1) % 3]);
    e.longest = std::max({e.edge[0], e.edge[1], e.edge[2]});
    double deepest = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
      const bool known = k > 0;
      e.at_corner[k] = known ? sample(c[k], bound(e.at_corner[k - 1].depth, e.edge[k - 1])) : sample(c[k]);
      deepest = std::max(deepest, e.at_corner[k].depth);
      // D is 1-Lipschitz: no point of the triangle is deeper than this.
      if (e.at_corner[k].depth + e.longest < least_depth_) return false;
    }
    // No point of a triangle is farther from its nearest corner than L/sqrt(3).
    if (deepest + e.longest / std::sqrt(3.0) < least_depth_) return false;
    for (std::size_t k = 0; k < 3; ++k)
      e.at_middle[k] = sample(middle(c[k], c[(k + 1) % 3]), bound(e.at_corner[k].depth, 0.5 * e.edge[k]));
    return true;
  }

  void refine(const Piece& piece) {
    const std::size_t first = w_.lists.size();
    Evaluation e;
    if (evaluate(piece, e)) {
      const bool is_small = piece.levels <= 1 || !must_split(e.at_corner, e.at_middle, e.longest);
      if (is_small) {
        add_piece(e.flat, e.at_corner, e.at_middle, e.longest, first);
      } else if (e.longest > kElongated * std::min({e.edge[0], e.edge[1], e.edge[2]})) {
        cut_across(piece, e.edge, first);
      } else {
        quarter(piece, first);
      }
    }
    w_.lists.resize(first);
  }

  void quarter(const Piece& piece, std::size_t first) {
    const auto& c = piece.corners;
    const std::array<Corner, 3> m{middle(c[0], c[1]), middle(c[1], c[2]), middle(c[2], c[0])};
    const std::size_t last = w_.lists.size();
    const int levels = piece.levels - 1;
    refine({{c[0], m[0], m[2]}, levels, first, last});
    refine({{m[0], c[1], m[1]}, levels, first, last});
    refine({{m[2], m[1], c[2]}, levels, first, last});
    refine({{m[1], m[2], m[0]}, levels, first, last});
  }

  /// A triangle with two long edges, cut across them:
  ///
  ///     tip --- 1 --- 2 --- 3 --- a     Each of the 2^halvings strips has parts of the two long edges as its sides;
  ///       `---- 1 --- 2 --- 3 --- b     strips are as long as the triangle is wide, or up to half of that.
  struct Strips {
    Corner tip, a, b;
    int halvings;
    [[nodiscard]] Corner on_edge(const Corner& end, std::int32_t n) const {
      const auto between = [&](std::int64_t from, std::int64_t to) {
        return static_cast<std::int32_t>(from + (to - from) * n / (1 << halvings));
      };
      return {between(tip.i, end.i), between(tip.j, end.j)};
    }
  };

  /// Quarters are as narrow as they are short: an elongated triangle would need the square of the number of strips.
  void cut_across(const Piece& piece, const std::array<double, 3>& edge, std::size_t first) {
    std::size_t base = 0;  // the shortest edge
    for (std::size_t k = 1; k < 3; ++k) base = edge[k] < edge[base] ? k : base;
    Strips strips{piece.corners[(base + 2) % 3], piece.corners[base], piece.corners[(base + 1) % 3], 1};
    double length = 0.5 * edge[(base + 1) % 3];
    for (; strips.halvings < piece.levels - 1 && length > edge[base]; length *= 0.5) ++strips.halvings;
    const std::int32_t half = 1 << (strips.halvings - 1);
    const int levels = piece.levels - strips.halvings;
    const std::size_t last = w_.lists.size();
    refine_strips(strips, 0, half, levels, first, last);
    refine_strips(strips, half, 2 * half, levels, first, last);
  }

  /// Halves the strips from `begin` to `end` while they are too large for two pieces. `levels` are left in a strip.
  void refine_strips(const Strips& s, std::int32_t begin, std::int32_t end, int levels, std::size_t first,
                     std::size_t last) {
    const Corner a0 = s.on_edge(s.a, begin), a1 = s.on_edge(s.a, end);
    const Corner b0 = s.on_edge(s.b, begin), b1 = s.on_edge(s.b, end);
    const Piece at_end{{a0, a1, b1}, levels, first, last}, at_begin{{a0, b1, b0}, levels, first, last};
    const bool is_tip = begin == 0;
    if (end - begin > 1 && (is_too_large(at_end) || (!is_tip && is_too_large(at_begin)))) {
      const std::int32_t between = begin + (end - begin) / 2;
      refine_strips(s, begin, between, levels, first, last);
      refine_strips(s, between, end, levels, first, last);
      return;
    }
    refine(at_end);
    if (!is_tip) refine(at_begin);
  }

  [[nodiscard]] bool is_too_large(const Piece& piece) {
    const std::size_t first = w_.lists.size();
    Evaluation e;
    const bool splits = evaluate(piece, e) && must_split(e.at_corner, e.at_middle, e.longest);
    w_.lists.resize(first);
    return splits;
  }

  static double bound(double depth, double distance) { return (std::abs(depth) + distance) * (1 + 1e-9); }

  [[nodiscard]] bool must_split(const std::array<DepthField::Sample, 3>& corner,
                                const std::array<DepthField::Sample, 3>& at_middle, double longest) const {
    double error = 0;
    bool inside = false, outside = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const double mean = 0.5 * (corner[k].depth + corner[(k + 1) % 3].depth);
      error = std::max(error, std::abs(at_middle[k].depth - mean));
      for (const double depth : {corner[k].depth, at_middle[k].depth}) (depth < least_depth_ ? outside : inside) = true;
    }
    const double thickness = depth_.thickness();
    return (longest > min_edge_ && error > tolerance_) ||
           longest > kNoTie * (inside && outside ? kCutEdge : kLongEdge) * thickness;
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
  void add_piece(const FlatPolygon& flat, const std::array<DepthField::Sample, 3>& corner,
                 const std::array<DepthField::Sample, 3>& at_middle, double longest, std::size_t first) {
    w_.rest.clear();
    w_.rest.push_back(flat);
    clip_by_depth(flat, {corner[0].depth, corner[1].depth, corner[2].depth});
    const double least = kMinPart * std::min(flat.area(), depth_.thickness() * depth_.thickness() / unit_area_);
    for (std::size_t n = first; n < w_.lists.size() && !w_.rest.empty(); ++n)
      subtract(w_.covered[static_cast<std::size_t>(w_.lists[n])].polygon, least, w_.rest, w_.scratch);
    if (w_.rest.empty()) return;
    double rise = 0;
    for (std::size_t k = 0; k < 3; ++k) rise += (at_middle[k].depth - corner[k].depth) / 3;
    PlanePressure p = through(flat, {corner[0].depth + rise, corner[1].depth + rise, corner[2].depth + rise});
    const double k = depth_.stiffness();
    p = {k * p.p0, k * p.pu, k * p.pv};
    const dvec3 gradient = gradient_of(p, corner);
    for (const FlatPolygon& polygon : w_.rest) writer_.add_flat(polygon, triangle_, p, gradient, face_, longest);
  }

  /// Keeps the part of the piece that is deeper than errors of D.
  void clip_by_depth(const FlatPolygon& flat, const std::array<double, 3>& depth) {
    if (std::min({depth[0], depth[1], depth[2]}) >= least_depth_) return;
    FlatPolygon& kept = w_.rest.front();
    kept.count = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const double a = depth[k] - least_depth_, b = depth[next] - least_depth_;
      if (a >= 0) kept.x[static_cast<std::size_t>(kept.count++)] = flat.x[k];
      if ((a < 0) != (b < 0))
        kept.x[static_cast<std::size_t>(kept.count++)] = flat.x[k] + a / (a - b) * (flat.x[next] - flat.x[k]);
    }
    if (kept.count < 3) w_.rest.clear();
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
};

}  // namespace

void add_depth_pieces(const DepthField& depth, const TriangleTree& rigid, const RigidTransform& X_SR,
                      const DepthPieceSize& size, SurfaceWriter& writer, DepthWorkspace& workspace) {
  constexpr std::int32_t kLeg = 1 << kTriangleLevels;
  for (const DepthWorkspace::DeepTriangle& deep : workspace.triangles) {
    const TriangleTree::Triangle& source = rigid.triangles()[static_cast<std::size_t>(deep.triangle)];
    std::array<dvec3, 3> x;
    for (std::size_t c = 0; c < 3; ++c) x[c] = X_SR(rigid.vertices()[static_cast<std::size_t>(source.vertex[c])]);
    const dvec3 normal = X_SR.R * source.normal;
    const SurfaceTriangle triangle = writer.triangle(x, normal);
    PlanePieces pieces(depth, size, triangle, normal, source.face, kLeg, writer, workspace);
    pieces.cover(deep.first, deep.last);
    pieces.add({Corner{0, 0}, {kLeg, 0}, {0, kLeg}}, kTriangleLevels);
  }
}

void add_depth_pieces(const DepthField& depth, const RigidTransform& X_SR, const DepthPieceSize& size,
                      SurfaceWriter& writer, DepthWorkspace& workspace) {
  constexpr std::int32_t kUnits = 1 << kSquareLevels;
  // Squares are counted from the point of the plane below the middle of the body, which slides along with it.
  const Aabb& body = depth.skin()->bounds();
  const double edge = std::max(2 * depth.thickness(), body.diagonal() / 1024);
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
  PlanePieces pieces(depth, size, triangle, normal, -1, kUnits, writer, workspace);
  pieces.cover(0, covered);
  for (int j = static_cast<int>(std::floor(lo.y)); j < static_cast<int>(std::ceil(hi.y)); ++j) {
    for (int i = static_cast<int>(std::floor(lo.x)); i < static_cast<int>(std::ceil(hi.x)); ++i) {
      const Corner a{i * kUnits, j * kUnits}, b{a.i + kUnits, a.j}, c{a.i + kUnits, a.j + kUnits}, d{a.i, a.j + kUnits};
      pieces.add({a, b, c}, kSquareLevels);
      pieces.add({a, c, d}, kSquareLevels);
    }
  }
}

}  // namespace taxel
