// The modulus of a pad from the exact contact of a ball or a cylinder with an elastic layer. All lengths are over the
// thickness, pressures over E* = E/(1 - nu^2).
//
// A layer on a rigid base answers a pressure wave of the number xi with the compliance Z(xi) of a half-space's (Johnson
// 1985). With it the contact problem is one integral equation over the contact radius: for a ball after Lebedev and
// Ufliand (1958), for a cylinder with Bessel functions. Both are solved at Gauss-Legendre points by elimination (16 and
// more, 3 more per thickness of radius), the waves up to xi = 20, where 1 - Z is rounding. The pad with the same force
// at the same depth has the modulus that is sought.
//
// The contact radius is unknown: the user gives the radius of the overlap, sqrt(2 R depth), and regula falsi (with
// halving, Dowell and Jarratt 1971) finds the contact with this overlap. The range in which a modulus holds is walked
// in steps of 1.2 and then bisected.
//
// Pitfall: the depth of a cylinder contains an integral that converges slowly; int (1 - exp(-2 k))/k J0 dk = asinh(2/t)
// is split off. Theory: docs/theory/hydro.md, "Modulus of a pad from a data sheet".
#include "core/hydro/material/pad_modulus.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/limits.h"
#include "core/hydro/quadrature.h"

namespace taxel {
namespace {

/// 1 - Z falls as a polynomial times exp(-2 xi): at this wave number only rounding is left.
constexpr double kLastWave = 20.0;

/// Wave numbers from 0 to kLastWave, dense enough for cosines with arguments up to 2 radius xi.
QuadratureRule waves(double radius) {
  QuadratureRule rule;
  const int panels = static_cast<int>(std::ceil(kLastWave * std::max(1.0, radius / 8.0)));
  for (int i = 0; i < panels; ++i) add_gauss_legendre(kLastWave * i / panels, kLastWave * (i + 1) / panels, 14, rule);
  return rule;
}

/// Solves A x = b for several right sides in place, by elimination with the largest pivot. A is square, row by row.
void solve(std::vector<double>& a, std::vector<std::vector<double>>& sides) {
  const std::size_t n = sides.front().size();
  for (std::size_t column = 0; column < n; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column + 1; row < n; ++row)
      if (std::abs(a[row * n + column]) > std::abs(a[pivot * n + column])) pivot = row;
    for (std::size_t k = 0; k < n; ++k) std::swap(a[pivot * n + k], a[column * n + k]);
    for (std::vector<double>& side : sides) std::swap(side[pivot], side[column]);
    for (std::size_t row = column + 1; row < n; ++row) {
      const double factor = a[row * n + column] / a[column * n + column];
      for (std::size_t k = column; k < n; ++k) a[row * n + k] -= factor * a[column * n + k];
      for (std::vector<double>& side : sides) side[row] -= factor * side[column];
    }
  }
  for (std::size_t row = n; row-- > 0;)
    for (std::vector<double>& side : sides) {
      for (std::size_t k = row + 1; k < n; ++k) side[row] -= a[row * n + k] * side[k];
      side[row] /= a[row * n + row];
    }
}

/// The matrix I - sum over waves k of left(k, t) right(k, s) ds at the n nodes t, s of an equation. The values of one
/// wave are neighbours.
std::vector<double> equation_matrix(const QuadratureRule& points, const std::vector<double>& left,
                                    const std::vector<double>& right) {
  const std::size_t n = points.nodes.size(), m = left.size() / n;
  std::vector<double> matrix(n * n, 0.0);
  for (std::size_t k = 0; k < m; ++k)
    for (std::size_t i = 0; i < n; ++i) {
      const double factor = left[k * n + i];
      double* const row = matrix.data() + i * n;
      for (std::size_t j = 0; j < n; ++j) row[j] -= factor * right[k * n + j];
    }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      matrix[i * n + j] = (i == j ? 1.0 : 0.0) + matrix[i * n + j] * points.weights[j];
  return matrix;
}

QuadratureRule radial_points(double radius) {
  QuadratureRule rule;
  add_gauss_legendre(0.0, radius, 16 + static_cast<int>(std::ceil(3.0 * radius)), rule);
  return rule;
}

/// The ball. p(k) = int_0^a phi(t) cos(k t) dt is the transform of the pressure, and
///   phi(t) = (depth - t^2/R)/pi + (2/pi) int_0^a phi(s) int_0^inf (1 - Z(k)) cos(k t) cos(k s) dk ds,
/// phi(a) = 0 gives the depth, and the force is 2 pi int_0^a phi dt. All over E* and H.
LayerPress press_ball(double radius, double poisson, LayerBase base) {
  const QuadratureRule points = radial_points(radius), wave = waves(radius);
  const std::size_t n = points.nodes.size(), m = wave.nodes.size();
  std::vector<double> cosines(n * m), weighted(n * m), rim(n, 0.0);  // rim: the kernel between the rim and each node
  for (std::size_t k = 0; k < m; ++k) {
    const double weight = 2.0 / kPi * wave.weights[k] * (1.0 - layer_compliance(wave.nodes[k], poisson, base));
    const double at_rim = std::cos(wave.nodes[k] * radius);
    for (std::size_t i = 0; i < n; ++i) {
      cosines[k * n + i] = std::cos(wave.nodes[k] * points.nodes[i]);
      weighted[k * n + i] = weight * cosines[k * n + i];
      rim[i] += at_rim * weighted[k * n + i];
    }
  }
  std::vector<std::vector<double>> phi{std::vector<double>(n, 1.0 / kPi), std::vector<double>(n)};
  for (std::size_t i = 0; i < n; ++i) phi[1][i] = points.nodes[i] * points.nodes[i] / kPi;
  std::vector<double> matrix = equation_matrix(points, weighted, cosines);
  solve(matrix, phi);
  double at_rim[2] = {1.0 / kPi, radius * radius / kPi}, sums[2] = {0, 0};
  for (int side = 0; side < 2; ++side)
    for (std::size_t j = 0; j < n; ++j) {
      at_rim[side] += rim[j] * points.weights[j] * phi[side][j];
      sums[side] += points.weights[j] * phi[side][j];
    }
  const double depth = at_rim[1] / at_rim[0];
  return {depth, 2.0 * kPi * (depth * sums[0] - sums[1])};
}

/// The cylinder. p(k) = int_0^a chi(t) J0(k t) dt is the transform of the pressure, and
///   chi(t) = pi t/(2 R) + t int_0^a chi(s) int_0^inf (1 - Z(k)) k J0(k t) J0(k s) dk ds,
/// the force is int_0^a chi dt, and the depth 2/pi int_0^a chi(t) int_0^inf Z(k)/k J0(k t) dk dt, where
/// int_0^inf (1 - exp(-2 k))/k J0(k t) dk = asinh(2/t) is split off.
LayerPress press_cylinder(double radius, double poisson, LayerBase base) {
  const QuadratureRule points = radial_points(radius), wave = waves(radius);
  const std::size_t n = points.nodes.size(), m = wave.nodes.size();
  std::vector<double> compliance(n), bessel(n * m), left(n * m);
  for (std::size_t i = 0; i < n; ++i) compliance[i] = std::asinh(2.0 / points.nodes[i]);
  for (std::size_t k = 0; k < m; ++k) {
    const double xi = wave.nodes[k], missing = 1.0 - layer_compliance(xi, poisson, base);
    const double rest = wave.weights[k] * (std::exp(-2.0 * xi) - missing) / xi;
    for (std::size_t i = 0; i < n; ++i) {
      bessel[k * n + i] = ::j0(xi * points.nodes[i]);
      left[k * n + i] = wave.weights[k] * missing * xi * points.nodes[i] * bessel[k * n + i];
      compliance[i] += rest * bessel[k * n + i];
    }
  }
  std::vector<std::vector<double>> sides{std::vector<double>(n)};
  std::vector<double>& chi = sides.front();
  for (std::size_t i = 0; i < n; ++i) chi[i] = 0.5 * kPi * points.nodes[i];
  std::vector<double> matrix = equation_matrix(points, left, bessel);
  solve(matrix, sides);
  LayerPress press;
  for (std::size_t i = 0; i < n; ++i) {
    press.force += points.weights[i] * chi[i];
    press.depth += 2.0 / kPi * points.weights[i] * chi[i] * compliance[i];
  }
  return press;
}

}  // namespace

