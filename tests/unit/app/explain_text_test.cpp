// The text of an explanation gives each number a label.
#include "app/cli/commands/explain_text.h"

#include <gtest/gtest.h>

namespace taxel::cli {
namespace {

TEST(ExplainText, NamesTheSamplesThatBeganAndCeasedToHit) {
  Explanation e;
  e.id = 7;
  e.time = 1.25;
  e.reading = 150;
  e.aggregate = Aggregate::weighted_mean;
  StepChange change;
  change.time_before = 1.24;
  change.reading = {100, 150};
  change.began = {3, 40}, change.ceased = {2, -5}, change.stayed = {11, 15};
  change.verdict.text = "A verdict.";
  change.verdict.change = 50, change.verdict.noise = 31, change.verdict.field = 12, change.verdict.contact = 7;
  change.verdict.limit = 10;
  e.change = change;
  const std::string text = explain_text(e);
  const auto has = [&](const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  };
  EXPECT_EQ(text.find("A verdict.\n"), 0U);
  has("change since 1.24 s: +50 Pa, of it samples +31, field +12, cone +0, mesh edges +0, contact +7; limit 10\n");
  has("    began to hit        3            +40\n");
  has("   ceased to hit        2             -5\n");
  has("          stayed       11            +15\n");
  has("taxel 7 at 1.25 s, weighted_mean [Pa]\n");
  has("reading 150.000, before 100.000\n");
}

}  // namespace
}  // namespace taxel::cli
