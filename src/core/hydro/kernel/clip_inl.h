// Cutting a triangle to the inside of a tetrahedron, for every instruction set. Included once per target.
#if defined(TAXEL_CLIP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TAXEL_CLIP_INL_H
#undef TAXEL_CLIP_INL_H
#else
#define TAXEL_CLIP_INL_H
#endif

#include <bit>
#include <cstring>

#include "core/hydro/kernel/field_index.h"
#include "core/hydro/kernel/lanes_inl.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

/// A convex polygon in coordinates (u, v) of a triangle: x = (1 - u - v) x0 + u x1 + v x2. The vertices stand twice,
/// one round after the other, so that any run of them lies side by side in memory.
struct alignas(64) PlanePolygon {
  static constexpr int kMost = 8;
  double u[2 * kMost], v[2 * kMost];
  std::uint64_t edges;  ///< byte i: what the edge from vertex i to the next one lies on, a plane of the tet or kOwnEdge
  int count;

  HWY_INLINE void close() {                 // writes the second round
    double first_u[kMost], first_v[kMost];  // the rounds overlap where there are fewer than kMost vertices
    std::memcpy(first_u, u, sizeof(first_u));
    std::memcpy(first_v, v, sizeof(first_v));
    std::memcpy(u + count, first_u, sizeof(first_u));
    std::memcpy(v + count, first_v, sizeof(first_v));
  }
};

/// Marks of edges: 0 to 3 the planes of the tet that cuts, from here on those of what is cut.
inline constexpr std::uint64_t kOwnEdge = 4;

/// Bit i: some edge lies on i.
HWY_INLINE unsigned edge_bits(const PlanePolygon& polygon) {
  unsigned bits = 0;
  std::uint64_t edges = polygon.edges;
  for (int i = 0; i < polygon.count; ++i, edges >>= 8) bits |= 1u << (edges & 0xff);
  return bits;
}

/// Signed distances of a triangle's corners to the planes of a tet, lanes over planes, and what they say.
struct alignas(32) TriangleInTet {
  double corner[3][4];
  unsigned cut;   ///< bit i: plane i has a corner outside
  bool disjoint;  ///< nothing of the triangle is inside
  bool flat;      ///< the triangle lies in a plane of the tet, or nearly
};

/// A triangle nearer to a plane than this part of the tet's size lies in it, as far as walks are concerned: rounding
/// decides which side it is on, face by face.
inline constexpr double kNearlyFlat = 1e-9;

/// A triangle exactly in a shared plane belongs to the tet of the lower number (half-open faces); in a boundary plane
/// it is inside. One that touches a plane from outside with an edge or a corner is disjoint.
HWY_INLINE void classify(const double (&x)[3][3], const PackedTet& tet, std::int32_t index, TriangleInTet& out) {
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
    const VecD least = hn::Min(hn::Min(a, b), c), most = hn::Max(hn::Max(a, b), c);
    below |= mask_bits(d, hn::Lt(least, zero)) << i;
    not_above |= mask_bits(d, hn::Le(most, zero)) << i;
    near |= mask_bits(d, hn::Le(hn::Max(most, hn::Neg(least)), thin)) << i;
  }
  out.cut = below;
  out.disjoint = (below & not_above) != 0;
  out.flat = near != 0;
  for (unsigned flat = not_above & ~below; flat != 0; flat &= flat - 1) {  // all three corners in the plane
    const std::int32_t neighbour = tet.neighbour[static_cast<std::size_t>(std::countr_zero(flat))];
    if (neighbour >= 0 && neighbour < index) out.disjoint = true;
  }
}

/// Sutherland and Hodgman (1974) vertex by vertex: where rounding has left a polygon not quite convex.
inline HWY_NOINLINE void keep_inside_slowly(const double* HWY_RESTRICT distance, std::uint64_t mark,
                                            const PlanePolygon& in, PlanePolygon& out) {
  out.count = 0;
  out.edges = 0;
  const auto push = [&out](double u, double v, std::uint64_t edge) {
    if (out.count == PlanePolygon::kMost) return;
    out.u[out.count] = u;
    out.v[out.count] = v;
    out.edges |= edge << (8 * out.count++);
  };
  const auto edge = [&in](int i) { return in.edges >> (8 * i) & 0xff; };
  int a = in.count - 1;
  for (int b = 0; b < in.count; a = b++) {
    const double da = distance[a], db = distance[b];
    if ((da < 0) != (db < 0)) {
      const double t = da / (da - db);
      push(in.u[a] + t * (in.u[b] - in.u[a]), in.v[a] + t * (in.v[b] - in.v[a]), da < 0 ? edge(a) : mark);
    }
    if (!(db < 0)) push(in.u[b], in.v[b], edge(b));
  }
  out.close();
}

/// What a cut made of a polygon.
enum class Cut { nothing_outside, nothing_inside, done };

