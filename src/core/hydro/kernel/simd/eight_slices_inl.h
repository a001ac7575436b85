// The slices of eight tets at a time, one in each lane, as polygons of a contact surface. A lane has the bits that
// slice_tet(), to_plane() and emit() give one tet, because its operations are theirs, in the same order. Included once
// per target.
#if defined(TAXEL_EIGHT_SLICES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TAXEL_EIGHT_SLICES_INL_H
#undef TAXEL_EIGHT_SLICES_INL_H
#else
#define TAXEL_EIGHT_SLICES_INL_H
#endif

#include "core/hydro/kernel/simd/eight_points_inl.h"
#include "core/hydro/kernel/slice_tet.h"
#include "core/hydro/kernel/surface_writer.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

/// Eight vectors in memory.
struct alignas(64) StoredPoints {
  double x[8], y[8], z[8];
  HWY_INLINE void set(std::size_t lane, const dvec3& p) { x[lane] = p.x, y[lane] = p.y, z[lane] = p.z; }
  [[nodiscard]] HWY_INLINE dvec3 at(std::size_t lane) const { return {x[lane], y[lane], z[lane]}; }
};
HWY_INLINE EightPoints load_points(const StoredPoints& p) {
  return {load_eight(p.x), load_eight(p.y), load_eight(p.z)};
}
HWY_INLINE void store_points(const EightPoints& p, StoredPoints& to) {
  store_eight(p.x, to.x), store_eight(p.y, to.y), store_eight(p.z, to.z);
}

/// Eight tets in the lanes, frame S.
struct EightTets {
  StoredPoints corner[4];
  alignas(64) double number[4][8];          ///< numbers of the corners in the mesh
  alignas(64) double pressure[4][8];        ///< at the corners [Pa]; not set for a rigid half-space
  StoredPoints gradient;                    ///< gradient of the tet's pressure [Pa/m]
  alignas(64) double constant[8], size[8];  ///< PackedTet::constant, PackedTet::size
  std::int32_t tet[8];
};

/// The signed distances of the corners of eight tets from the surface, and its unit normals, that of growing distance.
struct EightDistances {
  Eight at[4];
  EightPoints normal;
};

/// The polygons of eight cut tets, frame A.
struct StoredSlices {
  StoredPoints vertices[4], push, centroid, gradient;
  alignas(64) double pressure[4][8], area[8], mean_pressure[8];
  unsigned plain;        ///< bit i is set if lane i is a polygon that emit() would add as it is
  unsigned quadrangles;  ///< bit i is set if it has four vertices
};

/// The four corners of slices that begin with the first corner of the basis, and the coordinates of all corners in
/// their original order.
struct EightBases {
  EightPoints x[4];
  Eight u[4], v[4];
};

/// The corner of each slice at which the basis begins: see basis_of().
struct EightStarts {
  EightAnswers one, two, three;  ///< the last one that holds counts; none: 0
  /// Returns element i of four that are counted from the start of the basis on; `step` is 1, or -1 for the reverse.
  template <class T>
  HWY_INLINE T pick(const T (&of)[4], std::size_t i, std::size_t step) const {
    return choose(three, of[(i + 3 * step) & 3],
                  choose(two, of[(i + 2 * step) & 3], choose(one, of[(i + step) & 3], of[i])));
  }
};

HWY_INLINE EightStarts find_starts(const EightPoints (&p)[4], const EightPoints& normal, const EightAnswers& is_quad) {
  const auto area = [&](std::size_t i)
                        HWY_ATTR { return inner(outer(p[(i + 1) & 3] - p[i], p[(i + 2) & 3] - p[i]), normal); };
  Eight most = area(0);
  EightStarts starts;
  const auto larger_than_most = [&](std::size_t i) HWY_ATTR {
    const Eight a = area(i);
    const EightAnswers is_larger = greater(a, most) && is_quad;
    most = choose(is_larger, a, most);
    return is_larger;
  };
  starts.one = larger_than_most(1);
  starts.two = larger_than_most(2);
  starts.three = larger_than_most(3);
  return starts;
}

