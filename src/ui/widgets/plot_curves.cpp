#include "ui/widgets/plot_curves.h"

#include <imgui.h>
#include <implot.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

CurvePoints dashes_of(const CurvePoints& curve, double x_scale, double y_scale, const DashLengths& lengths) {
  constexpr double kMaxLength = 1e5;   // longest dashed piece of a curve [pixels]; longer pieces leave the plot
  constexpr double kLeastStep = 0.05;  // smallest step of the loop [pixels], so that rounding cannot stop it
  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
  CurvePoints dashes;
  const auto add = [&](double x, double y) { dashes.x.push_back(x), dashes.y.push_back(y); };
  const double period = lengths.dash + lengths.gap;
  double drawn = std::fmod(lengths.start, period);  // length since the beginning of the last dash
  for (std::size_t i = 1; i < curve.x.size(); ++i) {
    const double dx = curve.x[i] - curve.x[i - 1], dy = curve.y[i] - curve.y[i - 1];
    const double length = std::hypot(x_scale * dx, y_scale * dy);
    if (!(length > 0) || length > kMaxLength) continue;
    for (double at = 0; at < length;) {
      const double phase = std::fmod(drawn + at, period);
      const bool is_dash = phase < lengths.dash;
      const double end = std::min(length, at + std::max(kLeastStep, (is_dash ? lengths.dash : period) - phase));
      if (is_dash) {
        if (dashes.x.empty() || std::isnan(dashes.x.back()))
          add(curve.x[i - 1] + at / length * dx, curve.y[i - 1] + at / length * dy);
        add(curve.x[i - 1] + end / length * dx, curve.y[i - 1] + end / length * dy);
      } else if (!dashes.x.empty() && !std::isnan(dashes.x.back())) {
        add(kGap, kGap);
      }
      at = end;
    }
    drawn = std::fmod(drawn + length, period);
  }
  return dashes;
}

bool plot_clicked() {
  const ImVec2 lo = ImPlot::GetPlotPos(), size = ImPlot::GetPlotSize(), at = ImGui::GetIO().MousePos;
  const bool inside = at.x >= lo.x && at.y >= lo.y && at.x < lo.x + size.x && at.y < lo.y + size.y;
  constexpr auto kHovered = ImGuiHoveredFlags_AllowWhenBlockedByActiveItem | ImGuiHoveredFlags_ChildWindows;
  return inside && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && ImGui::IsWindowHovered(kHovered);
}

}  // namespace taxel::ui
