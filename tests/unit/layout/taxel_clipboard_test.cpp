// Taxels through the clipboard: pasting returns the copied taxels, and nonsense is reported.
#include "core/layout/file/layout_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/base/rng.h"
#include "fixtures/complaint.h"

namespace taxel {
namespace {

std::vector<Taxel> two() {
  return {{7, "left \"1\"", dvec3(1e-9, -0.0, 0.1 + 0.2), dvec3(0, 1, 0), 0.006, {}},
          {2, "", dvec3(0.1), dvec3(1e20, 0, 0), 5e-324, {{dvec3(1, 2, 3), dvec3(0, 0, 1), 0.5}, {}}}};
}

std::string refusal_of(const std::string& text) {
  return test::complaint_of([&] { parse_taxels(text); });
}

TEST(TaxelClipboard, KeepsTaxelsInARoundTrip) {
  EXPECT_EQ(parse_taxels(taxels_to_json(two())), two());
  EXPECT_EQ(taxels_to_json(parse_taxels(taxels_to_json(two()))), taxels_to_json(two()));
}

TEST(TaxelClipboard, AcceptsPartsOfFiles) {
  Layout layout;
  layout.mesh.file = "m.obj";
  layout.taxels = two();
  EXPECT_EQ(parse_taxels(layout_to_json(layout)), two());
  const std::string one = R"({"center": [1, 2, 3], "normal": [0, 0, 1], "radius": 0.006, "note": 1})";
  EXPECT_EQ(parse_taxels(" \n" + one), (std::vector<Taxel>{{0, "", {1, 2, 3}, {0, 0, 1}, 0.006, {}}}));
  EXPECT_EQ(parse_taxels("[" + one + "," + one + "]")[1].id, 1);
}

TEST(TaxelClipboard, NamesNonsense) {
  const std::string expected = "taxels as JSON: copied ones, a layout, an array of taxels, or one taxel";
  EXPECT_EQ(refusal_of(""), "clipboard: is empty; needed are " + expected);
  EXPECT_EQ(refusal_of("Dear Sir or Madam,"), "clipboard: holds no " + expected);
  EXPECT_EQ(refusal_of("{}"), "clipboard: holds no " + expected);
  EXPECT_EQ(refusal_of("[]"), "clipboard: holds no taxel");
  EXPECT_EQ(refusal_of("{\"taxels\": []}"), "clipboard: holds no taxel");
  EXPECT_EQ(refusal_of("[1]"), "clipboard: /0: must be an object, is 1");
  EXPECT_EQ(refusal_of("{\"taxels\": 3}"), "clipboard: /taxels: must be an array, is 3");
  EXPECT_EQ(refusal_of("{\"format\": \"x\", \"taxels\": []}"),
            "clipboard: /format: must be \"taxels\" or \"taxel-layout\", is \"x\"");
  EXPECT_EQ(refusal_of("{\"version\": 2, \"taxels\": []}"),
            "clipboard: /version: must be 1, the version that this program reads, is 2");
  EXPECT_EQ(refusal_of(R"([{"center": [0, 0], "normal": [0, 0, 1], "radius": 1}])"),
            "clipboard: /0/center: must be an array of 3 numbers, is [0,0]");
  EXPECT_EQ(refusal_of(R"({"center": [0, 0, 0], "radius": 1})"), "clipboard: /normal: is missing");
  EXPECT_EQ(refusal_of("{\"taxels\": ["), "clipboard: line 1, column 13: is not JSON: ends too early");
  EXPECT_EQ(refusal_of(std::string(100000, '[')), "clipboard: is nested deeper than 64 levels");
}

TEST(TaxelClipboard, ReportsMuchNonsenseBriefly) {
  const std::string huge(300'000, '7'), umlauts = [] {
    std::string text;
    for (int i = 0; i < 100'000; ++i) text += "\u00fc";
    return text;
  }();
  for (const std::string& text : {"[" + huge + "]", "[\"" + umlauts + "\"]", "[\"" + umlauts, "{" + huge,
                                  "{\"" + umlauts + "\": 1, \"" + umlauts + "\": 2}"}) {
    const std::string said = refusal_of(text);
    EXPECT_NE(said, "accepted");
    EXPECT_LT(said.size(), 400U);
    EXPECT_EQ(std::count(said.begin(), said.end(), '\xc3'), std::count(said.begin(), said.end(), '\xbc'))
        << "no half characters: " << said;
  }
}

TEST(TaxelClipboard, SurvivesAnyPastedText) {
  const std::string text = taxels_to_json(two());
  const CounterRng rng(4);
  int refused = 0;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    std::string wrong = text;
    for (std::uint64_t k = 0; k < 1 + rng.bits(8 * i) % 3; ++k)
      wrong[rng.bits(8 * i + 2 * k + 1) % wrong.size()] = static_cast<char>(rng.bits(8 * i + 2 * k + 2));
    refused += refusal_of(wrong) != "accepted";
  }
  EXPECT_GT(refused, 1000);
}

TEST(TaxelClipboard, NamesTheValueThatCannotBeWritten) {
  std::vector<Taxel> taxels = two();
  taxels[1].radius = std::numeric_limits<double>::infinity();
  EXPECT_EQ(test::complaint_of([&] { taxels_to_json(taxels); }),
            "/taxels/1/radius: must be finite to be written, is inf");
}

}  // namespace
}  // namespace taxel
