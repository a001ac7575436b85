// Colours of the curves of plots, which stand out from their background.
#pragma once

#include <imgui.h>

#include <glm/glm.hpp>

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

}  // namespace taxel::ui
