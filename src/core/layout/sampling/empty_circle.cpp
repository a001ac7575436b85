// The largest empty circle near a place between points of the plane, by climbing the distance to the nearest point.
//
// From the start the way leads straight away from the nearest point until a second point is as near, then along the
// bisector of the two until a third one is, and from there along the bisector of the pair that leads away from the
// third. Where no pair does, the three points surround the place: it is a vertex of the Voronoi diagram and a local
// maximum. How far a stretch leads follows from one pass over all points, sixteen at a time, since the difference of
// two squared distances is linear along it. A climb has three or four stretches.
//
// No diagram is built, which would cost more than the few climbs that a sample needs. The climb ends where its reach is
// used up. Sums have one order on every instruction set, and ties go to the first point, so all machines give the same
// bits.
#include "core/layout/sampling/empty_circle.h"

#include <array>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/layout/sampling/empty_circle.cpp"
#include <hwy/foreach_target.h>
// The line above includes this file once per instruction set: it stays first.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<float, 16>;
using TagI = hn::RebindToSigned<Tag>;
using Vec = hn::Vec<Tag>;
using VecI = hn::Vec<TagI>;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

HWY_INLINE float squared(const vec2& v) {
  return v.x * v.x + v.y * v.y;
}

/// The least of the values shown to it, and the first that has it.
class Least {
 public:
  HWY_INLINE Least() : value_(hn::Set(Tag(), kInfinity)), number_(hn::Zero(TagI())) {}
  HWY_INLINE void show(const Vec& value, const VecI& number) {
    const auto less = hn::Lt(value, value_);
    value_ = hn::IfThenElse(less, value, value_);
    number_ = hn::IfThenElse(hn::RebindMask(TagI(), less), number, number_);
  }
  HWY_INLINE float value() const { return hn::GetLane(hn::MinOfLanes(Tag(), value_)); }
  HWY_INLINE int number() const {
    const auto least = hn::RebindMask(TagI(), hn::Eq(value_, hn::MinOfLanes(Tag(), value_)));
    return hn::GetLane(hn::MinOfLanes(TagI(), hn::IfThenElse(least, number_, hn::Set(TagI(), 1 << 30))));
  }

 private:
  Vec value_;
  VecI number_;
};

/// One climb. The arrays end with whole lanes; elements beyond `size` are ignored.
class Climber {
 public:
  Climber(const float* x, const float* y, int size) : x_(x), y_(y), size_(size) {}

  HWY_INLINE Hole climb(const vec2& start, float reach) {
    const int stretches = 8;  // a climb takes three or four
    at_ = start;
    active_[0] = nearest().number();
    count_ = 1;
    for (int i = 0; i < stretches; ++i)
      if (!advance(reach) || squared(at_ - start) > reach * reach) break;
    return {at_, squared(at_ - point(active_[0]))};
  }
  HWY_INLINE float clearance(const vec2& at) {
    at_ = at;
    return nearest().value();
  }

 private:
  HWY_INLINE vec2 point(int i) const { return {x_[i], y_[i]}; }

