// The choices of a user that replace parts of a readout.
#include "core/layout/user_choices.h"

#include <gtest/gtest.h>

namespace taxel {
namespace {

TEST(ReadoutChoice, KeepsTheRestOfTheReadout) {
  Readout exact;
  exact.method = ReadingMethod::exact;
  EXPECT_TRUE(ReadoutChoice{}.is_empty());
  EXPECT_EQ(ReadoutChoice{}.applied_to(exact), exact);
  EXPECT_EQ(ReadoutChoice{.aggregate = Aggregate::mean}.applied_to(exact).method, ReadingMethod::exact);
  EXPECT_EQ(ReadoutChoice{.method = ReadingMethod::samples}.applied_to(exact), Readout{});
}

TEST(ReadoutChoice, ReadsAnAggregateWithoutIntegralBySamples) {
  Readout exact;
  exact.method = ReadingMethod::exact;
  for (const AggregateRow& row : kAggregates) {
    const Readout chosen = ReadoutChoice{.aggregate = row.value}.applied_to(exact);
    EXPECT_EQ(chosen.aggregate, row.value);
    EXPECT_EQ(chosen.method == ReadingMethod::exact, has_exact_method(row.value));
    // A method that was chosen is kept, so that the check of the layout can refuse it.
    const ReadoutChoice both{.aggregate = row.value, .method = ReadingMethod::exact};
    EXPECT_EQ(both.applied_to(exact).method, ReadingMethod::exact);
  }
}

}  // namespace
}  // namespace taxel
