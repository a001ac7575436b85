// Clips a triangle or a parallelogram to the inside of a tetrahedron, for every instruction set. Included once per
// target.
//
// The polygon is kept in barycentric coordinates (u, v) of the facet, up to eight vertices in the lanes of two vectors.
// A plane of the tet is the linear function of its three distances to the corners. A cut finds the vertices outside by
// a comparison of all lanes, computes the crossings of all edges (only two are used), and picks the lanes of the new
// polygon from old vertices and crossings by a table (cut_lanes.h). It follows Sutherland and Hodgman (1974); their
// form, vertex by vertex, is left for polygons that rounding has made concave, or that have eight vertices.
//
// Half-open faces: two tets at a face have exactly negated planes, so both cut along the same line of (u, v), however
// flat the angle. A facet in a shared plane belongs to the tet with the lower number. No tolerance decides whether a
// point is inside. Theory: docs/theory/hydro.md, "Half-open faces".
#if defined(TAXEL_CLIP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TAXEL_CLIP_INL_H
#undef TAXEL_CLIP_INL_H
#else
#define TAXEL_CLIP_INL_H
#endif

#include <bit>

#include "core/hydro/kernel/index/field_index.h"
#include "core/hydro/kernel/simd/eight_inl.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

/// Marks of edges: 0 to 3 are the planes of the clipping tet, larger numbers the edges of the clipped polygon.
inline constexpr std::uint64_t kOwnEdge = 4;

/// A convex polygon in coordinates (u, v) of a triangle: x = (1 - u - v) x0 + u x1 + v x2. Lanes from `count` on hold
/// finite numbers without meaning.
struct PlanePolygon {
  static constexpr unsigned kMax = 8;
  Eight u, v;
  std::uint64_t edges;  ///< byte i: mark of the edge from vertex i to the next one; 0 from `count` on
  unsigned count;
};

/// Returns bits; bit i is set if an edge has mark i.
HWY_INLINE unsigned edge_bits(const PlanePolygon& polygon) {
  constexpr unsigned kNone = 31;
  const unsigned used = 8 * polygon.count;
  const std::uint64_t unused = used >= 64 ? 0 : ~std::uint64_t{0} << used;
  const std::uint64_t edges = polygon.edges | (unused & kNone * 0x0101010101010101u);
  unsigned bits = 0;
  for (unsigned i = 0; i < PlanePolygon::kMax; ++i) bits |= 1u << (edges >> (8 * i) & 0xff);
  return bits & ~(1u << kNone);
}

/// Signed distances of a triangle's corners to the planes of a tet, with one plane per lane, and the conclusions from
/// them about the triangle or the parallelogram.
struct alignas(32) FacetInTet {
  double corner[3][4];
  unsigned cut;   ///< bit i is set if a corner is outside of plane i
  bool disjoint;  ///< true if no part of the facet is inside
  bool flat;      ///< true if the facet is in a plane of the tet, or nearly
};

/// Distance from a plane, as a fraction of the tet's size, below which the traversal treats a facet as in the plane,
/// because rounding decides its side for each face.
inline constexpr double kNearlyFlat = 1e-9;

/// Classifies a triangle or, with four corners, the parallelogram whose fourth one is x[1] + x[2] - x[0]. A facet
/// exactly in a shared plane belongs to the tet with the lower number (half-open faces); in a boundary plane it is
/// inside. A facet that touches a plane from outside with an edge or a corner is disjoint.
HWY_INLINE void classify(const double (&x)[3][3], int corners, const PackedTet& tet, std::int32_t index,
                         FacetInTet& out) {
  const TagD d;
  unsigned below = 0, not_above = 0, near = 0;
  const VecD thin = hn::Set(d, kNearlyFlat * tet.size);
  for (std::size_t i = 0; i < 4; i += kLanesD) {
    const VecD nx = hn::Load(d, &tet.nx[i]), ny = hn::Load(d, &tet.ny[i]), nz = hn::Load(d, &tet.nz[i]);
    const VecD o = hn::Load(d, &tet.offset[i]), zero = hn::Zero(d);
    const VecD a = plane(nx, hn::Set(d, x[0][0]), ny, hn::Set(d, x[0][1]), nz, hn::Set(d, x[0][2]), o);
    const VecD b = plane(nx, hn::Set(d, x[1][0]), ny, hn::Set(d, x[1][1]), nz, hn::Set(d, x[1][2]), o);
    const VecD c = plane(nx, hn::Set(d, x[2][0]), ny, hn::Set(d, x[2][1]), nz, hn::Set(d, x[2][2]), o);
    hn::Store(a, d, out.corner[0] + i);
    hn::Store(b, d, out.corner[1] + i);
    hn::Store(c, d, out.corner[2] + i);
    VecD least = hn::Min(hn::Min(a, b), c), most = hn::Max(hn::Max(a, b), c);
    if (corners == 4) {
      const VecD fourth = hn::Add(hn::Sub(b, a), c);  // the same bits as distances_of()
      least = hn::Min(least, fourth), most = hn::Max(most, fourth);
    }
    below |= mask_bits(d, hn::Lt(least, zero)) << i;
    not_above |= mask_bits(d, hn::Le(most, zero)) << i;
    near |= mask_bits(d, hn::Le(hn::Max(most, hn::Neg(least)), thin)) << i;
  }
  out.cut = below;
  out.disjoint = (below & not_above) != 0;
  out.flat = near != 0;
  for (unsigned flat = not_above & ~below; flat != 0; flat &= flat - 1) {  // all corners in the plane
    const std::int32_t neighbour = tet.neighbour[static_cast<std::size_t>(std::countr_zero(flat))];
    if (neighbour >= 0 && neighbour < index) out.disjoint = true;
  }
}