double layer_compliance(double xi, double poisson, LayerBase base) {
  if (base == LayerBase::sliding) {
    if (xi < 1e-4) return 0.5 * xi;
    return (std::cosh(2.0 * xi) - 1.0) / (std::sinh(2.0 * xi) + 2.0 * xi);
  }
  const double kappa = 3.0 - 4.0 * poisson;
  return (2.0 * kappa * std::sinh(2.0 * xi) - 4.0 * xi) /
         (2.0 * kappa * std::cosh(2.0 * xi) + 4.0 * xi * xi + 1.0 + kappa * kappa);
}

LayerPress press_layer(double radius, double poisson, LayerBase base, PressedBody body) {
  return body == PressedBody::ball ? press_ball(radius, poisson, base) : press_cylinder(radius, poisson, base);
}

double overlap_radius(const LayerPress& press) {
  return std::sqrt(2.0 * press.depth);
}

double matching_modulus(const LayerPress& press, PressedBody body) {
  // The pad's force is modulus/H times the overlap: pi R depth^2 of a ball, 4/3 sqrt(2 R) depth^1.5 of a cylinder.
  const double overlap = body == PressedBody::ball ? kPi * press.depth * press.depth
                                                   : 4.0 / 3.0 * std::sqrt(2.0) * std::pow(press.depth, 1.5);
  return press.force / overlap;
}

