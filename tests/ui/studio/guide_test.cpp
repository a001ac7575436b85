// Guides for users: the command palette, the user guide and the tour.
#include <gtest/gtest.h>

#include <set>

#include "app/studio/frame/feature.h"
#include "app/studio/nouns/inspector/inspector_state.h"
#include "script_lines.h"

namespace taxel::test {
namespace {

bool shows(const Json& state, const std::string& panel, const std::string& label) {
  for (const Json& widget : state["widgets"])
    if (widget["panel"].get<std::string>().starts_with(panel) && widget["label"] == label) return true;
  return false;
}

const std::string kPalette = key("k", kCtrl);

TEST(Palette, RunsTheTypedCommand) {
  const StudioProgram studio;
  studio.play({kIdle, kPalette, kIdle, dump("open.json"), R"({"do": "screenshot", "file": "palette.png"})",
               type("cover"), kIdle, key("Enter"), kIdle, dump("coverage.json"),
               // Down selects the next result: "Select all", "Select none", ...
               kPalette, kIdle, type("layout mode"), kIdle, key("Enter"), kIdle, kPalette, kIdle, type("select"), kIdle,
               key("Down"), kIdle, key("Down"), kIdle, dump("found.json"), key("Enter"), kIdle, dump("chosen.json"),
               kPalette, kIdle, type("select all"), kIdle, key("Enter"), kIdle, dump("all.json"), kPalette, kIdle,
               type("coverage"), kIdle, key("Esc"), kIdle, dump("escaped.json")},
              {kLayoutFile});
  EXPECT_EQ(studio.state("open.json")["overlays"]["coverage"], false);
  EXPECT_EQ(studio.state("coverage.json")["overlays"]["coverage"], true);
  EXPECT_TRUE(shows(studio.state("open.json"), "", "Command"));
  EXPECT_FALSE(shows(studio.state("coverage.json"), "", "Command")) << "it closes";
  EXPECT_TRUE(shows(studio.state("found.json"), "", "Select in a lasso"));
  EXPECT_EQ(studio.state("chosen.json")["mode"], "layout");
  EXPECT_EQ(studio.state("all.json")["selection"]["taxels"].size(), 12U);
  EXPECT_EQ(studio.state("escaped.json")["overlays"], studio.state("all.json")["overlays"])
      << "the typed command is not run";
  EXPECT_EQ(studio.state("escaped.json")["selection"], studio.state("all.json")["selection"]) << "Esc was its own";
}

TEST(Palette, DoesNotRunADisabledCommand) {
  const StudioProgram studio;
  studio.play(
      {kLayoutMode,  kIdle, dump("before.json"),  kPalette,   kIdle,        type("delete"),  kIdle,
       key("Enter"), kIdle, dump("refused.json"), key("Esc"), kIdle,        click(taxel(3)), kIdle,
       kPalette,     kIdle, type("delete"),       kIdle,      key("Enter"), kIdle,           dump("deleted.json")},
      {kLayoutFile});
  EXPECT_EQ(studio.state("refused.json")["document"], studio.state("before.json")["document"]);
  EXPECT_TRUE(shows(studio.state("refused.json"), "", "Command")) << "it stays open";
  EXPECT_EQ(studio.state("deleted.json")["document"]["layout"]["taxels"].size(), 11U);
}

/// Opens the palette, types a text and presses Enter.
Lines found_by(const std::string& text) {
  return {kPalette, kIdle, type(text), kIdle, key("Enter"), kIdle, kIdle, kIdle, kIdle, kIdle, kIdle};
}

TEST(Palette, ShowsAFieldAndGivesItTheKeyboard) {
  const StudioProgram studio;
  // From SIMULATE, with a closed section: the mode changes, the section opens, the typed number goes into the field.
  studio.play(joined({{kIdle, kLayoutMode, kIdle, press("Inspector/Sampling"), kIdle, key("2", kCtrl), kIdle},
                      found_by("density"),
                      {dump("shown.json"), type("3"), key("Enter"), kIdle, dump("typed.json")},
                      found_by("friction"),
                      {type("0.7"), key("Enter"), kIdle, dump("friction.json")}}),
              {kLayoutFile});
  const Json shown = studio.state("shown.json");
  EXPECT_EQ(shown["mode"], "layout");
  EXPECT_EQ(shown["keyboard"], "Inspector");
  EXPECT_TRUE(shows(shown, "Inspector", "Density (1/mm\u00b2)")) << "scrolled into view";
  EXPECT_EQ(studio.state("typed.json")["document"]["layout"]["sampling"]["density"], 3e6);
  EXPECT_EQ(studio.state("friction.json")["document"]["layout"]["material"]["friction"], 0.7);
}

/// Returns the label of a field without the axis of a vector.
std::string without_axis(std::string label) {
  for (const char* axis : {" X", " Y", " Z"})
    if (label.ends_with(axis)) label.resize(label.size() - 2);
  return label;
}

TEST(Palette, KnowsTheFieldsThatTheInspectorDraws) {
  const StudioProgram studio;
  std::vector<std::string> tall = tall_window(studio);
  tall[3] = "1500x3400";  // with all fields of the calibration
  studio.play({kIdle, kLayoutMode, kIdle, click(taxel(3)), kIdle, press("From a data sheet"), kIdle,
               press("Calibrated"), kIdle, dump("fields.json")},
              tall);
  std::set<std::string> drawn, fields, known;
  const Json state = studio.state("fields.json");
  for (const Json& widget : state["widgets"]) {
    if (widget["panel"] != "Inspector") continue;
    drawn.insert(without_axis(widget["label"]));
    if (widget["field"].get<bool>()) fields.insert(without_axis(widget["label"]));
  }
  for (const ui::PanelPart& part : ui::kInspector.parts()) {
    const std::string widget = part.widget.empty() ? part.label : part.widget;
    known.insert(widget);
    if (part.section == "Problems") continue;  // the layout has none
    if (part.mode == ui::kLayout && part.instead.empty()) {
      EXPECT_TRUE(drawn.contains(widget)) << widget << " is not drawn";
    } else if (!part.instead.empty() && part.mode == ui::kLayout) {
      EXPECT_TRUE(drawn.contains(part.instead)) << part.instead << " is not drawn";
    }
  }
  EXPECT_GE(fields.size(), 25U);
  for (const std::string& field : fields) EXPECT_TRUE(known.contains(field)) << field << " is not found";
}

TEST(Palette, OpensAClosedPanelAtItsButton) {
  const StudioProgram studio;
  studio.play(joined({{kIdle, key("Space"), kIdle, kIdle, key("Space"), kIdle},
                      found_by("run study"),
                      {dump("study.json")},
                      found_by("ecoflex 00-30"),
                      {dump("preset.json")},
                      found_by("kept steps"),
                      {dump("steps.json")}}),
              {kLayoutFile});
  EXPECT_TRUE(shows(studio.state("study.json"), "Study", "Run study"));
  EXPECT_EQ(studio.state("study.json")["keyboard"], "Study");
  EXPECT_TRUE(shows(studio.state("preset.json"), "Inspector", "Elastomer")) << "the data sheet is open";
  EXPECT_TRUE(shows(studio.state("steps.json"), "Timeline", "Kept steps")) << "the timeline is unfolded";
}

TEST(UserGuide, OpensAtTheHeadingOfThePaletteOrOfAPanel) {
  const StudioProgram studio;
  studio.play(joined({{kIdle, dump("before.json")},
                      found_by("set the material"),
                      {dump("heading.json"),
                       R"({"do": "screenshot", "file": "guide.png"})",
                       key("Esc"),
                       kIdle,
                       dump("closed.json"),
                       R"({"event": "mouse_move", "at": {"widget": "Pressure bars/Bars"}})",
                       kIdle,
                       key("Slash", kShift),
                       kIdle,
                       kIdle,
                       kIdle,
                       kIdle,
                       dump("bars.json"),
                       key("Esc"),
                       kIdle,
                       R"({"event": "mouse_move", "at": {"widget": "Inspector/?"}})",
                       kIdle,
                       press("Inspector/?"),
                       kIdle,
                       kIdle,
                       kIdle,
                       kIdle,
                       dump("button.json")}}),
              {kLayoutFile});
  EXPECT_EQ(studio.state("before.json")["guide"]["open"], false);
  EXPECT_EQ(studio.state("heading.json")["guide"], Json({{"open", true}, {"section", "Set the material"}}));
  EXPECT_EQ(studio.state("closed.json")["guide"]["open"], false);
  EXPECT_EQ(studio.state("bars.json")["guide"], Json({{"open", true}, {"section", "Look at one step"}}));
  EXPECT_EQ(studio.state("button.json")["guide"], Json({{"open", true}, {"section", "Author a layout"}}));
}

TEST(Tour, ShowsFiveStepsAndRecordsThatItWasSeen) {
  const StudioProgram studio;
  Lines script{kIdle};
  for (int step = 0; step < 5; ++step) {
    const std::string n = std::to_string(step);
    script.insert(script.end(), {dump(n + ".json"), R"({"do": "screenshot", "file": "tour)" + n + R"(.png"})",
                                 step % 2 == 0 ? key("Enter") : press(step < 4 ? "Tour/Next" : "Tour/Finish"), kIdle});
  }
  script.push_back(dump("over.json"));
  studio.play(script, {"--tour", "--state-dir", "state", kLayoutFile});
  for (int step = 0; step < 5; ++step) {
    const Json state = studio.state(std::to_string(step) + ".json");
    EXPECT_EQ(state["tour_step"], step);
    EXPECT_EQ(shows(state, "Tour", "Skip the tour"), step < 4) << step;
  }
  EXPECT_EQ(studio.state("over.json")["tour_step"], -1);
  const Json settings = Json::parse(file_text(studio.folder() / "state" / "settings.json"));
  EXPECT_EQ(settings["tour_seen"], true);
}

TEST(Tour, IsSkippedAndStartedAgain) {
  const StudioProgram studio;
  studio.play({kIdle, dump("begun.json"), press("Tour/Next"), kIdle, press("Tour/Back"), kIdle, dump("back.json"),
               press("Tour/Skip the tour"), kIdle, dump("skipped.json"), press("Help"), kIdle, press("Tour"), kIdle,
               dump("again.json"), key("Esc"), kIdle, dump("escaped.json")},
              {"--tour", kLayoutFile});
  EXPECT_EQ(studio.state("begun.json")["tour_step"], 0);
  EXPECT_EQ(studio.state("back.json")["tour_step"], 0);
  EXPECT_EQ(studio.state("skipped.json")["tour_step"], -1);
  EXPECT_EQ(studio.state("again.json")["tour_step"], 0);
  EXPECT_EQ(studio.state("escaped.json")["tour_step"], -1);
}

TEST(Tour, IsOnlyALineInAnEmptyWindowUntilItWasSeen) {
  const StudioProgram studio;
  const std::vector<std::string> first_start{"--live", "--empty", "--size", "800x600", "--state-dir", "state"};
  const std::string hint = "New here? Help > Tour shows the window in five steps.";
  studio.play({kIdle, dump("first.json"), press("Help"), kIdle, press("Tour"), kIdle, dump("tour.json")}, first_start);
  EXPECT_EQ(studio.state("first.json")["tour_step"], -1);
  EXPECT_TRUE(shows(studio.state("first.json"), "", hint));
  EXPECT_EQ(studio.state("tour.json")["tour_step"], 0);
  studio.play({kIdle, dump("second.json")}, first_start);
  EXPECT_EQ(studio.state("second.json")["tour_step"], -1);
  EXPECT_FALSE(shows(studio.state("second.json"), "", hint)) << "it was seen";
}

}  // namespace
}  // namespace taxel::test