/// Sums of fan_sums() for triangles and quadrangles.
struct EightFans {
  Eight twice_area, u, v;
  EightAnswers crowded;
};
HWY_INLINE EightFans sum_fans(const EightBases& b, const EightAnswers& is_quad, const Eight& uu, const Eight& uv,
                              const Eight& vv, const Eight& merge_distance) {
  Eight u[4], v[4];
  for (std::size_t i = 0; i < 4; ++i) u[i] = b.u[i] - b.u[0], v[i] = b.v[i] - b.v[0];
  const Eight zero = set_eight(0.0);
  const Eight first = u[1] * v[2] - u[2] * v[1], second = choose(is_quad, u[2] * v[3] - u[3] * v[2], zero);
  EightFans fans;
  fans.twice_area = second + first;
  fans.u = second * (u[2] + u[3]) + first * (u[1] + u[2]);
  fans.v = second * (v[2] + v[3]) + first * (v[1] + v[2]);
  const Eight near = merge_distance * merge_distance, uv2 = set_eight(2.0) * uv;
  const auto is_close = [&](const Eight& du, const Eight& dv)
                            HWY_ATTR { return greater(near, uu * (du * du) + (uv2 * (du * dv) + vv * (dv * dv))); };
  fans.crowded = is_close(u[1] - u[0], v[1] - v[0]) || is_close(u[2] - u[1], v[2] - v[1]);
  const Eight after_u = choose(is_quad, u[3], u[0]), after_v = choose(is_quad, v[3], v[0]);
  fans.crowded = fans.crowded || is_close(after_u - u[2], after_v - v[2]);
  fans.crowded = fans.crowded || (is_quad && is_close(u[0] - u[3], v[0] - v[3]));
  return fans;
}

/// Returns which lanes have a basis with an area; sets the coordinates of the slices' corners.
HWY_INLINE EightAnswers set_coordinates(const EightPoints& eu, const EightPoints& ev, const EightPoints& normal,
                                        const EightStarts& starts, EightBases& b) {
  const EightPoints beside_v = outer(ev, normal), beside_u = outer(normal, eu), r = b.x[3] - b.x[0];
  const Eight area = inner(eu, beside_v), zero = set_eight(0.0), one = set_eight(1.0);
  const Eight u[4] = {zero, one, zero, inner(r, beside_v) / area};
  const Eight v[4] = {zero, zero, one, inner(r, beside_u) / area};
  for (std::size_t i = 0; i < 4; ++i) {
    b.u[i] = starts.pick(u, i, 3);
    b.v[i] = starts.pick(v, i, 3);
  }
  return greater(area, zero);
}

/// Row r, column c of eight times eight bits is bit 8 r + c. Returns the transposed bits.
HWY_INLINE std::uint64_t transpose_bits(std::uint64_t x) {
  std::uint64_t t = (x ^ (x >> 7)) & 0x00AA00AA00AA00AAu;
  x ^= t ^ (t << 7);
  t = (x ^ (x >> 14)) & 0x0000CCCC0000CCCCu;
  x ^= t ^ (t << 14);
  t = (x ^ (x >> 28)) & 0x00000000F0F0F0F0u;
  return x ^ t ^ (t << 28);
}

/// Byte i of the result: the corners of tet i that are on the positive side, bit by bit, as slice_tet() counts them.
HWY_INLINE std::uint64_t find_sides(const EightDistances& distances) {
  std::uint64_t positive = 0;
  for (std::size_t i = 0; i < 4; ++i)
    positive |= static_cast<std::uint64_t>(~less(distances.at[i], set_eight(0.0)) & 0xffu) << (8 * i);
  return transpose_bits(positive);
}

/// A corner of the tet in each lane.
struct EightCorners {
  EightPoints x;
  Eight distance, number;
};
HWY_INLINE EightCorners choose(const EightAnswers& answers, const EightCorners& yes, const EightCorners& no) {
  return {choose(answers, yes.x, no.x), choose(answers, yes.distance, no.distance),
          choose(answers, yes.number, no.number)};
}

/// Sets the points where the surface crosses the edges of the tets, in the order of their rings.
HWY_INLINE void cross_edges(const EightTets& tets, const EightDistances& distances, std::uint64_t sides,
                            EightPoints (&points)[4]) {
  EightCorners corners[4];
  for (std::size_t i = 0; i < 4; ++i)
    corners[i] = {load_points(tets.corner[i]), distances.at[i], load_eight(tets.number[i])};
  std::uint64_t low = 0, high = 0;
  for (std::size_t lane = 0; lane < 8; ++lane) {
    const std::uint64_t ends = kPackedRings[sides >> (8 * lane) & 15u];
    low |= (ends & 0xffu) << (8 * lane);
    high |= (ends >> 8) << (8 * lane);
  }
  const std::uint64_t of_edges[2] = {transpose_bits(low), transpose_bits(high)};  // two edges each
  const auto corner = [&](std::uint64_t ends) HWY_ATTR {
    const EightAnswers odd = answers_of(ends & 0xffu), upper = answers_of(ends >> 8 & 0xffu);
    return choose(upper, choose(odd, corners[3], corners[2]), choose(odd, corners[1], corners[0]));
  };
  for (std::size_t e = 0; e < 4; ++e) {
    const std::uint64_t ends = of_edges[e / 2] >> (32 * (e % 2));
    const EightCorners first = corner(ends), second = corner(ends >> 16);
    const EightAnswers later = greater(first.number, second.number);
    const EightCorners from = choose(later, second, first), to = choose(later, first, second);
    points[e] = from.x + from.distance / (from.distance - to.distance) * (to.x - from.x);
  }
}

