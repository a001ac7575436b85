// The force of triangles at the edge of the area that the fields cover together.
#include "core/base/index.h"
#include "core/sensor/integral/force_integral.h"

namespace taxel {

bool ForceIntegral::covered() const {
  return std::any_of(at_.weights.begin(), at_.weights.end(), [](const FieldWeights::Weight& w) { return w.value > 0; });
}

/// Returns the edge of the fields between a point inside and a point outside, by the regula falsi on the margin
/// (Illinois variant). Returns nothing if the margin jumps there, as at a face that is turned away too far.
std::optional<dvec3> ForceIntegral::edge_of_cover(const Polygon& polygon, dvec3 inside, double inner, dvec3 outside,
                                                  double outer) {
  constexpr int kMost = 10;
  constexpr double kNear = 0.002;
  const double near = kNear * glm::distance(inside, outside);
  int side = 0;
  for (int i = 0; i < kMost; ++i) {
    const double part = outer < 0 && std::isfinite(outer) ? inner / (inner - outer) : 0.5;
    const dvec3 x = inside + part * (outside - inside);
    evaluate(polygon, x);
    if (std::abs(at_.margin) <= near) return x;
    if (covered()) {
      if (side > 0) outer *= 0.5;
      inside = x, inner = at_.margin, side = 1;
    } else {
      if (side < 0) inner *= 0.5;
      outside = x, outer = at_.margin, side = -1;
    }
  }
  return std::nullopt;
}

/// Adds the shares of a covered triangle to the shares of `e`, and its force to `pushed`, by the rule of degree 2.
void ForceIntegral::share_out(const Polygon& polygon, const std::array<dvec3, 3>& c, double area, Estimate& e,
                              double& pushed) {
  for (std::size_t i = 0; i < 3; ++i) {
    const dvec3 x = (c[0] + c[1] + c[2] + 3.0 * c[i]) / 6.0;
    evaluate(polygon, x);
    double sum = 0;
    for (const FieldWeights::Weight& w : at_.weights) sum += w.value;
    if (!(sum > 0)) continue;
    const double pressure = polygon.pressure(x);
    pushed += area / 3 * pressure;
    dvec3 friction(0);
    if (polygon.motion != nullptr) friction = polygon.motion->friction(pressure, polygon.polygon->normal, x);
    for (const FieldWeights::Weight& w : at_.weights) {
      Share& share = share_of(e.first, w.taxel);
      share.value += area / 3 * (at_.cover * w.value / sum) * pressure;
      share.friction += area / 3 * (at_.cover * w.value / sum) * friction;
    }
  }
}

/// Integrates a triangle whose corner `lone` is the only covered one, or the only one that is not covered, cut along
/// the chord of the edge of the fields. The margin at the chord's middle is the height of the edge over the chord; the
/// covered area is larger by two thirds of the product of chord and height.
ForceIntegral::Estimate ForceIntegral::cut_at(const Polygon& polygon, const Triangle& triangle, int lone,
                                              bool lone_covered, const std::array<double, 3>& margins) {
  constexpr double kLeftOver = 0.3, kFlat = 0.25;  // error as a fraction of the correction; largest height over chord
  Estimate e;
  e.first = e.end = static_cast<std::uint32_t>(shares_.size());
  e.error = std::numeric_limits<double>::infinity();
  const std::size_t l = at(lone), n = (l + 1) % 3, m = (l + 2) % 3;
  const auto& c = triangle.corners;
  const auto find = [&](std::size_t other) {
    const std::size_t in = lone_covered ? l : other, out = lone_covered ? other : l;
    return edge_of_cover(polygon, c[in], margins[in], c[out], margins[out]);
  };
  const std::optional<dvec3> a = find(n), b = a ? find(m) : std::nullopt;
  if (!b) return e;
  const dvec3 middle = 0.5 * (*a + *b);
  evaluate(polygon, middle);
  const double chord = glm::distance(*a, *b), height = at_.margin;
  if (!(std::abs(height) <= kFlat * chord)) return e;
  const double scale = triangle.area / glm::length(glm::cross(c[1] - c[0], c[2] - c[0]));  // divides twice an area
  const auto area_of = [&](const std::array<dvec3, 3>& t) {
    return scale * glm::length(glm::cross(t[1] - t[0], t[2] - t[0]));
  };
  const std::array<dvec3, 3> tip{c[l], *a, *b}, near{*a, c[n], c[m]}, far{*a, c[m], *b};
  const auto force_of = [&](const std::array<dvec3, 3>& t) {
    return area_of(t) * polygon.pressure((t[0] + t[1] + t[2]) / 3.0);
  };
  const double correction = 2.0 / 3 * 2 * scale * chord * height * polygon.pressure(middle);
  e.whole = triangle.area * polygon.pressure((c[0] + c[1] + c[2]) / 3.0);
  e.covered = correction + (lone_covered ? force_of(tip) : e.whole - force_of(tip));
  double pushed = 0;
  if (lone_covered) {
    share_out(polygon, tip, area_of(tip), e, pushed);
  } else {
    share_out(polygon, near, area_of(near), e, pushed);
    share_out(polygon, far, area_of(far), e, pushed);
  }
  e.end = static_cast<std::uint32_t>(shares_.size());
  if (!(pushed > 0) || !(e.covered >= 0)) return e;
  const double scaled = e.covered / pushed;
  e.covered = 0;
  for (std::uint32_t i = e.first; i < e.end; ++i) {
    shares_[i].value *= scaled;
    shares_[i].friction *= scaled;
    e.covered += shares_[i].value;
  }
  e.error = kLeftOver * std::abs(correction);
  return e;
}

/// Integrates a triangle at the edge of the fields. The error is infinite unless the edge separates one corner from the
/// other two.
ForceIntegral::Estimate ForceIntegral::cut(const Polygon& polygon, const Triangle& triangle) {
  std::array<double, 3> margins{};
  std::array<bool, 3> in{};
  for (std::size_t i = 0; i < 3; ++i) {
    evaluate(polygon, triangle.corners[i]);
    margins[i] = at_.margin;
    in[i] = covered();
  }
  for (int i = 0; i < 3; ++i)
    if (in[at(i)] != in[at((i + 1) % 3)] && in[at(i)] != in[at((i + 2) % 3)])
      return cut_at(polygon, triangle, i, in[at(i)], margins);
  const auto none = static_cast<std::uint32_t>(shares_.size());
  return {none, none, 0, 0, std::numeric_limits<double>::infinity()};
}

}  // namespace taxel
