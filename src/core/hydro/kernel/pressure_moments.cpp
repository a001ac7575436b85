// The integral of p0 x over each polygon, eight polygons at a time.
//
// For a linear p0 it is A p0(c) c + M g about the centroid c, M the second moment of area. The polygon is a fan of
// triangles about c; a triangle with the corners a and b from c and the area A adds A/12 (a (g a) + b (g b) + s (g s)),
// s = a + b. Polygons of a group have different numbers of corners: a lane that has reached its last corner repeats
// this corner, and a triangle without area adds 0. Lanes beyond the last polygon repeat the first. Theory:
// docs/theory/hydro.md, "Traction".
#include "core/hydro/kernel/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/hydro/kernel/pressure_moments.cpp"
#include <hwy/foreach_target.h>
// The line above includes this file once per instruction set: it stays first.
#include "core/hydro/kernel/simd/eight_points_inl.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

/// Eight numbers that lie at `offset + index` doubles from `base`.
using Places = hn::Vec<TagEI>;
struct EightPlaces {
  Places part[Eight::kParts];
};
HWY_INLINE Eight gather(const double* base, const EightPlaces& places) {
  Eight r;
  for (std::size_t i = 0; i < Eight::kParts; ++i) r.part[i] = hn::GatherIndex(TagE(), base, places.part[i]);
  return r;
}
HWY_INLINE EightPoints gather_points(const dvec3* base, const EightPlaces& places) {
  return {gather(&base->x, places), gather(&base->y, places), gather(&base->z, places)};
}

constexpr std::size_t kDoubles = sizeof(ContactPolygon) / sizeof(double);  // from one polygon to the next
static_assert(sizeof(ContactPolygon) % sizeof(double) == 0 && sizeof(dvec3) == 3 * sizeof(double));

void run_pressure_moments(const ContactSurface& surface, std::size_t first, dvec3* out) {
  const std::size_t left = surface.polygons.size() - first, used = left < 8 ? left : 8;
  const ContactPolygon* polygons = surface.polygons.data() + first;
  alignas(64) std::int64_t places[8], starts[8], lasts[8];
  int most = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    const std::size_t at = i < used ? i : 0;
    const ContactPolygon& p = polygons[at];
    places[i] = static_cast<std::int64_t>(kDoubles * at);
    starts[i] = 3 * p.first;
    lasts[i] = 3 * (p.first + p.count - 1);
    most = p.count > most ? p.count : most;
  }
  const TagEI tag;
  EightPlaces place, corner, last;
  for (std::size_t i = 0; i < Eight::kParts; ++i) {
    place.part[i] = hn::LoadU(tag, places + i * Eight::kLanes);
    corner.part[i] = hn::LoadU(tag, starts + i * Eight::kLanes);
    last.part[i] = hn::LoadU(tag, lasts + i * Eight::kLanes);
  }
  const EightPoints c = gather_points(&polygons->centroid, place), n = gather_points(&polygons->normal, place);
  const EightPoints g = gather_points(&polygons->gradient, place);
  const Eight zero = set_eight(0);
  EightPoints sum{zero, zero, zero}, a = gather_points(surface.vertices.data(), last) - c;
  Eight ga = inner(g, a);
  for (int k = 0; k < most; ++k) {
    const EightPoints b = gather_points(surface.vertices.data(), corner) - c;
    const EightPoints cross{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    const Eight area = inner(cross, n);  // twice the triangle's; none where the last corner is met again
    const Eight gb = inner(g, b), both = ga + gb;
    sum.x = sum.x + area * (ga * a.x + gb * b.x + both * (a.x + b.x));
    sum.y = sum.y + area * (ga * a.y + gb * b.y + both * (a.y + b.y));
    sum.z = sum.z + area * (ga * a.z + gb * b.z + both * (a.z + b.z));
    a = b;
    ga = gb;
    for (std::size_t i = 0; i < Eight::kParts; ++i)
      corner.part[i] = hn::Min(last.part[i], hn::Add(corner.part[i], hn::Set(tag, 3)));
  }
  const Eight push = gather(&polygons->area, place) * gather(&polygons->pressure, place), part = set_eight(1.0 / 24);
  alignas(64) double x[8], y[8], z[8];
  store_eight(push * c.x + part * sum.x, x);
  store_eight(push * c.y + part * sum.y, y);
  store_eight(push * c.z + part * sum.z, z);
  for (std::size_t i = 0; i < used; ++i) out[i] = dvec3(x[i], y[i], z[i]);
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace taxel {
HWY_EXPORT(run_pressure_moments);

void find_pressure_moments(const ContactSurface& surface, std::size_t first, EightMoments& moments) {
  HWY_DYNAMIC_DISPATCH(run_pressure_moments)(surface, first, moments.data());
}
}  // namespace taxel
#endif
