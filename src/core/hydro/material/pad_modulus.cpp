#include "core/hydro/material/pad_modulus.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/limits.h"

namespace taxel {
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
