// Friction and damping of a contact for one twist, eight points at a time: the inner loop of the implicit step.
//
// Each point of the surface (traction_points.h) adds its damped push and its friction per speed, beta = mu p phi(|vt|),
// to sums from which the wrench and the secant S = sum of J^T K J follow, with K = beta (I - n n^T) + p0 d n n^T. The
// sums stay in eight lanes to the end, which is one order of summation on every instruction set.
//
// phi needs an arc tangent. Here it is a polynomial in x^2 up to tan(pi/8), and larger arguments are reduced to this
// range; all ranges are computed and masks choose. So it has the same bits on every machine, and errs by less than the
// rounding of a double. A point that separates faster than 1/d has neither push nor friction. Theory:
// docs/theory/hydro.md, "Traction".
#include "core/hydro/traction_points.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/hydro/kernel/traction_sums.cpp"
#include <hwy/foreach_target.h>
// The line above includes this file once per instruction set: it stays first.
#include "core/hydro/kernel/simd/eight_inl.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

/// atan(x)/x - 1 over x^2, as a polynomial of u = x^2 for |x| <= tan(pi/8): interpolated at Chebyshev's points,
/// relative error of atan 7e-18.
inline constexpr double kArcTangent[] = {-0x1.5555555555555p-2, 0x1.999999999934cp-3,  -0x1.2492492436201p-3,
                                         0x1.c71c71853d7c8p-4,  -0x1.745d0b28a7649p-4, 0x1.3b12630643e8ap-4,
                                         -0x1.10fa77b104ae8p-4, 0x1.dfe6497394f40p-5,  -0x1.a0999c2994d42p-5,
                                         0x1.4162bf84bf0bfp-5,  -0x1.3a31b0297d745p-6};

/// Returns atan(x) for x >= 0. Above tan(pi/8) it uses atan(x) = pi/4 + atan((x - 1)/(x + 1)), above tan(3 pi/8) pi/2 -
/// atan(1/x).
HWY_INLINE Eight arc_tangent(const Eight& x) {
  const Eight one = set_eight(1), first = set_eight(0.41421356237309503), second = set_eight(2.4142135623730949);
  const Eight numerator = if_less(x, first, x, if_less(x, second, x - one, set_eight(-1)));
  const Eight denominator = if_less(x, first, one, if_less(x, second, x + one, x));
  const Eight offset = if_less(x, first, set_eight(0), if_less(x, second, set_eight(kPi / 4), set_eight(kPi / 2)));
  const Eight t = numerator / denominator, u = t * t;
  Eight q = set_eight(kArcTangent[10]);
  for (std::size_t i = 10; i-- > 0;) q = q * u + set_eight(kArcTangent[i]);
  return offset + (t + t * (u * q));
}

/// (2/pi) atan(v/vs)/v, with its limit at rest.
HWY_INLINE Eight slip_factors(const Eight& speed) {
  const Eight x = speed * set_eight(1 / kSlipSpeed);
  const Eight tiny = set_eight(1e-8);  // atan(x)/x = 1 to the last bit below
  const Eight factor = set_eight(2 / kPi) * arc_tangent(x) / if_less(x, tiny, set_eight(1), speed);
  return if_less(x, tiny, set_eight(2 / (kPi * kSlipSpeed)), factor);
}

double run_slip_factor(double speed) {
  return first_lane(slip_factors(set_eight(speed)));
}

struct Three {
  Eight x, y, z;
};
HWY_INLINE Three load_three(const double (&rows)[3][8]) {
  return {load_eight(rows[0]), load_eight(rows[1]), load_eight(rows[2])};
}
HWY_INLINE Eight inner(const Three& a, const Three& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

struct LaneSums {
  Eight force[3], torque[3], f, fx[3], fxx[3], fxy[3], outer[21];

  HWY_INLINE void clear() {
    const Eight zero = set_eight(0);
    for (Eight& s : force) s = zero;
    for (Eight& s : torque) s = zero;
    f = zero;
    for (Eight& s : fx) s = zero;
    for (Eight& s : fxx) s = zero;
    for (Eight& s : fxy) s = zero;
    for (Eight& s : outer) s = zero;
  }
  HWY_INLINE void add(const Three& x, const Three& n, const Three& m, const Eight& push, const Eight& friction,
                      const Eight& rest) {
    const Eight u[6] = {n.x, n.y, n.z, m.x, m.y, m.z};
    for (std::size_t i = 0; i < 3; ++i) {
      force[i] = force[i] + push * u[i];
      torque[i] = torque[i] + push * u[i + 3];
    }
    f = f + friction;
    const Eight gx = friction * x.x, gy = friction * x.y, gz = friction * x.z;
    fx[0] = fx[0] + gx, fx[1] = fx[1] + gy, fx[2] = fx[2] + gz;
    fxx[0] = fxx[0] + gx * x.x, fxx[1] = fxx[1] + gy * x.y, fxx[2] = fxx[2] + gz * x.z;
    fxy[0] = fxy[0] + gy * x.z, fxy[1] = fxy[1] + gz * x.x, fxy[2] = fxy[2] + gx * x.y;
    std::size_t k = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      const Eight gu = rest * u[i];
      for (std::size_t j = i; j < 6; ++j, ++k) outer[k] = outer[k] + gu * u[j];
    }
  }
  [[nodiscard]] TractionSums total() const {
    TractionSums t;
    t.f = sum(f);
    for (std::size_t i = 0; i < 3; ++i) {
      t.force[i] = sum(force[i]);
      t.torque[i] = sum(torque[i]);
      t.fx[i] = sum(fx[i]);
      t.fxx[i] = sum(fxx[i]);
      t.fxy[i] = sum(fxy[i]);
    }
    for (std::size_t k = 0; k < 21; ++k) t.outer[k] = sum(outer[k]);
    return t;
  }
};

TractionSums run_traction(std::span<const TractionBlock> blocks, const PairProperties& pair, const Twist& V_BA) {
  const auto spread = [](const dvec3& v) { return Three{set_eight(v.x), set_eight(v.y), set_eight(v.z)}; };
  const Three linear = spread(V_BA.linear), angular = spread(V_BA.angular);
  const Eight dissipation = set_eight(pair.dissipation), friction = set_eight(pair.friction);
  LaneSums sums;
  sums.clear();
  for (const TractionBlock& block : blocks) {
    const Three x = load_three(block.x), n = load_three(block.n), m = load_three(block.m);
    const Three v{linear.x + (angular.y * x.z - angular.z * x.y), linear.y + (angular.z * x.x - angular.x * x.z),
                  linear.z + (angular.x * x.y - angular.y * x.x)};
    const Eight vn = inner(v, n);
    const Eight factor = set_eight(1) - dissipation * vn;  // as in traction.cpp: Hunt and Crossley (1975)
    const Eight push = if_less(set_eight(0), factor, load_eight(block.push), set_eight(0));
    const Three slip{v.x - vn * n.x, v.y - vn * n.y, v.z - vn * n.z};
    const Eight f = friction * push * factor * slip_factors(square_root(inner(slip, slip)));
    sums.add(x, n, m, push, f, push * dissipation - f);
  }
  return sums.total();
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace taxel {
HWY_EXPORT(run_traction);
HWY_EXPORT(run_slip_factor);

TractionSums sum_traction(std::span<const TractionBlock> blocks, const PairProperties& pair, const Twist& V_BA) {
  return HWY_DYNAMIC_DISPATCH(run_traction)(blocks, pair, V_BA);
}
double slip_factor(double speed) {
  return HWY_DYNAMIC_DISPATCH(run_slip_factor)(speed);
}
}  // namespace taxel
#endif