/// Clips vertex by vertex (Sutherland and Hodgman 1974), for polygons that rounding has made slightly concave.
inline HWY_NOINLINE void keep_inside_slowly(const Eight& distances, std::uint64_t mark, PlanePolygon& polygon) {
  double distance[8], in_u[8], in_v[8], u[8] = {}, v[8] = {};
  store_eight(distances, distance);
  store_eight(polygon.u, in_u);
  store_eight(polygon.v, in_v);
  unsigned count = 0;
  std::uint64_t edges = 0;
  const auto push = [&](double at_u, double at_v, std::uint64_t edge) {
    if (count == PlanePolygon::kMax) return;
    u[count] = at_u;
    v[count] = at_v;
    edges |= edge << (8 * count++);
  };
  const auto edge = [&](unsigned i) { return polygon.edges >> (8 * i) & 0xff; };
  unsigned a = polygon.count - 1;
  for (unsigned b = 0; b < polygon.count; a = b++) {
    const double da = distance[a], db = distance[b];
    if ((da < 0) != (db < 0)) {
      const double t = da / (da - db);
      push(in_u[a] + t * (in_u[b] - in_u[a]), in_v[a] + t * (in_v[b] - in_v[a]), da < 0 ? edge(a) : mark);
    }
    if (!(db < 0)) push(in_u[b], in_v[b], edge(b));
  }
  polygon = {load_eight(u), load_eight(v), edges, count};
}

/// Result of clipping a polygon.
enum class Cut { nothing_outside, nothing_inside, done };

/// Returns the signed distances of a polygon's vertices, a linear function with values d0, d1, d2 at the triangle's
/// corners.
HWY_INLINE Eight distances_of(const PlanePolygon& p, double d0, double d1, double d2) {
  const Eight w = set_eight(1.0) - p.u - p.v;
  return w * set_eight(d0) + p.u * set_eight(d1) + p.v * set_eight(d2);
}

/// Clips the polygon to distance >= 0. Two tets that share a plane have exactly negated distances, and hence the same
/// line, however small the angle. The new edge gets `mark`. The polygon only changes if the result is `done`.
HWY_INLINE Cut keep_inside(double d0, double d1, double d2, std::uint64_t mark, PlanePolygon& p) {
  const Eight distance = distances_of(p, d0, d1, d2);
  const unsigned n = p.count, all = (1u << n) - 1;
  const unsigned outside = less(distance, set_eight(0.0)) & all;
  if (outside == 0) return Cut::nothing_outside;
  if (outside == all) return Cut::nothing_inside;
  const unsigned inside = all & ~outside;
  const unsigned starts = inside & ~((inside << 1) | (inside >> (n - 1)));  // inside, and the previous vertex is not
  if ((starts & (starts - 1)) != 0 || n == PlanePolygon::kMax) {
    keep_inside_slowly(distance, mark, p);
    return p.count < 3 ? Cut::nothing_inside : Cut::done;
  }
  // Where the plane crosses the edge that begins at each vertex; means something at two of them.
  const Lanes& next = kCutLanes.next(n);
  const Eight drop = distance - take(distance, next);
  const Eight t = n <= 4 ? divide_four(distance, drop) : distance / drop;
  const Eight crossing_u = p.u + t * (take(p.u, next) - p.u);
  const Eight crossing_v = p.v + t * (take(p.v, next) - p.v);
  const auto first = static_cast<unsigned>(std::countr_zero(starts));
  const auto run = static_cast<unsigned>(std::popcount(inside));
  const unsigned before = first == 0 ? n - 1 : first - 1;
  const Lanes& kept = kCutLanes.kept(n, before, run);
  p.u = take(p.u, crossing_u, kept);
  p.v = take(p.v, crossing_v, kept);
  // Edges: those from `before` to the last one inside in a row, then the new one. One vertex at least is outside.
  const std::uint64_t turned = before == 0 ? p.edges : p.edges >> (8 * before) | p.edges << (8 * (n - before));
  const unsigned place = 8 * (run + 1);  // at most 7 vertices are inside
  p.edges = (turned & ((std::uint64_t{1} << place) - 1)) | mark << place;
  p.count = run + 2;
  return Cut::done;
}

/// Clips by the planes of in_tet.cut. Returns false if nothing is left.
HWY_INLINE bool clip(const FacetInTet& in_tet, PlanePolygon& polygon) {
  for (unsigned planes = in_tet.cut; planes != 0; planes &= planes - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(planes));
    const Cut cut = keep_inside(in_tet.corner[0][i], in_tet.corner[1][i], in_tet.corner[2][i], i, polygon);
    if (cut == Cut::nothing_inside) return false;
  }
  return true;
}

/// Returns the triangle of three corners, or the parallelogram of four.
HWY_INLINE PlanePolygon whole_facet(int corners) {
  alignas(64) static constexpr double kU[2][8] = {{0, 1}, {0, 1, 1}}, kV[2][8] = {{0, 0, 1}, {0, 0, 1, 1}};
  const std::size_t kind = corners == 4 ? 1 : 0;
  const std::uint64_t last = kind != 0 ? kOwnEdge << 24 : 0;
  return {load_eight(kU[kind]), load_eight(kV[kind]), kOwnEdge | kOwnEdge << 8 | kOwnEdge << 16 | last,
          static_cast<unsigned>(corners)};
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
