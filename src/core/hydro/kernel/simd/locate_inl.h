// Finds the tet that contains a point. Included once per target.
#if defined(TAXEL_LOCATE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TAXEL_LOCATE_INL_H
#undef TAXEL_LOCATE_INL_H
#else
#define TAXEL_LOCATE_INL_H
#endif

#include <span>

#include "core/hydro/kernel/simd/clip_inl.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

/// Number instead of a tet if the point is outside. Smaller numbers also give the face.
inline constexpr std::int32_t kOutside = -1;

/// Number instead of a tet if the point is inside the body, but in a cell without tets.
inline constexpr std::int32_t kInCore = std::numeric_limits<std::int32_t>::min() + 1;

/// Returns the number for a point outside of face `face` of `tet`.
HWY_INLINE std::int32_t left_by(std::int32_t tet, std::size_t face) {
  return kOutside - 1 - (4 * tet + static_cast<std::int32_t>(face));
}

/// Returns a tet that contains x, by a traversal from a tet near x; kOutside if the traversal leaves the field. This
/// happens outside of the field and, rarely, behind a concave boundary; the seeds at the boundary compensate for it.
HWY_INLINE std::int32_t locate(const FieldIndex& field, const dvec3& x) {
  constexpr int kMaxTraversalSteps = 64;
  const DistanceGrid::Cell& cell = field.grid().cell_of(x);
  if (cell.face >= 0) {
    const DistanceGrid::Face& face = field.grid().faces()[static_cast<std::size_t>(cell.face)];
    if (glm::dot(face.n, x) + face.offset < 0) return left_by(face.tet, static_cast<std::size_t>(face.side));
  }
  if (cell.distance > 0) return kOutside;
  std::int32_t tet = cell.tet;
  if (tet == DistanceGrid::kCoreCell) return kInCore;
  const TagD d;
  const VecD px = hn::Set(d, x.x), py = hn::Set(d, x.y), pz = hn::Set(d, x.z);
  for (int step = 0; step < kMaxTraversalSteps && tet >= 0; ++step) {
    const PackedTet& t = field.tets()[static_cast<std::size_t>(tet)];
    alignas(32) double distance[4];
    for (std::size_t i = 0; i < 4; i += kLanesD) {
      hn::Store(plane(hn::Load(d, &t.nx[i]), px, hn::Load(d, &t.ny[i]), py, hn::Load(d, &t.nz[i]), pz,
                      hn::Load(d, &t.offset[i])),
                d, distance + i);
    }
    std::size_t least = distance[1] < distance[0] ? 1 : 0;
    const std::size_t other = distance[3] < distance[2] ? 3 : 2;
    if (distance[other] < distance[least]) least = other;
    if (!(distance[least] < 0)) return tet;
    if (t.neighbour[least] < 0) return left_by(tet, least);
    tet = t.neighbour[least];
  }
  return kOutside;
}

/// Returns the tet at which the segment from a to b leaves a convex field, or -1 if rounding hides it. `tet` contains
/// a, and b is outside.
HWY_INLINE std::int32_t leave(const FieldIndex& field, std::int32_t tet, const dvec3& a, const dvec3& b) {
  constexpr int kMaxTraversalSteps = 64;
  const TagD d;
  const VecD ax = hn::Set(d, a.x), ay = hn::Set(d, a.y), az = hn::Set(d, a.z);
  const VecD bx = hn::Set(d, b.x), by = hn::Set(d, b.y), bz = hn::Set(d, b.z);
  for (int step = 0; step < kMaxTraversalSteps; ++step) {
    const PackedTet& t = field.tets()[static_cast<std::size_t>(tet)];
    alignas(32) double at[4];  // parameters at which the segment leaves the planes
    for (std::size_t i = 0; i < 4; i += kLanesD) {
      const VecD nx = hn::Load(d, &t.nx[i]), ny = hn::Load(d, &t.ny[i]), nz = hn::Load(d, &t.nz[i]);
      const VecD o = hn::Load(d, &t.offset[i]);
      const VecD from = plane(nx, ax, ny, ay, nz, az, o), to = plane(nx, bx, ny, by, nz, bz, o);
      const VecD never = hn::Set(d, 2.0);
      hn::Store(hn::IfThenElse(hn::Lt(to, hn::Zero(d)), hn::Div(from, hn::Sub(from, to)), never), d, at + i);
    }
    std::size_t first = at[1] < at[0] ? 1 : 0;
    const std::size_t other = at[3] < at[2] ? 3 : 2;
    if (at[other] < at[first]) first = other;
    if (!(at[first] <= 1.0)) return -1;
    if (t.neighbour[first] < 0) return tet;
    tet = t.neighbour[first];
  }
  return -1;
}

/// Returns true if x, which no tet contains, may be inside the body: locate() found x in the core, or left the tets
/// there. A traversal to a point outside of the skin sometimes leaves through the core, too, but then the pressure of
/// the last tet is negative. The pressure is also negative at a point in a gap that reaches up to the skin; the grid
/// has the places of such gaps.
HWY_INLINE bool may_be_beyond(const FieldIndex& field, std::int32_t held, const dvec3& x) {
  if (held >= kOutside) return false;
  if (held == kInCore) return true;
  const std::int32_t code = kOutside - 1 - held;
  const PackedTet& tet = field.tets()[static_cast<std::size_t>(code / 4)];
  const LinearPressure p = tet.pressure();
  const bool left_by_core = (tet.core_faces >> (code % 4) & 1u) != 0;
  return (left_by_core && glm::dot(p.gradient, x) + p.constant > 0) || field.grid().may_hold_gap(x);
}

/// Returns true if all corners are outside of the face through which one of the traversals left. A convex body is then
/// elsewhere.
HWY_INLINE bool beyond_a_face(const FieldIndex& field, std::span<const dvec3> x, std::span<const std::int32_t> held) {
  for (const std::int32_t h : held) {
    if (h >= kOutside) continue;
    const std::int32_t code = kOutside - 1 - h;
    const PackedTet& t = field.tets()[static_cast<std::size_t>(code / 4)];
    const auto i = static_cast<std::size_t>(code % 4);
    const dvec3 n(t.nx[i], t.ny[i], t.nz[i]);
    double nearest = glm::dot(n, x[0]);
    for (const dvec3& corner : x.subspan(1)) nearest = std::max(nearest, glm::dot(n, corner));
    if (nearest + t.offset[i] < -kNearlyFlat * t.size) return true;
  }
  return false;
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
