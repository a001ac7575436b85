// Colour maps of pressures and the colours of taxels.
#include "ui/scene/color_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "ui/scene/passes/look.h"
#include "ui/scene/scene_renderer.h"

namespace taxel::ui {
namespace {

/// Returns the CIE L*a*b* values of linear sRGB (IEC 61966-2-1 primaries, D65).
glm::dvec3 lab(const glm::dvec3& linear) {
  const glm::dvec3 xyz(0.4124564 * linear.r + 0.3575761 * linear.g + 0.1804375 * linear.b,
                       0.2126729 * linear.r + 0.7151522 * linear.g + 0.0721750 * linear.b,
                       0.0193339 * linear.r + 0.1191920 * linear.g + 0.9503041 * linear.b);
  const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
  const double x = f(xyz.x / 0.95047), y = f(xyz.y), z = f(xyz.z / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

const ColorMap& kViridisMap = kColorMaps.front();

TEST(ColorMap, GivesEveryRowItsOwnWordAndLabel) {
  std::set<std::string_view> words, labels;
  for (const ColorMap& map : kColorMaps) {
    EXPECT_TRUE(words.insert(map.word).second) << map.word;
    EXPECT_TRUE(labels.insert(map.label).second) << map.label;
  }
}

TEST(ColorMap, SpreadsOverTheRangeOfPressures) {
  PressureRange range{100, 300};
  EXPECT_EQ(range.color(200), kViridisMap.at(0.5));
  EXPECT_EQ(range.color(1000), kViridisMap.at(1));
  range.hi = range.lo;
  EXPECT_EQ(range.color(200), kViridisMap.at(0));
}

TEST(ColorMap, InterpolatesTheTableOfViridis) {
  for (int i = 0; i < 256; ++i) {
    const glm::vec3 c = kViridisMap.at(i / 255.0);
    const glm::vec3 expected(kViridis[i].r, kViridis[i].g, kViridis[i].b);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(255 * c[k], expected[k], 1e-3);
  }
  EXPECT_EQ(kViridisMap.at(-1), kViridisMap.at(0));
  EXPECT_EQ(kViridisMap.at(2), kViridisMap.at(1));
  EXPECT_EQ(kViridisMap.at(std::numeric_limits<double>::quiet_NaN()), kViridisMap.at(0));
  const glm::vec3 middle = kViridisMap.at(100.5 / 255), a = kViridisMap.at(100.0 / 255),
                  b = kViridisMap.at(101.0 / 255);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(middle[k], 0.5f * (a[k] + b[k]), 1e-6);
}

TEST(ColorMap, GetsSteadilyLighterInViridis) {
  double last = -1;
  for (int i = 0; i < 256; ++i) {
    const double lightness = lab(linear_from_srgb(kViridisMap.at(i / 255.0))).x;
    EXPECT_GT(lightness, last - 0.15) << i;  // colours have 8 bits per channel
    last = lightness;
  }
  EXPECT_LT(lab(linear_from_srgb(kViridisMap.at(0))).x, 16);
  EXPECT_GT(lab(linear_from_srgb(kViridisMap.at(1))).x, 89);
}

TEST(ColorMap, GivesTaxelsColoursThatColourBlindPeopleDistinguish) {
  // Rows of the matrix of Machado, Oliveira and Fernandes 2009 at severity 1.
  const glm::dmat3 protan = glm::transpose(
      glm::dmat3(0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998));
  const glm::dmat3 deutan = glm::transpose(
      glm::dmat3(0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881));
  for (const glm::dmat3& eye : {glm::dmat3(1), protan, deutan}) {
    for (int i = 0; i < 24; ++i) {
      for (int j = 0; j < i; ++j) {
        const auto seen = [&](int k) {
          return lab(glm::clamp(eye * glm::dvec3(linear_from_srgb(taxel_color(k))), 0.0, 1.0));
        };
        EXPECT_GE(glm::length(seen(i) - seen(j)), 15) << i << " and " << j;
      }
    }
  }
  EXPECT_EQ(taxel_color(24), taxel_color(0));
}

}  // namespace
}  // namespace taxel::ui
