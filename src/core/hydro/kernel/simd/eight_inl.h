// Eight doubles in as few registers as the instruction set has for them. Included once per target.
#if defined(TAXEL_EIGHT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TAXEL_EIGHT_INL_H
#undef TAXEL_EIGHT_INL_H
#else
#define TAXEL_EIGHT_INL_H
#endif

#include "core/hydro/kernel/simd/cut_lanes.h"
#include "core/hydro/kernel/simd/lanes_inl.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

using TagE = hn::CappedTag<double, 8>;
using VecE = hn::Vec<TagE>;
using TagEI = hn::RebindToSigned<TagE>;

struct Eight {
  static constexpr std::size_t kLanes = hn::MaxLanes(TagE()), kParts = 8 / kLanes;
  VecE part[kParts];
};

HWY_INLINE Eight set_eight(double x) {
  Eight r;
  for (std::size_t i = 0; i < Eight::kParts; ++i) r.part[i] = hn::Set(TagE(), x);
  return r;
}
HWY_INLINE Eight load_eight(const double* HWY_RESTRICT x) {
  Eight r;
  for (std::size_t i = 0; i < Eight::kParts; ++i) r.part[i] = hn::LoadU(TagE(), x + i * Eight::kLanes);
  return r;
}
HWY_INLINE void store_eight(const Eight& a, double* HWY_RESTRICT x) {
  for (std::size_t i = 0; i < Eight::kParts; ++i) hn::StoreU(a.part[i], TagE(), x + i * Eight::kLanes);
}
HWY_INLINE double first_lane(const Eight& a) {
  return hn::GetLane(a.part[0]);
}

HWY_INLINE Eight operator+(const Eight& a, const Eight& b) {
  Eight r;
  for (std::size_t i = 0; i < Eight::kParts; ++i) r.part[i] = hn::Add(a.part[i], b.part[i]);
  return r;
}
HWY_INLINE Eight operator-(const Eight& a, const Eight& b) {
  Eight r;
  for (std::size_t i = 0; i < Eight::kParts; ++i) r.part[i] = hn::Sub(a.part[i], b.part[i]);
  return r;
}
HWY_INLINE Eight operator*(const Eight& a, const Eight& b) {
  Eight r;
  for (std::size_t i = 0; i < Eight::kParts; ++i) r.part[i] = hn::Mul(a.part[i], b.part[i]);
  return r;
}
HWY_INLINE Eight operator/(const Eight& a, const Eight& b) {
  Eight r;
  for (std::size_t i = 0; i < Eight::kParts; ++i) r.part[i] = hn::Div(a.part[i], b.part[i]);
  return r;
}
/// a / b in the first four lanes, in the others 0: half as long as all of them.
HWY_INLINE Eight divide_four(const Eight& a, const Eight& b) {
  Eight r;
#if HWY_MAX_BYTES == 64
  const hn::Half<TagE> four;
  const auto low = hn::Div(hn::LowerHalf(four, a.part[0]), hn::LowerHalf(four, b.part[0]));
  r.part[0] = hn::ZeroExtendVector(TagE(), low);
#else
  for (std::size_t i = 0; i < Eight::kParts; ++i)
    r.part[i] = 2 * i < Eight::kParts ? hn::Div(a.part[i], b.part[i]) : hn::Zero(TagE());
#endif
  return r;
}
HWY_INLINE Eight larger(const Eight& a, const Eight& b) {
  Eight r;
  for (std::size_t i = 0; i < Eight::kParts; ++i) r.part[i] = hn::Max(a.part[i], b.part[i]);
  return r;
}
HWY_INLINE Eight square_root(const Eight& a) {
  Eight r;
  for (std::size_t i = 0; i < Eight::kParts; ++i) r.part[i] = hn::Sqrt(a.part[i]);
  return r;
}
/// Lane by lane: a < b ? yes : no.
HWY_INLINE Eight if_less(const Eight& a, const Eight& b, const Eight& yes, const Eight& no) {
  Eight r;
  for (std::size_t i = 0; i < Eight::kParts; ++i)
    r.part[i] = hn::IfThenElse(hn::Lt(a.part[i], b.part[i]), yes.part[i], no.part[i]);
  return r;
}
/// Bit i: lane i of a is less than that of b.
HWY_INLINE unsigned less(const Eight& a, const Eight& b) {
  unsigned bits = 0;
  for (std::size_t i = 0; i < Eight::kParts; ++i)
    bits |= mask_bits(TagE(), hn::Lt(a.part[i], b.part[i])) << (i * Eight::kLanes);
  return bits;
}

#if HWY_MAX_BYTES == 32
using Lanes = LaneHalves;

