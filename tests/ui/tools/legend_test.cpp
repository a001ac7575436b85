// Numbers of the legend, and numbers with their units.
#include <gtest/gtest.h>

#include "ui/widgets/format.h"
#include "ui/widgets/pressure_legend.h"

namespace taxel::ui {
namespace {

TEST(PressureLegend, ShowsTheRangeInKilopascals) {
  PressureRange range;
  range.lo = 0, range.hi = 8000;
  EXPECT_EQ(legend_texts(range, 4), (std::vector<std::string>{"0", "2", "4", "6", "8"}));
  range.lo = 1000, range.hi = 2500;
  EXPECT_EQ(legend_texts(range, 2), (std::vector<std::string>{"1", "1.75", "2.5"}));
  range.lo = 0, range.hi = 0.5;
  EXPECT_EQ(legend_texts(range, 1), (std::vector<std::string>{"0", "0.0005"}));
}

TEST(PressureLegend, ShowsReadingsInTheirUnit) {
  EXPECT_EQ(legend_texts({0, 0.8}, 2, shown_unit(Aggregate::force)), (std::vector<std::string>{"0", "0.4", "0.8"}));
}

}  // namespace
}  // namespace taxel::ui
