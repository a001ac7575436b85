// Contrast of colours as people see them, with usual sight and with two kinds of colour blindness.
#pragma once

#include <glm/glm.hpp>

namespace taxel::ui {

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