/// Four lanes of one vector. Highway takes them by numbers of lanes, which have to become halves each time.
HWY_INLINE __m256d take_half(const Eight& a, __m256i halves) {
  const __m256 lower = _mm256_permutevar8x32_ps(_mm256_castpd_ps(a.part[0].raw), halves);
  const __m256 upper = _mm256_permutevar8x32_ps(_mm256_castpd_ps(a.part[1].raw), halves);
  return _mm256_blendv_pd(_mm256_castps_pd(lower), _mm256_castps_pd(upper), _mm256_castsi256_pd(halves));
}
HWY_INLINE __m256i load_halves(const Lanes& n, std::size_t part) {
  return _mm256_load_si256(reinterpret_cast<const __m256i*>(n.half[part]));
}
#else
using Lanes = LaneNumbers;
#endif
inline constexpr const CutLanes<Lanes>& kCutLanes = kCutLanesAs<Lanes>;

/// Lane i is lane n[i] of a, where n[i] < kOther, and lane n[i] - kOther of b otherwise.
HWY_INLINE Eight take(const Eight& a, const Eight& b, const Lanes& n) {
  Eight r;
#if HWY_MAX_BYTES == 64  // Highway 1.0 has no name for this one
  r.part[0] = VecE{_mm512_permutex2var_pd(a.part[0].raw, hn::Load(TagEI(), n.lane).raw, b.part[0].raw)};
#elif HWY_MAX_BYTES == 32
  for (std::size_t i = 0; i < 2; ++i) {
    const __m256i halves = load_halves(n, i);
    const __m256d second = _mm256_castsi256_pd(_mm256_slli_epi32(halves, 1));
    r.part[i] = VecE{_mm256_blendv_pd(take_half(a, halves), take_half(b, halves), second)};
  }
#else
  double table[16];
  store_eight(a, table);
  store_eight(b, table + 8);
  double taken[8];
  for (std::size_t i = 0; i < 8; ++i) taken[i] = table[n.lane[i]];
  r = load_eight(taken);
#endif
  return r;
}

/// Lane i is lane n[i] of a.
HWY_INLINE Eight take(const Eight& a, const Lanes& n) {
  Eight r;
#if HWY_MAX_BYTES == 64
  r.part[0] = hn::TableLookupLanes(a.part[0], hn::SetTableIndices(TagE(), n.lane));
#elif HWY_MAX_BYTES == 32
  for (std::size_t i = 0; i < 2; ++i) r.part[i] = VecE{take_half(a, load_halves(n, i))};
#else
  double table[8], taken[8];
  store_eight(a, table);
  for (std::size_t i = 0; i < 8; ++i) taken[i] = table[n.lane[i]];
  r = load_eight(taken);
#endif
  return r;
}

/// x0 y0 z0 x1 y1 z1 and so on: 24 numbers.
HWY_INLINE void store_interleaved(const Eight& x, const Eight& y, const Eight& z, double* HWY_RESTRICT out) {
#if HWY_MAX_BYTES == 64
  // Two picks for each third: of x and y first, where lanes without a meaning are 0, then those of z.
  static constexpr LaneNumbers kXY[3] = {
      {{0, 8, 0, 1, 9, 0, 2, 10}}, {{0, 3, 11, 0, 4, 12, 0, 5}}, {{13, 0, 6, 14, 0, 7, 15, 0}}};
  static constexpr LaneNumbers kZ[3] = {
      {{0, 1, 8, 3, 4, 9, 6, 7}}, {{10, 1, 2, 11, 4, 5, 12, 7}}, {{0, 13, 2, 3, 14, 5, 6, 15}}};
  for (std::size_t i = 0; i < 3; ++i) store_eight(take(take(x, y, kXY[i]), z, kZ[i]), out + 8 * i);
#elif HWY_TARGET == HWY_SCALAR
  for (std::size_t i = 0; i < 8; ++i) {
    out[3 * i] = hn::GetLane(x.part[i]);
    out[3 * i + 1] = hn::GetLane(y.part[i]);
    out[3 * i + 2] = hn::GetLane(z.part[i]);
  }
#else
  for (std::size_t i = 0; i < Eight::kParts; ++i)
    hn::StoreInterleaved3(x.part[i], y.part[i], z.part[i], TagE(), out + 3 * i * Eight::kLanes);
#endif
}

/// ((a0 + a4) + (a2 + a6)) + ((a1 + a5) + (a3 + a7)).
HWY_INLINE double sum(const Eight& a) {
#if HWY_MAX_BYTES == 64 || HWY_MAX_BYTES == 32
#if HWY_MAX_BYTES == 64
  const hn::Half<TagE> four;
  const auto s = hn::Add(hn::LowerHalf(four, a.part[0]), hn::UpperHalf(four, a.part[0]));
#else
  const TagE four;
  const auto s = hn::Add(a.part[0], a.part[1]);
#endif
  const hn::Half<decltype(four)> two;
  const auto t = hn::Add(hn::LowerHalf(two, s), hn::UpperHalf(two, s));
  return hn::GetLane(t) + hn::GetLane(hn::Reverse2(two, t));
#else
  double s[8];
  store_eight(a, s);
  return ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
#endif
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
