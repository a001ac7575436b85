// A curve through points, with straight lines between them.
#pragma once

#include <algorithm>

#include "core/layout/layout.h"

namespace taxel {

/// Returns v_i + (x - u_i) (v_i+1 - v_i) / (u_i+1 - u_i) on the segment of x. The outer segments continue beyond the
/// ends. The curve has two points or more.
inline double piecewise_linear(const Curve& curve, double x) {
  const auto inner = std::upper_bound(curve.begin() + 1, curve.end() - 1, x,
                                      [](double reading, const CurvePoint& p) { return reading < p.reading; });
  const CurvePoint &a = *(inner - 1), &b = *inner;
  return a.value + (x - a.reading) * (b.value - a.value) / (b.reading - a.reading);
}

}  // namespace taxel
