#include "core/document/batch/draws.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/rng.h"

namespace taxel {
namespace {

/// FNV-1a, 64 bit (Fowler, Noll, Vo): gives each parameter a stream of random numbers of its own.
std::uint64_t stream_of(std::string_view pointer) {
  constexpr std::uint64_t kBasis = 0xcbf29ce484222325, kPrime = 0x100000001b3;
  std::uint64_t hash = kBasis;
  for (const char c : pointer) hash = (hash ^ static_cast<unsigned char>(c)) * kPrime;
  return hash;
}

}  // namespace

void check_draw(const Draw& draw) {
  const auto [distribution, first, second] = draw;
  if (!std::isfinite(first) || !std::isfinite(second))
    throw Error(fmt::format("must be two finite numbers, are {} and {}", first, second));
  if (distribution == Distribution::normal) {
    if (!(second >= 0)) throw Error(fmt::format("the standard deviation must not be negative, is {}", second));
    return;
  }
  if (!(first <= second)) throw Error(fmt::format("the lower limit {} is above the upper limit {}", first, second));
  if (distribution == Distribution::log_uniform && !(first > 0))
    throw Error(fmt::format("the lower limit must be greater than 0, is {}", first));
}

double draw_number(const Draw& draw, std::uint64_t seed, std::string_view pointer) {
  const CounterRng rng(seed, stream_of(pointer));
  const auto [distribution, first, second] = draw;
  const double u = rng.uniform(0);
  switch (distribution) {
    case Distribution::uniform:
      return std::clamp((1 - u) * first + u * second, first, second);
    case Distribution::log_uniform:
      return std::clamp(std::exp((1 - u) * std::log(first) + u * std::log(second)), first, second);
    case Distribution::normal:
      break;
  }
  // Box and Muller (1958). The argument of the logarithm is in (0, 1].
  const double radius = std::sqrt(-2 * std::log(1 - u));
  return first + second * radius * std::cos(2 * std::numbers::pi * rng.uniform(1));
}

double value_of_range(double from, double to, std::size_t index, std::size_t count) {
  const double u = static_cast<double>(index) / static_cast<double>(count - 1);
  return (1 - u) * from + u * to;
}

}  // namespace taxel
