// Finds pairs of curves that coincide, such as those of two mirrored taxels, and the order in which they are drawn.
#pragma once

#include <span>
#include <vector>

namespace taxel {

/// Largest distance between two curves that are drawn as a pair, as a fraction of the follower's peak. Below, the
/// dashes of one are hard to tell from the line of the other.
inline constexpr double kPairDistance = 0.25;

/// Returns for each curve the earlier curve that it follows, or -1 if it follows none. A pair has two curves. A curve
/// follows the nearest of the earlier curves that are in no pair yet, if the largest difference between the two is
/// below kPairDistance times the peak of the later one. `twins` has for each curve the only other curve that may be in
/// its pair, or -1; without it any may be. All curves have the same number of rows.
std::vector<int> find_leaders(const std::vector<std::span<const double>>& curves, std::span<const int> twins = {});

}  // namespace taxel