LayerPress press_with_overlap(double radius, double poisson, LayerBase base, PressedBody body) {
  // The overlap grows with the contact. Of a ball, their ratio is from 1/sqrt(2) (thin and incompressible, Johnson
  // 1985) to sqrt(2) (thick, Hertz); a thick layer under a cylinder has a depth that grows with the thickness.
  double low = std::log(body == PressedBody::ball ? 0.65 * radius : 0.2 * radius), high = std::log(1.8 * radius);
  double f_low = std::log(overlap_radius(press_layer(std::exp(low), poisson, base, body)) / radius);
  double f_high = std::log(overlap_radius(press_layer(std::exp(high), poisson, base, body)) / radius);
  for (int step = 0; step < 60; ++step) {
    const double middle = low - f_low * (high - low) / (f_high - f_low);
    const LayerPress press = press_layer(std::exp(middle), poisson, base, body);
    const double f = std::log(overlap_radius(press) / radius);
    if (std::abs(f) < 1e-8 || step == 59) return press;
    // Regula falsi; the side that is kept is halved (Dowell and Jarratt 1971).
    if (f < 0) {
      low = middle, f_low = f, f_high *= 0.5;
    } else {
      high = middle, f_high = f, f_low *= 0.5;
    }
  }
  return {};
}

namespace {

/// Ratio of neighbouring radii while the end of a range is searched.
constexpr double kRadiusStep = 1.2;
/// Halvings of an interval: of a range to 1e-4 of its end.
constexpr int kHalvings = 11;

/// Modulus at a radius over the thickness, over E.
double relative_modulus(double radius, double poisson, LayerBase base, PressedBody body) {
  return matching_modulus(press_with_overlap(radius, poisson, base, body), body) / (1.0 - poisson * poisson);
}

/// Returns the last radius, going by `step` from one where the modulus holds, at which it still holds.
double end_of_range(const ElasticLayer& layer, PressedBody body, double modulus, double from, double step) {
  const auto holds = [&](double radius) {
    const double right = layer.youngs * relative_modulus(radius, layer.poisson, layer.base, body);
    return std::abs(modulus / right - 1.0) <= kModulusTolerance;
  };
  double inside = from, outside = from;
  while (true) {
    outside = inside * step;
    if (outside < kSmallestRadius || outside > kLargestRadius) return step < 1 ? kSmallestRadius : kLargestRadius;
    if (!holds(outside)) break;
    inside = outside;
  }
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = std::sqrt(inside * outside);
    (holds(middle) ? inside : outside) = middle;
  }
  return inside;
}

