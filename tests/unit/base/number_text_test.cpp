// The two numbers of a change differ visibly. Lengths and areas have one unit and one spelling.
#include "core/base/text/message.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/rng.h"
#include "core/base/text/rounded.h"

namespace taxel {
namespace {

TEST(NumberPair, ShowsASmallChangeOfASmallNumber) {
  const NumberPair pair = number_pair(0.0868, 0.0912, 3);
  EXPECT_EQ(pair.first, "0.0868");
  EXPECT_EQ(pair.second, "0.0912");
  EXPECT_EQ(number_pair(0.09000, 0.09004, 3).second, "0.090040");
  EXPECT_EQ(number_pair(12345, 13000, 3).first, "12345");
  EXPECT_EQ(number_pair(0, 1.5, 3).first, "0.00");
  EXPECT_EQ(number_pair(0, 0, 3).second, "0");
  EXPECT_EQ(number_pair(2.5, 2.5, 3).first, number_pair(2.5, 2.5, 3).second);
  EXPECT_EQ(number_pair(2e-9, 3e-9, 3).first, "2.00e-09");
}

/// For any two numbers, the difference of the texts equals the difference of the numbers within a tenth.
TEST(NumberPair, KeepsTheDifferenceOfTheNumbers) {
  const CounterRng rng(3);
  for (std::uint64_t i = 0; i < 4000; i += 4) {
    const double first = std::pow(10.0, 12 * rng.uniform(i) - 6) * (rng.uniform(i + 1) < 0.5 ? -1 : 1);
    const double second = first * (1 + std::pow(10.0, -9 * rng.uniform(i + 2)));
    const NumberPair pair = number_pair(first, second, 3);
    ASSERT_NE(pair.first, pair.second);
    const double change = second - first, shown = std::stod(pair.second) - std::stod(pair.first);
    ASSERT_NEAR(shown, change, 0.1 * std::abs(change)) << pair.first << " " << pair.second;
  }
}

TEST(NumberPair, ShowsInfinityAndNan) {
  EXPECT_EQ(number_pair(NAN, 1, 3).first, "nan");
  EXPECT_EQ(number_pair(INFINITY, 1, 3).second, "1");
}

TEST(LengthText, IsInMillimetres) {
  EXPECT_EQ(in_mm(3e-5), "0.03 mm");
  EXPECT_EQ(in_mm2(2.634e-6), "2.63 mm\u00b2");
  EXPECT_EQ(place_in_mm({0.0015, -0.0, -0.02}), "(1.5, 0, -20) mm");
}

TEST(Rounded, HasNoExponentAndNoSignOfZero) {
  EXPECT_EQ(rounded(1.54e-14, 3, 6), "0");
  EXPECT_EQ(rounded(-4e-7, 3, 6), "0");
  EXPECT_EQ(rounded(-6e-7, 3, 6), "-0.000001");
  EXPECT_EQ(rounded(0.0300, 3, 6), "0.03");
  EXPECT_EQ(rounded(99.96, 3, 6), "100");
  EXPECT_EQ(rounded(123456, 3, 6), "123456");
  EXPECT_EQ(rounded(1e20, 3, 6), "100000000000000000000");
  EXPECT_EQ(rounded(12.3456, 4, 1), "12.3");
  EXPECT_EQ(rounded(-0.0, 4, 2), "0");
  EXPECT_EQ(rounded(NAN, 4, 2), "nan");
  EXPECT_EQ(rounded_change(0.12, 3, 4), "+0.12");
  EXPECT_EQ(rounded_change(-0.12, 3, 4), "-0.12");
  EXPECT_EQ(rounded_change(1e-9, 3, 4), "0");
  EXPECT_EQ(in_mm(1.54e-17), "0 mm");
  EXPECT_EQ(in_mm(3e-5), "0.03 mm");
  EXPECT_EQ(in_mm2(2.634e-6), "2.63 mm\u00b2");
  EXPECT_EQ(place_in_mm(dvec3(0.0015, -1e-12, -0.02)), "(1.5, 0, -20) mm");
}

}  // namespace
}  // namespace taxel
