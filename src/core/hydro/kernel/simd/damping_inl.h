// Hunt and Crossley's damping of the pressure, for doubles and for lanes. Lane code includes this file once per target;
// scalar code includes it without Highway.
#if defined(TAXEL_DAMPING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TAXEL_DAMPING_INL_H
#undef TAXEL_DAMPING_INL_H
#else
#define TAXEL_DAMPING_INL_H
#endif

#ifdef HWY_TARGET_INCLUDE
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {
#else
namespace taxel {
#endif

/// Returns 1 - d vn of Hunt and Crossley (1975): p = p0 (1 - d vn) if that is positive, and 0 otherwise.
template <class Number>
inline Number damping_factor(const Number& one, const Number& dissipation, const Number& normal_speed) {
  return one - dissipation * normal_speed;
}

#ifdef HWY_TARGET_INCLUDE
}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#else
}  // namespace taxel
#endif
#endif
