// Eight points, or vectors, at a time: sums and products in the order of glm, so that a lane has the bits of a dvec3.
// Included once per target.
#if defined(TAXEL_EIGHT_POINTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TAXEL_EIGHT_POINTS_INL_H
#undef TAXEL_EIGHT_POINTS_INL_H
#else
#define TAXEL_EIGHT_POINTS_INL_H
#endif

#include "core/base/math.h"
#include "core/hydro/kernel/simd/eight_inl.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

struct EightPoints {
  Eight x, y, z;
};
HWY_INLINE EightPoints set_points(const dvec3& p) {
  return {set_eight(p.x), set_eight(p.y), set_eight(p.z)};
}
HWY_INLINE EightPoints operator+(const EightPoints& a, const EightPoints& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
HWY_INLINE EightPoints operator-(const EightPoints& a, const EightPoints& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
HWY_INLINE EightPoints operator*(const Eight& s, const EightPoints& a) {
  return {s * a.x, s * a.y, s * a.z};
}
HWY_INLINE EightPoints operator/(const EightPoints& a, const Eight& s) {
  return {a.x / s, a.y / s, a.z / s};
}
HWY_INLINE Eight inner(const EightPoints& a, const EightPoints& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
HWY_INLINE EightPoints outer(const EightPoints& a, const EightPoints& b) {
  return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
}
HWY_INLINE EightPoints rotate(const dmat3& R, const EightPoints& a) {
  const auto row = [&](int i) {
    return set_eight(R[0][i]) * a.x + set_eight(R[1][i]) * a.y + set_eight(R[2][i]) * a.z;
  };
  return {row(0), row(1), row(2)};
}

/// One answer per lane.
struct EightAnswers {
  hn::Mask<TagE> part[Eight::kParts];
};
HWY_INLINE EightAnswers greater(const Eight& a, const Eight& b) {
  EightAnswers r;
  for (std::size_t i = 0; i < Eight::kParts; ++i) r.part[i] = hn::Gt(a.part[i], b.part[i]);
  return r;
}
HWY_INLINE EightAnswers operator&&(const EightAnswers& a, const EightAnswers& b) {
  EightAnswers r;
  for (std::size_t i = 0; i < Eight::kParts; ++i) r.part[i] = hn::And(a.part[i], b.part[i]);
  return r;
}
HWY_INLINE EightAnswers operator||(const EightAnswers& a, const EightAnswers& b) {
  EightAnswers r;
  for (std::size_t i = 0; i < Eight::kParts; ++i) r.part[i] = hn::Or(a.part[i], b.part[i]);
  return r;
}
/// Bit i: lane i.
HWY_INLINE unsigned bits(const EightAnswers& a) {
  unsigned r = 0;
  for (std::size_t i = 0; i < Eight::kParts; ++i) r |= mask_bits(TagE(), a.part[i]) << (i * Eight::kLanes);
  return r;
}
/// Lane i answers with bit i.
HWY_INLINE EightAnswers answers_of(unsigned bits) {
  EightAnswers r;
  for (std::size_t i = 0; i < Eight::kParts; ++i) {
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits >> (i * Eight::kLanes))};
    r.part[i] = hn::LoadMaskBits(TagE(), bytes);
  }
  return r;
}
/// Lane by lane `yes` where the answer is yes, otherwise `no`.
HWY_INLINE Eight choose(const EightAnswers& answers, const Eight& yes, const Eight& no) {
  Eight r;
  for (std::size_t i = 0; i < Eight::kParts; ++i) r.part[i] = hn::IfThenElse(answers.part[i], yes.part[i], no.part[i]);
  return r;
}
HWY_INLINE EightPoints choose(const EightAnswers& answers, const EightPoints& yes, const EightPoints& no) {
  return {choose(answers, yes.x, no.x), choose(answers, yes.y, no.y), choose(answers, yes.z, no.z)};
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
