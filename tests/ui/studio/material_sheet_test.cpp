// The data sheet in the inspector's material: fields, advice, and Apply as one edit.
#include <gtest/gtest.h>

#include <algorithm>

#include "script_lines.h"

namespace taxel::test {
namespace {

TEST(DataSheet, BecomesTheModulusOfThePadByOneEdit) {
  const StudioProgram studio;
  const auto pick = [](const std::string& label) { return Lines{press(label), kIdle}; };
  const auto fill = [](const std::string& field, const std::string& text) {
    return Lines{press("Inspector/" + field), kIdle, type(text), kIdle, key("Enter"), kIdle};
  };
  const auto shows = [](const Json& state, const std::string& label) {
    const Json& widgets = state["widgets"];
    return std::any_of(widgets.begin(), widgets.end(), [&](const Json& w) { return w["label"] == label; });
  };
  studio.play(joined({{kIdle, kLayoutMode, kIdle, dump("before.json")},
                      pick("From a data sheet"),
                      {dump("wide.json")},
                      pick("Inspector/Elastomer"),
                      pick("ecoflex-00-30"),
                      fill("Layer (mm)", "2"),
                      fill("Contact radius (mm)", "3"),
                      {dump("sheet.json"), R"({"do": "screenshot", "file": "sheet.png"})"},
                      pick("Apply data sheet"),
                      {dump("applied.json"), key("z", kCtrl), kIdle, dump("undone.json")},
                      fill("Poisson's ratio", "0.5"),
                      {dump("bad.json")}}),
              tall_window(studio));
  const Json wide = studio.state("wide.json"), sheet = studio.state("sheet.json"),
             applied = studio.state("applied.json");
  EXPECT_TRUE(shows(wide, "Modulus of the pad: 1027 kPa"));
  EXPECT_TRUE(shows(sheet, "Modulus of the pad: 353.8 kPa"));
  EXPECT_TRUE(shows(sheet, "Force within 10 % for contact radii from 2.51 to 3.51 mm"));
  EXPECT_EQ(sheet["document"], studio.state("before.json")["document"]) << "nothing changes before Apply";
  const Json material = applied["document"]["layout"]["material"];
  EXPECT_EQ(applied["history"]["depth"], 1);
  EXPECT_NEAR(material["modulus"].get<double>(), 353833, 1);
  EXPECT_EQ(material["thickness"], 2e-3);
  EXPECT_EQ(studio.state("undone.json")["document"], studio.state("before.json")["document"]);
  const Json bad = studio.state("bad.json");
  EXPECT_TRUE(shows(bad, "poisson: must be at least 0 and less than 0.5 (rubber: 0.49 to 0.4999), is 0.5"));
  EXPECT_FALSE(shows(bad, "Modulus of the pad: 353.8 kPa"));
}

}  // namespace
}  // namespace taxel::test
