// Colours of receptive fields: neighbours differ, and a colour is used again far away.
#include "core/layout/field/overlap.h"

#include <gtest/gtest.h>

#include <limits>

namespace taxel {
namespace {

constexpr int kColors = 24;

/// Returns taxels in a square grid with this pitch, row by row.
Layout grid_layout(int side, double pitch, double radius) {
  Layout layout;
  for (int i = 0; i < side * side; ++i) {
    Taxel taxel;
    taxel.id = i;
    taxel.center = pitch * dvec3(i % side, i / side, 0);
    taxel.radius = radius;
    layout.taxels.push_back(taxel);
  }
  return layout;
}

/// Returns the number of pairs of taxels whose fields meet and that have the same colour.
int conflicts(const Layout& layout, const std::vector<int>& color_of) {
  int count = 0;
  for (std::size_t a = 0; a < layout.taxels.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const Taxel &x = layout.taxels[a], &y = layout.taxels[b];
      count += color_of[a] == color_of[b] && glm::distance(x.center, y.center) < x.radius + y.radius ? 1 : 0;
    }
  }
  return count;
}

TEST(FieldColoring, GivesDistinctColoursUpToPaletteSize) {
  const std::vector<int> color_of = color_fields(grid_layout(4, 0.001, 0.1), kColors);
  for (int i = 0; i < 16; ++i) EXPECT_EQ(color_of[static_cast<std::size_t>(i)], i);
}

TEST(FieldColoring, GivesNeighboursDifferentColours) {
  for (const double radius : {0.0021, 0.003, 0.0042}) {  // 4, 8 and 12 neighbours or more at a pitch of 4 mm
    // With 24 taxels in a row, a palette in its order would repeat directly above a taxel.
    for (const int side : {6, 12, 24, 25, 40}) {
      const Layout layout = grid_layout(side, 0.004, radius);
      const std::vector<int> color_of = color_fields(layout, kColors);
      EXPECT_EQ(conflicts(layout, color_of), 0) << side << " " << radius;
      EXPECT_TRUE(std::all_of(color_of.begin(), color_of.end(), [](int c) { return c >= 0 && c < kColors; }));
    }
  }
}

TEST(FieldColoring, ChangesNoOtherTaxelIfOneIsAdded) {
  Layout layout = grid_layout(20, 0.004, 0.003);
  const std::vector<int> before = color_fields(layout, kColors);
  layout.taxels.push_back(layout.taxels[111]);
  layout.taxels.back().center.x += 0.001;
  std::vector<int> after = color_fields(layout, kColors);
  EXPECT_EQ(conflicts(layout, after), 0);
  after.pop_back();
  EXPECT_EQ(before, after);
}

TEST(FieldColoring, RepeatsAColourFarAwayIfAllFieldsMeet) {
  const Layout layout = grid_layout(12, 0.001, 0.1);  // 144 taxels, each a neighbour of all others
  const std::vector<int> color_of = color_fields(layout, kColors);
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < color_of.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (color_of[a] != color_of[b]) continue;
      nearest = std::min(nearest, glm::distance(layout.taxels[a].center, layout.taxels[b].center));
    }
  }
  EXPECT_GT(nearest, 0.0019) << "never next to each other, nor across a corner";
}

TEST(FieldColoring, ConsidersTheReachOfSubtaxels) {
  Layout layout = grid_layout(1, 1, 0.001);
  layout.taxels.resize(25, layout.taxels[0]);
  for (std::size_t i = 0; i < 25; ++i) layout.taxels[i].center = dvec3(static_cast<double>(i), 0, 0);
  EXPECT_EQ(color_fields(layout, kColors)[24], 0);
  layout.taxels[0].subtaxels = {{{23.999, 0, 0}, {0, 0, 1}, 0.01}};
  EXPECT_NE(color_fields(layout, kColors)[24], 0);
}

}  // namespace
}  // namespace taxel
