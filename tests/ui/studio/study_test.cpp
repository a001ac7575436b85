// Parameter studies in the window: run in a worker, shown side by side, and a click makes one the document's.
#include <gtest/gtest.h>

#include "script_lines.h"

namespace taxel::test {
namespace {

Lines entered(const std::string& field, const std::string& text) {
  return {press("Study/" + field), kIdle, key("a", kCtrl), type(text), key("Enter"), kIdle};
}

TEST(StudyPanel, RunsAreShownAndAClickLoadsOne) {
  const StudioProgram studio;
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"]["file"] = kMeshFile;
  layout["sampling"]["density"] = 1e5;
  write_text(studio.folder() / "coarse.taxels.json", layout.dump());
  studio.play(joined({{kIdle, key("Space"), press("Panels"), kIdle, press("Study panel"), kIdle},
                      entered("Vary from", "0.0005"), entered("Vary to", "0.001"), entered("Vary values", "2"),
                      {press("Study/Run study"), kIdle, kIdle, dump("run.json"),
                       R"({"do": "screenshot", "file": "study.png"})", press("Study/Run 1"), kIdle, key("Space"),
                       kIdle, dump("loaded.json")}}),
              tall_window(studio, "coarse.taxels.json"));
  const Json run = studio.state("run.json")["study"];
  ASSERT_EQ(run["runs"].size(), 2U);
  EXPECT_EQ(run["problem"], "");
  EXPECT_EQ(run["runs"][0]["values"], Json({0.0005}));
  EXPECT_EQ(run["runs"][1]["rows"], 241);
  EXPECT_GT(run["runs"][1]["largest"].get<double>(), run["runs"][0]["largest"].get<double>());
  const Json loaded = studio.state("loaded.json")["scenario"];
  EXPECT_EQ(loaded["edited"]["depth"], 0.001);
  EXPECT_EQ(loaded["running"], loaded["edited"]);
}

}  // namespace
}  // namespace taxel::test
