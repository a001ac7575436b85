#include "ui/curve_colors.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/scene/color_map.h"
#include "ui/theme.h"

namespace taxel::ui {

namespace {

double relative_luminance(const glm::vec3& color) {
  const auto linear = [](float part) {
    const auto c = static_cast<double>(part);
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.x) + 0.7152 * linear(color.y) + 0.0722 * linear(color.z);
}

}  // namespace

double curve_contrast(const glm::vec3& a, const glm::vec3& b) {
  const double first = relative_luminance(a) + 0.05, second = relative_luminance(b) + 0.05;
  return std::max(first, second) / std::min(first, second);
}

glm::vec3 curve_color_on(int number, const glm::vec3& background) {
  constexpr int kSteps = 64;
  constexpr double kLeast = 3;
  const glm::vec3 color = taxel_color(number), black(0), white(1);
  const glm::vec3 end = curve_contrast(black, background) > curve_contrast(white, background) ? black : white;
  for (int i = 0; i < kSteps; ++i) {
    const glm::vec3 mixed = glm::mix(color, end, static_cast<float>(i) / kSteps);
    if (curve_contrast(mixed, background) >= kLeast) return mixed;
  }
  return end;
}

ImVec4 curve_color(int number, bool dark) {
  constexpr std::size_t kColors = 24;  // number of colours of taxel_color(), which then repeat
  const auto colors_of = [](bool is_dark) {
    std::array<ImVec4, kColors> colors;
    const ImVec4& back = palette(is_dark).background;
    for (std::size_t i = 0; i < kColors; ++i) {
      const glm::vec3 c = curve_color_on(static_cast<int>(i), {back.x, back.y, back.z});
      colors[i] = {c.x, c.y, c.z, 1};
    }
    return colors;
  };
  static const std::array<ImVec4, kColors> over_light = colors_of(false), over_dark = colors_of(true);
  const auto i = static_cast<std::size_t>(std::max(0, number)) % kColors;
  return dark ? over_dark[i] : over_light[i];
}

}  // namespace taxel::ui
