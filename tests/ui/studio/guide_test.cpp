// Guides for users: the command palette and the tour.
#include <gtest/gtest.h>

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
  studio.play({kIdle, dump("script.json")}, {kLayoutFile});
  EXPECT_EQ(studio.state("script.json")["tour_step"], -1) << "scripts begin without it";
}

}  // namespace
}  // namespace taxel::test