/// Writes the polygons of cut tets in frame A, whose pose of S is X_AS, or null if S is A. `sides` is that of
/// find_sides().
HWY_INLINE void slice_eight(const EightTets& tets, const EightDistances& distances, std::uint64_t sides,
                            const RigidTransform* X_AS, bool reverse, StoredSlices& out) {
  EightPoints p[4];
  cross_edges(tets, distances, sides, p);
  const EightPoints& normal = distances.normal;
  const std::uint64_t corners = transpose_bits(sides);  // of cut tets: an even number of corners on a side are two
  const auto quads = static_cast<unsigned>(~(corners ^ corners >> 8 ^ corners >> 16 ^ corners >> 24) & 0xffu);
  const EightAnswers is_quad = answers_of(quads);
  const EightStarts starts = find_starts(p, normal, is_quad);
  EightBases b;
  for (std::size_t i = 0; i < 4; ++i) b.x[i] = starts.pick(p, i, 1);
  EightPoints eu = b.x[1] - b.x[0], ev = b.x[2] - b.x[0];
  const EightAnswers spans = set_coordinates(eu, ev, normal, starts, b);
  const Eight size = load_eight(tets.size), zero = set_eight(0.0);
  const EightFans fans =
      sum_fans(b, is_quad, inner(eu, eu), inner(eu, ev), inner(ev, ev), set_eight(kMergeDistance) * size);
  const Eight area = set_eight(0.5) * inner(outer(eu, ev), normal) * fans.twice_area;
  const Eight third = set_eight(1.0) / (set_eight(3.0) * fans.twice_area);
  const Eight u = b.u[0] + fans.u * third, v = b.v[0] + fans.v * third;

  EightPoints gradient = load_points(tets.gradient);
  const Eight constant = load_eight(tets.constant);
  const Eight p0 = inner(gradient, b.x[0]) + constant, pu = inner(gradient, b.x[1]) + constant - p0;
  const Eight pv = inner(gradient, b.x[2]) + constant - p0, mean = p0 + u * pu + v * pv;
  const Eight least = set_eight(kTouchingPressure) * size;
  const EightAnswers pushes = greater(mean, zero) && greater(mean * mean, least * least * inner(gradient, gradient));
  const EightAnswers is_large = greater(area, set_eight(kSliverArea) * size * size);
  out.plain = bits(pushes && is_large) & ~bits(fans.crowded) & (bits(spans) | ~quads);
  out.quadrangles = quads;

  EightPoints push = reverse ? set_points(dvec3(-0.0)) - normal : normal, origin = b.x[0];
  if (X_AS != nullptr) {
    origin = rotate(X_AS->R, origin) + set_points(X_AS->p);
    eu = rotate(X_AS->R, eu);
    ev = rotate(X_AS->R, ev);
    push = rotate(X_AS->R, push);
    gradient = rotate(X_AS->R, gradient);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    store_points(origin + b.u[i] * eu + b.v[i] * ev, out.vertices[i]);
    store_eight(larger(zero, p0 + b.u[i] * pu + b.v[i] * pv), out.pressure[i]);
  }
  store_points(push, out.push);
  store_points(origin + u * eu + v * ev, out.centroid);
  store_points(gradient, out.gradient);
  store_eight(area, out.area);
  store_eight(mean, out.mean_pressure);
}

/// Adds the polygon of a lane.
HWY_INLINE void add_slice(const StoredSlices& slices, std::size_t lane, std::int32_t tet, SurfaceWriter& writer) {
  const std::size_t count = (slices.quadrangles >> lane & 1u) != 0 ? 4 : 3;
  const SurfaceWriter::Slots slots = writer.slots();
  const std::size_t turn = writer.reverse() ? count - 1 : 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t from = turn == 0 ? i : (turn - i) & 3;
    slots.vertices[i] = slices.vertices[from].at(lane);
    slots.pressure[i] = slices.pressure[from][lane];
  }
  writer.close(static_cast<int>(count), slices.push.at(lane), slices.area[lane], slices.centroid.at(lane),
               slices.mean_pressure[lane], slices.gradient.at(lane), tet);
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
