// The look of the curves of a chart: colours that people with any colour vision tell apart, and dashes. Curves that
// coincide, such as those of two mirrored taxels, are found and drawn as pairs.
#pragma once

#include <span>
#include <vector>

#include "core/base/page/chart.h"

namespace taxel {

/// Largest distance between two curves that are drawn as a pair, as a fraction of the follower's peak. Below, the
/// dashes of one are hard to tell from the line of the other.
inline constexpr double kPairDistance = 0.25;

/// Returns for each curve the earlier curve that it follows, or -1 if it follows none. A pair has two curves. A curve
/// follows the nearest of the earlier curves that are in no pair yet, if the largest difference between the two is
/// below kPairDistance times the peak of the later one. `twins` has for each curve the only other curve that may be in
/// its pair, or -1; without it any may be. All curves have the same number of rows.
std::vector<int> find_leaders(const std::vector<std::span<const double>>& curves, std::span<const int> twins = {});

/// Number of different looks of numbered_style(): colours times dashes.
inline constexpr std::size_t kCurveStyles = 28;

/// Returns the look of a curve by its number: seven colours of Okabe and Ito (2008), those that are visible on white,
/// then the same with other dashes. After kCurveStyles they repeat.
[[nodiscard]] LineStyle numbered_style(std::size_t number);

/// Returns the looks of curves, of which some follow others (`leaders`, see find_leaders()). A leader is a wide solid
/// line; its followers are dashes over it, each in the gaps of the others: the first one in a dark shade of the
/// leader's colour. If there are more leaders than colours, all curves are numbered.
[[nodiscard]] std::vector<LineStyle> paired_styles(const std::vector<int>& leaders);

/// Returns the order in which such curves are drawn: leaders first.
[[nodiscard]] std::vector<std::size_t> paired_order(const std::vector<int>& leaders);

}  // namespace taxel
