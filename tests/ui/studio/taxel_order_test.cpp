// Orders of taxels, compared with a direct definition.
#include "app/studio/nouns/table/table_rows.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace taxel::ui {
namespace {

Layout numbered(int count) {
  Layout layout;
  for (int i = 0; i < count; ++i) {
    layout.taxels.emplace_back();
    layout.taxels.back().id = i;
  }
  return layout;
}
using Ids = std::vector<int>;

TEST(TaxelOrder, MovesRunsByOnePlaceUpToTheEnds) {
  const Layout layout = numbered(6);
  EXPECT_EQ(moved_by_one(layout, {3}, true), (Ids{0, 1, 3, 2, 4, 5}));
  EXPECT_EQ(moved_by_one(layout, {3, 2}, true), (Ids{0, 2, 3, 1, 4, 5}));
  EXPECT_EQ(moved_by_one(layout, {1, 4}, false), (Ids{0, 2, 1, 3, 5, 4}));
  EXPECT_EQ(moved_by_one(layout, {0, 1, 3}, true), (Ids{0, 1, 3, 2, 4, 5}));
  EXPECT_EQ(moved_by_one(layout, {5}, false), (Ids{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(moved_by_one(layout, {}, true), (Ids{0, 1, 2, 3, 4, 5}));
}

TEST(TaxelOrder, MovesDraggedRowsTogetherToTheDropPosition) {
  const Layout layout = numbered(6);
  EXPECT_EQ(moved_to(layout, {4}, 1), (Ids{0, 4, 1, 2, 3, 5}));
  EXPECT_EQ(moved_to(layout, {1}, 4), (Ids{0, 2, 3, 4, 1, 5}));
  EXPECT_EQ(moved_to(layout, {5, 3}, 0), (Ids{3, 5, 0, 1, 2, 4}));
  EXPECT_EQ(moved_to(layout, {0, 2}, 5), (Ids{1, 3, 4, 5, 0, 2}));
  EXPECT_EQ(moved_to(layout, {2, 3}, 3), (Ids{0, 1, 2, 3, 4, 5})) << "onto itself";
  EXPECT_EQ(moved_to(layout, {2}, 77), (Ids{0, 1, 2, 3, 4, 5}));
  for (int target = 0; target < 6; ++target) {
    Ids ids = moved_to(layout, {1, 4}, target);
    std::sort(ids.begin(), ids.end());
    EXPECT_EQ(ids, (Ids{0, 1, 2, 3, 4, 5})) << "each once";
  }
}

TEST(TaxelOrder, SortsRowsStablyAndFiltersIgnoringCase) {
  Layout layout = numbered(4);
  const double radii[] = {2, 1, 2, 1};
  const char* names[] = {"Tip", "pad", "pad tip", "side"};
  for (std::size_t i = 0; i < 4; ++i) {
    layout.taxels[i].radius = radii[i];
    layout.taxels[i].name = names[i];
  }
  LayoutProblems problems;
  problems.list = {{"", "/taxels/3/normal", Severity::warning, "normal_points_inward", "points Inward", ""}};
  problems.of_taxel[3] = {0};
  TableState table;
  EXPECT_EQ(table_rows(table, layout, problems, {}), (Ids{0, 1, 2, 3}));
  table.sorted = TableColumn::radius;
  EXPECT_EQ(table_rows(table, layout, problems, {}), (Ids{1, 3, 0, 2}));
  table.descending = true;
  EXPECT_EQ(table_rows(table, layout, problems, {}), (Ids{0, 2, 1, 3}));
  table.sorted.reset();
  table.filter = "tip";
  EXPECT_EQ(table_rows(table, layout, problems, {}), (Ids{0, 2}));
  table.filter = "inward";
  EXPECT_EQ(table_rows(table, layout, problems, {}), (Ids{3}));
  table.filter.clear();
  const std::vector<int> samples = {5, 9, 7, 1};
  table.sorted = TableColumn::samples;
  EXPECT_EQ(table_rows(table, layout, problems, {nullptr, &samples}), (Ids{1, 2, 0, 3}));
}

}  // namespace
}  // namespace taxel::ui