/// Keeps what has distance >= 0, the linear function with values d0, d1, d2 at the triangle's corners. Two tets that
/// share a plane see these exactly negated, hence the same line, however small the angle. The new edge gets `mark`.
/// `out` is untouched unless `done`.
HWY_INLINE Cut keep_inside(double d0, double d1, double d2, std::uint64_t mark, const PlanePolygon& in,
                           PlanePolygon& out) {
  const TagD d;
  alignas(64) double distance[PlanePolygon::kMost];
  unsigned outside = 0;
  for (std::size_t i = 0; i < PlanePolygon::kMost; i += kLanesD) {
    const VecD u = hn::Load(d, in.u + i), v = hn::Load(d, in.v + i);
    const VecD w = hn::Sub(hn::Sub(hn::Set(d, 1.0), u), v);
    const VecD value =
        hn::Add(hn::Add(hn::Mul(w, hn::Set(d, d0)), hn::Mul(u, hn::Set(d, d1))), hn::Mul(v, hn::Set(d, d2)));
    hn::Store(value, d, distance + i);
    outside |= mask_bits(d, hn::Lt(value, hn::Zero(d))) << i;
  }
  const auto n = static_cast<unsigned>(in.count);
  const unsigned all = (1u << n) - 1;
  outside &= all;
  if (outside == 0) return Cut::nothing_outside;
  if (outside == all) return Cut::nothing_inside;
  const unsigned inside = all & ~outside;
  const unsigned starts = inside & ~((inside << 1) | (inside >> (n - 1)));  // inside, and the one before is not
  if ((starts & (starts - 1)) != 0) {
    keep_inside_slowly(distance, mark, in, out);
    return out.count < 3 ? Cut::nothing_inside : Cut::done;
  }
  const auto first = static_cast<unsigned>(std::countr_zero(starts));
  const auto run = static_cast<unsigned>(std::popcount(inside));
  const unsigned before = first == 0 ? n - 1 : first - 1;
  unsigned last = first + run - 1, after = first + run;
  if (last >= n) last -= n;
  if (after >= n) after -= n;
  const double s = distance[before] / (distance[before] - distance[first]);
  const double t = distance[last] / (distance[last] - distance[after]);
  std::memcpy(out.u + 1, in.u + first, PlanePolygon::kMost * sizeof(double));
  std::memcpy(out.v + 1, in.v + first, PlanePolygon::kMost * sizeof(double));
  out.u[0] = in.u[before] + s * (in.u[first] - in.u[before]);
  out.v[0] = in.v[before] + s * (in.v[first] - in.v[before]);
  out.u[run + 1] = in.u[last] + t * (in.u[after] - in.u[last]);
  out.v[run + 1] = in.v[last] + t * (in.v[after] - in.v[last]);
  // Edges: those from `before` to `last` in a row, then the new one.
  const std::uint64_t turned = before == 0 ? in.edges : in.edges >> (8 * before) | in.edges << (8 * (n - before));
  const unsigned kept = 8 * (run + 1);  // at most 7 edges: one vertex at least is outside, and n is at most 8
  out.edges = (kept == 64 ? turned : turned & ((std::uint64_t{1} << kept) - 1)) | (kept == 64 ? 0 : mark << kept);
  out.count = static_cast<int>(run) + 2;
  out.close();
  return Cut::done;
}

/// Cuts by the planes of in_tet.cut. Returns what is left of the polygon, itself or one of the two buffers; null where
/// nothing is. The buffers hold finite numbers.
HWY_INLINE const PlanePolygon* clip(const TriangleInTet& in_tet, const PlanePolygon* polygon, PlanePolygon* buffers) {
  std::size_t next = 0;
  for (unsigned planes = in_tet.cut; planes != 0; planes &= planes - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(planes));
    const Cut cut =
        keep_inside(in_tet.corner[0][i], in_tet.corner[1][i], in_tet.corner[2][i], i, *polygon, buffers[next]);
    if (cut == Cut::nothing_inside) return nullptr;
    if (cut == Cut::nothing_outside) continue;
    polygon = &buffers[next];
    next = 1 - next;
  }
  return polygon;
}

HWY_INLINE void set_whole_triangle(PlanePolygon& polygon) {
  static constexpr double kU[8] = {0, 1, 0, 0, 1, 0, 0, 0}, kV[8] = {0, 0, 1, 0, 0, 1, 0, 0};
  std::memcpy(polygon.u, kU, sizeof(kU));
  std::memcpy(polygon.v, kV, sizeof(kV));
  std::memset(polygon.u + 8, 0, sizeof(kU));
  std::memset(polygon.v + 8, 0, sizeof(kV));
  polygon.edges = kOwnEdge | kOwnEdge << 8 | kOwnEdge << 16;
  polygon.count = 3;
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
