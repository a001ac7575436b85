// Colours and spacing of the interface: flat and calm, dark or light; and the contrast of colours as people see them.
#pragma once

#include <imgui.h>
#include <glm/glm.hpp>

#include "core/base/error.h"

namespace taxel::ui {

/// Colours with a meaning, for the drawings of panels.
struct Palette {
  ImVec4 background, panel, raised, field, line;  ///< from the back to the front
  ImVec4 text, dim, accent;
  ImVec4 run, pause;                                ///< colours of the Run button
  ImVec4 error, warning, note;                      ///< colours of messages
  ImVec4 layout_mode, simulate_mode, analyse_mode;  ///< border of the view in each mode
  ImVec4 path;                                      ///< path of the finger, and cursor of the plot
};
const Palette& palette(bool dark);

/// Sets ImGui's and ImPlot's styles. `scale` multiplies both text and spacing.
void apply_theme(bool dark, float scale);

/// Returns the colour of text on a fill: black or white.
ImVec4 text_on(const ImVec4& fill);
ImU32 to_u32(const ImVec4& color, float alpha = 1.0f);
const ImVec4& severity_color(const Palette& colors, Severity severity);

/// Height of the small text of captions and axes, relative to the normal one.
inline constexpr float kSmallText = 0.87f;
/// Height of normal text at scale 1 [pixels].
inline constexpr float kTextHeight = 15.0f;

/// Kinds of sight. The two kinds of colour blindness follow Machado, Oliveira and Fernandes (2009) at severity 1.
enum class Sight { usual, protanopia, deuteranopia };

/// Least contrast of text, and of graphics that carry a meaning, with their background (WCAG 2.2, 1.4.3 and 1.4.11).
inline constexpr double kTextContrast = 4.5, kGraphicsContrast = 3;

/// Returns a colour as a person with this sight sees it. Both colours are sRGB.
[[nodiscard]] glm::vec3 as_seen(const glm::vec3& srgb, Sight sight);

/// Returns the contrast ratio of two sRGB colours, 1 to 21 (WCAG 2.2).
[[nodiscard]] double contrast(const glm::vec3& a, const glm::vec3& b);

/// Returns the smallest contrast ratio of two sRGB colours over all kinds of sight.
[[nodiscard]] double least_contrast(const glm::vec3& a, const glm::vec3& b);

/// Returns whether graphics of a colour need an outline to be seen on a background.
[[nodiscard]] inline bool needs_outline(const glm::vec3& color, const glm::vec3& background) {
  return least_contrast(color, background) < kGraphicsContrast;
}

/// Returns the colour nearest to `color`, on the way to black or white, whose contrast with a background is at least
/// `least` with every kind of sight. Returns black or white if no other colour on that way is enough.
[[nodiscard]] glm::vec3 with_contrast(const glm::vec3& color, const glm::vec3& background, double least);

/// Returns black or white, the one with more contrast: text on any background has a contrast of at least 4.5.
[[nodiscard]] glm::vec3 ink_on(const glm::vec3& background);

}  // namespace taxel::ui