  HWY_INLINE Least nearest() const {
    const Tag d;
    const Vec at_x = hn::Set(d, at_.x), at_y = hn::Set(d, at_.y);
    return least_of([&](const Vec& x, const Vec& y, const VecI&) {
      const Vec dx = hn::Sub(at_x, x), dy = hn::Sub(at_y, y);
      return hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy));
    });
  }

  template <class Value>
  HWY_INLINE Least least_of(const Value& value) const {
    const Tag d;
    const TagI di;
    const VecI end = hn::Set(di, size_);
    Least least;
    for (int i = 0; i < size_; i += static_cast<int>(hn::Lanes(d))) {
      const VecI number = hn::Iota(di, i);
      const Vec v = value(hn::LoadU(d, x_ + i), hn::LoadU(d, y_ + i), number);
      const auto counts = hn::RebindMask(d, hn::Lt(number, end));
      least.show(hn::IfThenElse(counts, v, hn::Set(d, kInfinity)), number);
    }
    return least;
  }

  /// One straight stretch, until one more point is as near. False at the top or where `reach` is used up.
  HWY_INLINE bool advance(float reach) {
    vec2 up;
    if (!uphill(up)) return false;
    // |x + t u - q|^2 = |x + t u - a|^2 is linear in t: the first q to become as near as the active point a.
    const vec2 a = point(active_[0]);
    const Tag d;
    const TagI di;
    const Vec at_x = hn::Set(d, at_.x), at_y = hn::Set(d, at_.y), up_x = hn::Set(d, up.x), up_y = hn::Set(d, up.y);
    const Vec radius = hn::Set(d, squared(at_ - a)), along = hn::Set(d, up.x * a.x + up.y * a.y);
    const VecI first = hn::Set(di, active_[0]), second = hn::Set(di, active_[static_cast<std::size_t>(count_ - 1)]);
    const Least least = least_of([&](const Vec& x, const Vec& y, const VecI& number) {
      const Vec dx = hn::Sub(at_x, x), dy = hn::Sub(at_y, y);
      const Vec half = hn::Sub(hn::Add(hn::Mul(up_x, x), hn::Mul(up_y, y)), along), closing = hn::Add(half, half);
      const Vec t = hn::Div(hn::Sub(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)), radius), closing);
      const auto active = hn::Or(hn::Eq(number, first), hn::Eq(number, second));
      const auto meets = hn::AndNot(hn::RebindMask(d, active), hn::Gt(closing, hn::Zero(d)));
      return hn::IfThenElse(meets, t, hn::Set(d, kInfinity));
    });
    const float way = least.value();
    const bool stops = way < reach;
    at_ += (stops ? std::max(0.0F, way) : reach) * up;
    if (stops) active_[static_cast<std::size_t>(count_++)] = least.number();
    return stops;
  }

  /// The unit direction in which all active distances grow: away from one, along the bisector of two; of three the pair
  /// whose bisector leads away from the third. False where there is none: the top.
  HWY_INLINE bool uphill(vec2& up) {
    if (count_ == 1) {
      const vec2 away = at_ - point(active_[0]);
      const float length = std::sqrt(squared(away));
      up = length > 0.0F ? away / length : vec2(1, 0);
      return true;
    }
    if (count_ == 2) return along_bisector(active_[0], active_[1], up);
    for (std::size_t k = 0; k < 3; ++k) {
      const int p = active_[(k + 1) % 3], q = active_[(k + 2) % 3], left = active_[k];
      if (!along_bisector(p, q, up) || !(glm::dot(up, point(p) - point(left)) > 0.0F)) continue;
      active_ = {p, q, left};
      count_ = 2;
      return true;
    }
    return false;
  }

  HWY_INLINE bool along_bisector(int p, int q, vec2& up) const {
    const vec2 edge = point(q) - point(p);
    const float length = std::sqrt(squared(edge));
    if (!(length > 0.0F)) return false;
    up = vec2(-edge.y, edge.x) / length;
    if (glm::dot(up, at_ - point(p)) < 0.0F) up = -up;
    return true;
  }

  const float *x_, *y_;
  int size_;
  vec2 at_{0};                   // where the climb is
  std::array<int, 4> active_{};  // the points that are all equally near to it, at most three
  int count_ = 0;
};

Hole run_climb(const float* x, const float* y, int size, const vec2& start, float reach) {
  return Climber(x, y, size).climb(start, reach);
}
float run_clearance(const float* x, const float* y, int size, const vec2& at) {
  return Climber(x, y, size).clearance(at);
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace taxel {
HWY_EXPORT(run_climb);
HWY_EXPORT(run_clearance);

Hole HoleFinder::climb(const vec2& start, float reach) const {
  return HWY_DYNAMIC_DISPATCH(run_climb)(x_.data(), y_.data(), static_cast<int>(size_), start, reach);
}

float HoleFinder::clearance(const vec2& at) const {
  return HWY_DYNAMIC_DISPATCH(run_clearance)(x_.data(), y_.data(), static_cast<int>(size_), at);
}

void HoleFinder::grow() {
  x_.resize(2 * size_ + 2 * kLanes);
  y_.resize(x_.size());
}

}  // namespace taxel
#endif