std::optional<PadModulus::Range> range_of(const ElasticLayer& layer, PressedBody body, double modulus, double from) {
  const double right = layer.youngs * relative_modulus(from, layer.poisson, layer.base, body);
  if (std::abs(modulus / right - 1.0) > kModulusTolerance) return std::nullopt;
  const double h = layer.thickness;
  return PadModulus::Range{h * end_of_range(layer, body, modulus, from, 1.0 / kRadiusStep),
                           h * end_of_range(layer, body, modulus, from, kRadiusStep)};
}

/// Returns the Poisson's ratio from which on a thin layer's modulus is too large at a radius over the thickness.
std::optional<double> poisson_limit(LayerBase base, PressedBody body, double radius) {
  const auto is_too_large = [&](double poisson) {
    const double thin = thin_layer_modulus({1.0, poisson, 1.0, base});
    return thin > (1.0 + kModulusTolerance) * relative_modulus(radius, poisson, base, body);
  };
  double right = 0.0, wrong = 0.4999;
  if (!is_too_large(wrong)) return std::nullopt;
  if (is_too_large(right)) return 0.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (right + wrong);
    (is_too_large(middle) ? wrong : right) = middle;
  }
  return wrong;
}

}  // namespace

void check_layer(const ElasticLayer& layer) {
  const auto refuse = [](const char* field, double value, const char* rule) {
    throw Error("", field, fmt::format("must be {}, is {}", rule, value));
  };
  // Negated comparisons also refuse values that are no numbers.
  if (!(layer.youngs > 0.0 && std::isfinite(layer.youngs))) refuse("youngs", layer.youngs, "greater than 0 Pa");
  if (!(layer.thickness > 0.0 && std::isfinite(layer.thickness)))
    refuse("thickness", layer.thickness, "greater than 0 m");
  if (layer.youngs > kMaxModulus) refuse("youngs", layer.youngs, "at most 1e15 Pa");
  if (layer.thickness > kFarthest) refuse("thickness", layer.thickness, "at most 1e6 m");
  if (!(layer.poisson >= 0.0 && layer.poisson < 0.5))
    refuse("poisson", layer.poisson, "at least 0 and less than 0.5 (rubber: 0.49 to 0.4999)");
}

double thin_layer_modulus(const ElasticLayer& layer) {
  const double nu = layer.poisson;
  if (layer.base == LayerBase::sliding) return layer.youngs / (1.0 - nu * nu);
  return layer.youngs * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
}

double modulus_at_contact(const ElasticLayer& layer, double contact_radius, PressedBody body) {
  check_layer(layer);
  const double radius = contact_radius / layer.thickness;
  if (!(radius >= kSmallestRadius && radius <= kLargestRadius))
    throw Error("", "contact_radius",
                fmt::format("must be from {} to {} m ({} to {} thicknesses), is {}", kSmallestRadius * layer.thickness,
                            kLargestRadius * layer.thickness, kSmallestRadius, kLargestRadius, contact_radius));
  return layer.youngs * relative_modulus(radius, layer.poisson, layer.base, body);
}

PadModulus pad_modulus(const ElasticLayer& layer, std::optional<double> contact_radius, PressedBody body) {
  check_layer(layer);
  PadModulus result;
  result.thin_layer = thin_layer_modulus(layer);
  result.modulus = contact_radius ? modulus_at_contact(layer, *contact_radius, body) : result.thin_layer;
  const double from = contact_radius ? *contact_radius / layer.thickness : kLargestRadius;
  result.holds = range_of(layer, body, result.modulus, from);
  for (const double radius : {0.5, 1.0, 2.0, 5.0}) {
    const double right = layer.youngs * relative_modulus(radius, layer.poisson, layer.base, body);
    result.errors.push_back({radius * layer.thickness, right, result.modulus / right - 1.0});
  }
  const double limit_at = contact_radius ? from : 2.0;
  result.poisson_limit = poisson_limit(layer.base, body, limit_at);
  result.poisson_limit_radius = limit_at * layer.thickness;
  return result;
}

}  // namespace taxel
