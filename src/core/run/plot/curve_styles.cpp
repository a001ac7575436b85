// Colours and dashes of curves, and pairs of curves that nearly coincide.
//
// Mirrored taxels often read the same, and one curve would hide the other. A curve follows the nearest earlier one that
// has no pair yet, if the largest difference of the two is below a quarter of its peak. The difference is first tested
// at the peak, where most pairs already differ enough, so few are compared row by row. A leader is a wide line and its
// follower a row of dashes over it, each in the gaps of the others. Where the layout is known, only twins across its
// mirror plane are pairs.
#include "core/run/plot/curve_styles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace taxel {
namespace {

/// Returns the largest difference between two curves, or `limit` if the difference reaches it.
double difference_below(std::span<const double> a, std::span<const double> b, double limit) {
  double largest = 0;
  for (std::size_t row = 0; row < a.size() && largest < limit; ++row)
    largest = std::max(largest, std::abs(a[row] - b[row]));
  return std::min(largest, limit);
}

}  // namespace

std::vector<int> find_leaders(const std::vector<std::span<const double>>& curves, std::span<const int> twins) {
  std::vector<int> leaders(curves.size(), -1);
  std::vector<bool> is_paired(curves.size(), false);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const std::span<const double> curve = curves[i];
    if (curve.empty()) continue;
    const auto peak_row = static_cast<std::size_t>(std::max_element(curve.begin(), curve.end()) - curve.begin());
    double nearest = kPairDistance * curve[peak_row];
    for (std::size_t j = 0; j < i; ++j) {
      if (is_paired[j] || (!twins.empty() && twins[i] != static_cast<int>(j))) continue;
      // Most pairs of curves already differ by `limit` at the peak of this curve.
      if (!(std::abs(curve[peak_row] - curves[j][peak_row]) < nearest)) continue;
      const double difference = difference_below(curve, curves[j], nearest);
      if (difference < nearest) nearest = difference, leaders[i] = static_cast<int>(j);
    }
    if (leaders[i] >= 0) is_paired[i] = is_paired[static_cast<std::size_t>(leaders[i])] = true;
  }
  return leaders;
}

namespace {

constexpr std::array<unsigned, 7> kCurveColors{0x0072B2, 0xD55E00, 0x009E73, 0xE69F00, 0xCC79A7, 0x56B4E9, 0x000000};

PageColor numbered_color(std::size_t number) {
  const unsigned rgb = kCurveColors[number % kCurveColors.size()];
  return {((rgb >> 16u) & 255u) / 255.0, ((rgb >> 8u) & 255u) / 255.0, (rgb & 255u) / 255.0};
}

}  // namespace

LineStyle numbered_style(std::size_t number) {
  static const std::array<std::vector<double>, 4> dashes{
      {{}, {5, 2.5}, {1.2, 1.8}, {6, 2, 1.2, 2}}};  // solid, dashed, dotted, both [points]
  return {numbered_color(number), 1.2, dashes[number / kCurveColors.size() % dashes.size()], 0};
}

std::vector<LineStyle> paired_styles(const std::vector<int>& leaders) {
  constexpr double kWide = 2.6, kNarrow = 1.4, kDash = 4;  // [points]
  constexpr double kShade = 0.3;                           // brightness of the first follower, of its leader's
  std::vector<std::size_t> followers(leaders.size(), 0), placed(leaders.size(), 0);
  for (const int leader : leaders)
    if (leader >= 0) ++followers[static_cast<std::size_t>(leader)];
  std::vector<LineStyle> styles(leaders.size());
  std::size_t number = 0;
  if (static_cast<std::size_t>(std::count(leaders.begin(), leaders.end(), -1)) > kCurveColors.size()) {
    for (LineStyle& style : styles) style = numbered_style(number++);
    return styles;
  }
  for (std::size_t i = 0; i < leaders.size(); ++i) {
    LineStyle& style = styles[i];
    if (leaders[i] < 0) {
      style = numbered_style(number++);
      if (followers[i] > 0) style.width = kWide, style.dashes.clear();
      continue;
    }
    const auto leader = static_cast<std::size_t>(leaders[i]);
    const auto of = static_cast<double>(followers[leader] + 1), place = static_cast<double>(++placed[leader]);
    style = placed[leader] == 1 ? styles[leader] : numbered_style(number++);
    if (placed[leader] == 1)
      for (double& part : style.color) part *= kShade;
    style.width = kNarrow;
    style.dashes = {kDash, kDash * (of - 1)};
    style.dash_start = kDash * (of - place);
  }
  return styles;
}

std::vector<std::size_t> paired_order(const std::vector<int>& leaders) {
  std::vector<std::size_t> order(leaders.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_partition(order.begin(), order.end(), [&](std::size_t i) { return leaders[i] < 0; });
  return order;
}

}  // namespace taxel
