// Contrast of the colours of both themes, as all people see them.
#include "ui/theme.h"

#include <gtest/gtest.h>

#include <array>

#include "ui/scene/color_map.h"

namespace taxel::ui {
namespace {

constexpr std::array kThemes{true, false};

glm::vec3 as_vec3(const ImVec4& color) {
  return {color.x, color.y, color.z};
}

TEST(Contrast, FollowsTheDefinitionOfTheGuidelines) {
  const glm::vec3 black(0), white(1), grey(0x77 / 255.0f);
  EXPECT_NEAR(contrast(black, white), 21, 1e-9);
  EXPECT_NEAR(contrast(white, black), 21, 1e-9);
  EXPECT_NEAR(contrast(grey, grey), 1, 1e-9);
  EXPECT_NEAR(contrast(grey, white), 4.48, 0.005) << "the known value of #777777 on white";
}

TEST(Contrast, ChangesWithColourBlindnessButNotForGrey) {
  const glm::vec3 red(0.8f, 0.1f, 0.1f), grey(0.4f);
  for (const Sight sight : {Sight::protanopia, Sight::deuteranopia})
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(as_seen(grey, sight)[i], grey[i], 2e-3) << i;
  EXPECT_LT(as_seen(red, Sight::protanopia).r, 0.5f * red.r) << "red is dark without long cones";
  EXPECT_LT(least_contrast(red, glm::vec3(0)), 0.7 * contrast(red, glm::vec3(0)));
}

TEST(Theme, GivesTextAContrastOfFourAndAHalf) {
  for (const bool dark : kThemes) {
    const Palette& p = palette(dark);
    for (const ImVec4& text : {p.text, p.dim, p.error, p.warning, p.note, p.accent}) {
      for (const ImVec4& back : {p.background, p.panel, p.raised, p.field})
        EXPECT_GE(least_contrast(as_vec3(text), as_vec3(back)), kTextContrast)
            << (dark ? "dark" : "light") << " #" << std::hex << to_u32(text) << " on #" << to_u32(back);
    }
    for (const ImVec4& fill : {p.accent, p.run, p.pause, p.error, p.layout_mode, p.simulate_mode})
      EXPECT_GE(least_contrast(as_vec3(text_on(fill)), as_vec3(fill)), kTextContrast)
          << (dark ? "dark" : "light") << " text on #" << std::hex << to_u32(fill);
  }
}

TEST(Theme, GivesGraphicsAContrastOfThree) {
  for (const bool dark : kThemes) {
    const Palette& p = palette(dark);
    for (const ImVec4& mark : {p.accent, p.run, p.error, p.path, p.layout_mode, p.simulate_mode, p.dim}) {
      for (const ImVec4& back : {p.background, p.panel, p.field})
        EXPECT_GE(least_contrast(as_vec3(mark), as_vec3(back)), kGraphicsContrast)
            << (dark ? "dark" : "light") << " #" << std::hex << to_u32(mark) << " on #" << to_u32(back);
    }
  }
}

/// A bar has the colour of its taxel, or an outline in the dim colour, on the field behind it.
TEST(Theme, SetsTheBarOfEachTaxelOffFromItsBackground) {
  int outlined = 0;
  for (const bool dark : kThemes) {
    const glm::vec3 back = as_vec3(palette(dark).field), outline = as_vec3(palette(dark).dim);
    EXPECT_GE(least_contrast(outline, back), kGraphicsContrast);
    for (int k = 0; k < 24; ++k) {
      const glm::vec3 color = taxel_color(k), shade = with_contrast(color, back, kGraphicsContrast);
      EXPECT_GE(least_contrast(shade, back), kGraphicsContrast) << "narrow bar " << k;
      if (needs_outline(color, back))
        ++outlined;
      else
        EXPECT_EQ(shade, color) << "a colour that is seen stays as it is";
    }
  }
  EXPECT_GT(outlined, 10) << "the check would be empty otherwise";
}

TEST(Theme, WritesOnAnyColourWithEnoughContrast) {
  for (int r = 0; r <= 8; ++r)
    for (int g = 0; g <= 8; ++g)
      for (int b = 0; b <= 8; ++b) {
        const glm::vec3 fill(r / 8.0f, g / 8.0f, b / 8.0f);
        EXPECT_GE(contrast(ink_on(fill), fill), kTextContrast) << r << ' ' << g << ' ' << b;
      }
}

}  // namespace
}  // namespace taxel::ui
