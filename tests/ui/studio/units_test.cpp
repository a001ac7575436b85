// Every field of a physical number shows its unit: in its label, in the field, or in the text next to it.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>

#include "script_lines.h"

namespace taxel::test {
namespace {

/// Fields of texts, and of numbers that have no unit: counts, ids, ratios and directions. A control of an actuator has
/// the unit that its scene gives it. The columns of tables have their units in their heads or in the tooltips of those.
const std::regex kWithoutUnit(
    "Filter .*|Name|Layout name|Object mesh|Unit of values|Chosen sensor|"
    "Taxel \\d+ (Name|r|x|y|z|nx|ny|nz)|(Time|X|Y|Z) \\d+|"
    "Id|Seed|Calibration seed|Density seed|Bristles|Friction|Poisson's ratio|Rows|Columns|Taxels|Count|Turns|Vary "
    "values.*|Kept steps|Header lines|(Pad|Distal|Normal) [XYZ]|Actuator .*|Bits|Gain|Threshold");

/// Returns the texts of a dump that are in the row of a widget: in it or at its left, in the same panel.
std::string row_text(const Json& state, const Json& widget) {
  const Json &texts = state["amount"]["texts"], &places = state["amount"]["places"], &field = widget["rect"];
  std::string row;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const Json& ink = places[i]["rect"];
    const double middle = 0.5 * (ink[1].get<double>() + ink[3].get<double>());
    const bool is_in_row = middle > field[1].get<double>() - 8 && middle < field[3].get<double>() + 8;
    if (places[i]["panel"] == widget["panel"] && is_in_row) row += " " + texts[i].get<std::string>();
  }
  return row;
}

bool has_unit(const std::string& text) {
  static const std::regex kUnit(
      "(^|[ (])(mm|g|kPa|Pa|MPa|N|s|ms|m|deg|pixels|fps|Hz|steps)([ )/\u00b2]|$)|\u00b0|%|1/mm");
  return std::regex_search(text, kUnit);
}

/// Returns the fields of numbers without a visible unit.
std::set<std::string> fields_without_unit(const Json& state, int& fields) {
  std::set<std::string> without;
  for (const Json& widget : state["widgets"]) {
    const std::string label = widget["label"];
    if (!widget["field"].get<bool>() || std::regex_match(label, kWithoutUnit)) continue;
    ++fields;
    if (!has_unit(label) && !has_unit(row_text(state, widget)))
      without.insert(widget["panel"].get<std::string>() + "/" + label);
  }
  return without;
}

/// Plays lines in a window that is tall enough for all fields, and checks the fields of a dump after each step.
void expect_units(const std::vector<Lines>& steps, const std::string& file, int least_fields) {
  const StudioProgram studio;
  Lines lines{kIdle, key("Space"), kIdle};
  for (std::size_t i = 0; i < steps.size(); ++i)
    lines = joined({lines, steps[i], {kIdle, kIdle, dump(std::to_string(i) + ".json")}});
  studio.play(lines, tall_window(studio, file));
  int fields = 0;
  for (std::size_t i = 0; i < steps.size(); ++i)
    EXPECT_EQ(fields_without_unit(studio.state(std::to_string(i) + ".json"), fields), std::set<std::string>{}) << i;
  EXPECT_GE(fields, least_fields) << "the fields are found";
}

TEST(FieldUnits, AreShownInLayout) {
  std::vector<Lines> steps{{kLayoutMode}, {click(R"({"widget": "Taxel 3"})")}, {key("x")}};
  steps.push_back({key("Escape"), key("q")});
  steps.push_back({key("Escape"), key("Escape"), key("g", kCtrl)});
  for (const char* kind : {"Hexagonal", "Ring", "Helix", "Spiral", "Spread", "Table", "Image"})
    steps.push_back({press(std::string("Generate/") + kind)});
  expect_units(steps, kLayoutFile, 60);
}

TEST(FieldUnits, AreShownInScenariosAndStudies) {
  std::vector<Lines> steps{{}};
  for (const char* kind : {"press", "roll", "twist", "slide", "drop", "path", "sweep"})
    steps.push_back({press("Kind"), kIdle, press(kind)});
  steps.push_back({press("/Panels"), kIdle, press("Panels/Study")});
  expect_units(steps, kLayoutFile, 40);
}

TEST(FieldUnits, AreShownInAScene) {
  expect_units({{press("Controls tab")}}, TAXEL_SOURCE_DIR "/assets/scenes/hand_grasps_ball.xml", 5);
}

}  // namespace
}  // namespace taxel::test
