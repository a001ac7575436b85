#include "ui/scene/color_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace taxel::ui {
namespace {

// The eight colours of Okabe and Ito, then more colours that also differ for people with deuteranopia or protanopia.
constexpr std::array<unsigned, 24> kTaxelPalette{0xE69F00, 0x56B4E9, 0x009E73, 0xF0E442, 0x0072B2, 0xD55E00,
                                                 0xCC79A7, 0x6611FF, 0xAAEE99, 0x5577FF, 0xBB1133, 0xCCDDCC,
                                                 0x55EEFF, 0x665566, 0xBBAA55, 0x1155BB, 0x7799FF, 0xFF5577,
                                                 0xDDDD66, 0x4444DD, 0xBB2211, 0x337744, 0x33BBCC, 0x33CC99};

glm::vec3 as_vec3(const Rgb8& color) {
  return glm::vec3(color.r, color.g, color.b) / 255.0f;
}

}  // namespace

glm::vec3 ColorMap::at(double t) const {
  const double x = 255.0 * (t > 0 ? std::min(t, 1.0) : 0.0);  // NaN becomes 0
  const auto i = std::min<std::size_t>(static_cast<std::size_t>(x), 254);
  return glm::mix(as_vec3(table[i]), as_vec3(table[i + 1]), static_cast<float>(x - static_cast<double>(i)));
}

glm::vec3 rejection_color(Rejection reason) {
  switch (reason) {
    case Rejection::sliver:
      return glm::vec3(1.0f, 0.25f, 0.85f);
    case Rejection::touching:
      return glm::vec3(1.0f, 0.5f, 0.1f);
    case Rejection::back_face:
      return glm::vec3(0.55f, 0.55f, 1.0f);
    default:
      return glm::vec3(0.95f, 0.2f, 0.2f);
  }
}

glm::vec3 taxel_color(int number) {
  const unsigned rgb = kTaxelPalette[static_cast<unsigned>(number) % kTaxelPalette.size()];
  return glm::vec3((rgb >> 16) & 255, (rgb >> 8) & 255, rgb & 255) / 255.0f;
}

std::uint32_t pack(const glm::vec4& rgba) {
  std::uint32_t out = 0;
  for (int i = 0; i < 4; ++i) {
    const float level = std::round(255.0f * std::clamp(rgba[i], 0.0f, 1.0f));
    out |= static_cast<std::uint32_t>(level) << (8 * i);
  }
  return out;
}

}  // namespace taxel::ui
