// Arithmetic with units: values, precedence, kinds of units, and the positions of errors.
#include "core/base/text/expression.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/math.h"
#include "core/base/rng.h"
#include "fixtures/complaint.h"

namespace taxel {
namespace {

std::string complaint(const std::string& text, const std::string& unit = "mm") {
  return test::complaint_of([&] { evaluate(text, unit); });
}

TEST(Expression, ReadsPlainNumbersInTheUnitOfTheField) {
  EXPECT_EQ(evaluate("6", "mm"), 6);
  EXPECT_EQ(evaluate(" -6.25e-1 ", "deg"), -0.625);
  EXPECT_EQ(evaluate(".5"), 0.5);
  EXPECT_EQ(evaluate("5."), 5);
  EXPECT_EQ(evaluate("2*3.5", "mm"), 7);
}

TEST(Expression, FollowsTheUsualPrecedenceOfOperators) {
  EXPECT_EQ(evaluate("1 + 2 * 3"), 7);
  EXPECT_EQ(evaluate("(1 + 2) * 3"), 9);
  EXPECT_EQ(evaluate("7 - 2 - 1"), 4);
  EXPECT_EQ(evaluate("8 / 2 / 2"), 2);
  EXPECT_EQ(evaluate("2 ^ 3 ^ 2"), 512);
  EXPECT_EQ(evaluate("-2 ^ 2"), -4);
  EXPECT_EQ(evaluate("2 ^ -1"), 0.5);
  EXPECT_EQ(evaluate("--2 - -3 + +1"), 6);
  EXPECT_EQ(evaluate("2 * -3"), -6);
  EXPECT_EQ(evaluate("sqrt(16) + abs(-2)"), 6);
  EXPECT_EQ(evaluate("pi"), kPi);
}

TEST(Expression, ConvertsUnitsOfLength) {
  EXPECT_EQ(evaluate("2*3.5 mm", "mm"), 7);
  EXPECT_EQ(evaluate("2 cm", "mm"), 20);
  EXPECT_EQ(evaluate("0.002 m", "mm"), 2);
  EXPECT_EQ(evaluate("1 in", "mm"), 25.4);
  EXPECT_EQ(evaluate("500 um + 1 mm", "mm"), 1.5);
  EXPECT_EQ(evaluate("1 mm + 500 \u00b5m", "mm"), 1.5);
  EXPECT_EQ(evaluate("(1 + 2) mm", "um"), 3000);
  EXPECT_EQ(evaluate("mm", "um"), 1000);
  EXPECT_EQ(evaluate("sqrt(16 mm^2)", "mm"), 4);
  EXPECT_EQ(evaluate("6 mm / 3", "m"), 0.002);
}

TEST(Expression, ConvertsOtherUnits) {
  EXPECT_EQ(evaluate("45 deg", "deg"), 45);
  EXPECT_EQ(evaluate("45\u00b0", "deg"), 45);
  EXPECT_NEAR(evaluate("(pi/4) rad", "deg"), 45, 1e-13);
  EXPECT_NEAR(evaluate("90 deg", "rad"), kPi / 2, 1e-15);
  EXPECT_NEAR(evaluate("asin(1)", "deg"), 90, 1e-13);
  EXPECT_NEAR(evaluate("6 mm * sin(30 deg)", "mm"), 3, 1e-14);
  EXPECT_EQ(evaluate("50 kPa", "Pa"), 50000);
  EXPECT_EQ(evaluate("2 N / 4 mm^2", "kPa"), 500);
  EXPECT_EQ(evaluate("2 N/4 mm\u00b2", "kPa"), 500);
  EXPECT_EQ(evaluate("10 / mm^2", "1/m^2"), 1e7);
  EXPECT_EQ(evaluate("10 mm^-2", "1/m\u00b2"), 1e7);
  EXPECT_EQ(evaluate("20 g", "kg"), 0.020);
  EXPECT_EQ(evaluate("10 mm/s", "m/s"), 0.01);
  EXPECT_EQ(evaluate("1 / 2 ms", "Hz"), 500);
  EXPECT_EQ(evaluate("3 Pa s", "Pa s"), 3);
  EXPECT_EQ(evaluate("4 mm^2", "mm^2"), 4) << "the power is the unit's";
}

TEST(Expression, LosesNoDigitsInDecimalUnits) {
  const CounterRng rng(3);
  for (std::uint64_t i = 0; i < 10000; ++i) {
    const double v = (rng.uniform(i) - 0.5) * std::pow(10.0, static_cast<double>(i % 9));
    for (const char* unit : {"mm", "um", "deg", "kPa", "g"})
      ASSERT_EQ(evaluate(fmt::format("{} {}", v, unit), unit), v) << unit;
    ASSERT_EQ(evaluate(fmt::format("{} mm + {} mm", v, 2 * v), "mm"), v + 2 * v);
  }
  EXPECT_EQ(evaluate("0.1 mm + 0.2 mm", "mm"), 0.1 + 0.2);
}

TEST(Expression, NamesTheMistakeAndItsPlace) {
  EXPECT_EQ(complaint(""), "character 1: a number is expected");
  EXPECT_EQ(complaint("  "), "character 3: a number is expected");
  EXPECT_EQ(complaint("2 *"), "character 4: a number is expected, the text ends");
  EXPECT_EQ(complaint("2 * / 3"), "character 5: a number is expected, not '/'");
  EXPECT_EQ(complaint("(1 + 2"), "character 7: a ')' is missing");
  EXPECT_EQ(complaint("(1 ; 2)"), "character 4: a ')' is expected, not ';'");
  EXPECT_EQ(complaint("1)"), "character 2: ')' is not expected here");
  EXPECT_EQ(complaint("3,5"), "character 2: the decimal sign is '.', not ','");
  EXPECT_EQ(complaint("1.2.3"), "character 4: a number has one decimal point");
  EXPECT_EQ(complaint("1 2"), "character 3: '2' is not expected here");
  EXPECT_EQ(complaint("6 mmm"), "character 3: there is no unit 'mmm'");
  EXPECT_EQ(complaint("\u00b0\u00b0 + 6 foo", "deg"), "character 1: there is no unit '\u00b0\u00b0'");
  EXPECT_EQ(complaint("1\u00b0 + 6 foo", "deg"), "character 8: there is no unit 'foo'");
  EXPECT_EQ(complaint("foo(3)"), "character 1: there is no function 'foo'");
  EXPECT_EQ(complaint("1 / 0"), "character 3: division by zero");
  EXPECT_EQ(complaint("1/(1 mm - 1 mm)"), "character 2: division by zero");
  EXPECT_EQ(complaint("6 deg"), "character 1: this is an angle, a length is needed");
  EXPECT_EQ(complaint("6 mm * 2 mm"), "character 1: this is an area, a length is needed");
  EXPECT_EQ(complaint("6 mm^3 s"), "character 1: this is in m^3 s, a length is needed");
  EXPECT_EQ(complaint("6 mm", ""), "character 1: this is a length, a number without a unit is needed");
  EXPECT_EQ(complaint("6 mm + 2"), "character 6: a length and a number without a unit cannot be added");
  EXPECT_EQ(complaint("sin(30)"), "character 4: sin is of an angle, not of a number without a unit");
  EXPECT_EQ(complaint("asin(2)"), "character 5: asin of 2 is not a number");
  EXPECT_EQ(complaint("sqrt(-1)"), "character 5: a negative number has no root");
  EXPECT_EQ(complaint("sqrt(2 mm)"), "character 5: the root of a length has no unit");
  EXPECT_EQ(complaint("(-8) ^ 0.5"), "character 6: a negative number has no such power");
  EXPECT_EQ(complaint("(2 mm) ^ 0.5"), "character 8: the power of a unit is a whole number, at most 9");
  EXPECT_EQ(complaint("2 ^ (1 mm)"), "character 3: an exponent is a number without a unit");
  EXPECT_EQ(complaint("1e999"), "character 1: is a number that is too large or too small");
  EXPECT_EQ(complaint("1e300 * 1e300"), "character 1: the result is too large");
  EXPECT_EQ(complaint("inf"), "character 1: there is no unit 'inf'");
  EXPECT_EQ(complaint(std::string(100000, '(')), "character 101: is nested deeper than 100 levels");
  std::string powers = "1";
  for (int i = 0; i < 100000; ++i) powers += "^1";
  EXPECT_EQ(complaint(powers), "character 200: is nested deeper than 100 levels");
  EXPECT_EQ(evaluate(std::string(100000, '-') + "1"), 1);
}

/// Any typed text of digits, signs and other characters gives a value or an Error.
TEST(Expression, SurvivesAnyTypedText) {
  const std::string keys = "0123456789.+-*/^() emndgkPasqrtipu\xC2\xB0\xB2,;\"\n";
  const CounterRng rng(9);
  int accepted = 0;
  for (std::uint64_t i = 0; i < 200'000; ++i) {
    std::string text;
    for (std::uint64_t k = 0; k < rng.bits(32 * i) % 12; ++k) text += keys[rng.bits(32 * i + k + 1) % keys.size()];
    accepted += complaint(text) == "accepted";
  }
  EXPECT_GT(accepted, 1000);
}

}  // namespace
}  // namespace taxel
