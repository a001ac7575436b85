// Four and eight doubles at a time, for every instruction set that Highway dispatches to. Included once per target. No
// fused multiply-add and one fixed order of sums: the same bits on every machine.
#if defined(TAXEL_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TAXEL_LANES_INL_H
#undef TAXEL_LANES_INL_H
#else
#define TAXEL_LANES_INL_H
#endif

#include <hwy/highway.h>

#include <array>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using TagD = hn::CappedTag<double, 4>;
using VecD = hn::Vec<TagD>;
using TagF = hn::CappedTag<float, 8>;
using VecF = hn::Vec<TagF>;
inline constexpr std::size_t kLanesD = hn::MaxLanes(TagD()), kLanesF = hn::MaxLanes(TagF());

/// Bit i: lane i.
template <class Tag, class Mask>
HWY_INLINE unsigned mask_bits(Tag tag, Mask mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(tag, mask, bytes);
  return bytes[0];
}

/// n x + m y + k z + o, in this order.
HWY_INLINE VecD plane(VecD nx, VecD x, VecD ny, VecD y, VecD nz, VecD z, VecD o) {
  return hn::Add(hn::Add(hn::Add(hn::Mul(nx, x), hn::Mul(ny, y)), hn::Mul(nz, z)), o);
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
