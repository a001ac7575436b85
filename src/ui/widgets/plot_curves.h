// Curves of plots: colours that stand out from their background, dashes of equal length on the screen, and clicks.
#pragma once

#include <imgui.h>
#include <glm/glm.hpp>

#include "core/base/page/curve.h"

namespace taxel::ui {

/// Opacity of curves that step back behind others.
inline constexpr float kDimmedAlpha = 0.22f;

/// Returns the contrast of two sRGB colours, 1 to 21: (L1 + 0.05) / (L2 + 0.05) with the relative luminances L1 >= L2
/// of WCAG 2.1.
[[nodiscard]] double curve_contrast(const glm::vec3& a, const glm::vec3& b);

/// Returns the colour of a taxel's curve on a background: taxel_color(), or the nearest colour on the way to black or
/// to white whose contrast is at least 3 (WCAG 2.1, criterion 1.4.11).
[[nodiscard]] glm::vec3 curve_color_on(int number, const glm::vec3& background);

/// Returns the colour of a taxel's curve on the background of plots in a theme.
[[nodiscard]] ImVec4 curve_color(int number, bool dark);

/// Lengths of a dash and of the gap after it [pixels].
struct DashLengths {
  double dash = 6, gap = 4;
  double start = 0;  ///< place in the pattern at which the curve begins [pixels]
};

/// Returns the dashes of a curve in the units of the curve, with a point of NaN after each dash. Dashes and gaps
/// continue around the corners of the curve. `x_scale` and `y_scale` are the pixels per unit of x and y.
CurvePoints dashes_of(const CurvePoints& curve, double x_scale, double y_scale, const DashLengths& lengths);

/// Returns true if the user clicks within the axes of the plot that is being drawn. ImPlot::IsPlotHovered cannot be
/// used, because it is false while the button is down.
bool plot_clicked();

}  // namespace taxel::ui
