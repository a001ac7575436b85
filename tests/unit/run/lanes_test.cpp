// The largest change of a reading in recorded steps.
#include "core/run/history/lanes.h"

#include <gtest/gtest.h>

namespace taxel {
namespace {

/// Returns rows with these readings.
HistoryLanes lanes_with(const std::vector<std::vector<double>>& rows) {
  HistoryLanes lanes;
  lanes.reading_count = rows.empty() ? 0 : rows.front().size();
  for (std::size_t r = 0; r < rows.size(); ++r) {
    lanes.steps.push_back({r, 0, 0, 0});
    lanes.readings.append(rows[r].data(), rows[r].data() + rows[r].size());
  }
  return lanes;
}

TEST(LargestChange, IsTheFirstOneOfLargestMagnitude) {
  const std::optional<ReadingChange> found = largest_change(lanes_with({{0, 10}, {5, 10}, {5, 3}, {12, 3}, {11, 4}}));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->row, 2U);
  EXPECT_EQ(found->reading, 1U);
  EXPECT_EQ(found->before, 10);
  EXPECT_EQ(found->after, 3);
}

TEST(LargestChange, IsEmptyWithoutAChange) {
  EXPECT_FALSE(largest_change(lanes_with({})));
  EXPECT_FALSE(largest_change(lanes_with({{1, 2}})));
  EXPECT_FALSE(largest_change(lanes_with({{1, 2}, {1, 2}})));
}

}  // namespace
}  // namespace taxel
