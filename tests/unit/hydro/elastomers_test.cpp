// Hardness to modulus, and the list of known elastomers.
#include "core/hydro/material/elastomers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "core/hydro/material/pad_modulus.h"
#include "fixtures/complaint.h"

namespace taxel::test {
namespace {

TEST(Hardness, EqualsTheFormulasOfItsPapers) {
  EXPECT_NEAR(youngs_from_shore_a(50).youngs, 1e6 * 0.0981 * (56 + 7.62336 * 50) / (0.137505 * 127), 1.0);
  EXPECT_NEAR(youngs_from_shore_a(50).youngs, 2.456e6, 0.001e6);
  // A ball of 2.38 mm diameter that the spring of 0.475 N pushes 1.778 mm deep.
  EXPECT_NEAR(youngs_from_shore_00(30).youngs, 0.5625 * 0.4754 / (0.0344964 * 7.49711e-5), 200.0);
}

TEST(Hardness, GrowsAndLiesInItsRange) {
  for (const auto estimate : {youngs_from_shore_a, youngs_from_shore_00}) {
    double last = 0;
    for (double s = 5; s <= 95; s += 5) {
      const YoungsEstimate one = estimate(s);
      EXPECT_GT(one.youngs, last) << s;
      EXPECT_LT(one.low, one.youngs) << s;
      EXPECT_GT(one.high, one.youngs) << s;
      EXPECT_FALSE(one.source.empty());
      last = one.youngs;
    }
  }
}

TEST(Hardness, NamesValuesOutsideOfItsScale) {
  EXPECT_EQ(complaint_of([] { youngs_from_shore_a(100); }), "shore_a: must be from 5 to 95, is 100");
  EXPECT_EQ(complaint_of([] { youngs_from_shore_00(-1); }), "shore_00: must be from 5 to 95, is -1");
}

TEST(Elastomers, HaveValidNumbersAndSources) {
  std::set<std::string> words;
  for (const Elastomer& one : elastomers()) {
    EXPECT_TRUE(words.insert(one.word).second) << one.word;
    check_layer({one.youngs, one.poisson, 1e-3, LayerBase::bonded});
    EXPECT_GE(one.poisson, 0.49) << one.word;
    EXPECT_GT(one.density, 900) << one.word;
    EXPECT_LT(one.density, 1300) << one.word;
    EXPECT_FALSE(one.source.empty()) << one.word;
    EXPECT_FALSE(one.unverified.empty()) << one.word;
    EXPECT_EQ(find_elastomer(one.word).title, one.title);
  }
}

// Two independent figures of one data sheet, the stress at 100 % strain and the hardness, give moduli that agree within
// a factor of 2.5: rubber is not linear, and conversions of hardness alone differ by 1.5.
TEST(Elastomers, HaveModuliThatAgreeWithTheirHardness) {
  for (const Elastomer& one : elastomers()) {
    if (!one.stress_100) continue;
    const double by_hardness =
        one.shore_a ? youngs_from_shore_a(*one.shore_a).youngs : youngs_from_shore_00(*one.shore_00).youngs;
    EXPECT_GT(by_hardness / one.youngs, 0.4) << one.word;
    EXPECT_LT(by_hardness / one.youngs, 2.5) << one.word;
  }
}

TEST(Elastomers, NameAllWordsForAnUnknownOne) {
  EXPECT_THAT(complaint_of([] { (void)find_elastomer("rubber"); }),
              testing::StartsWith("preset: rubber is unknown, there are ecoflex-00-10, "));
}

}  // namespace
}  // namespace taxel::test
