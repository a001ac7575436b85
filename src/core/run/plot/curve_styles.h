// The look of the curves of a chart: colours that people with any colour vision tell apart, and dashes.
#pragma once

#include <vector>

#include "core/base/page/chart.h"

namespace taxel {

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
