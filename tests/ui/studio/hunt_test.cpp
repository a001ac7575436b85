// The hunt of the user guide, as its pictures are taken: an artifact that is found by "jumps while the force stays",
// explained, and gone with more samples.
#include <gtest/gtest.h>

#include <sstream>

#include "script_lines.h"

namespace taxel::test {
namespace {

TEST(Hunt, TheArtifactIsFoundExplainedAndCured) {
  const StudioProgram studio;
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"]["file"] = kMeshFile;
  layout["sampling"]["density"] = 2.5e5;
  layout["sampling"]["weights"] = "equal";
  layout["material"]["field"] = "star";
  write_text(studio.folder() / "coarse.taxels.json", layout.dump());
  Lines script;
  std::istringstream guide(file_text(TAXEL_SOURCE_DIR "/scripts/pictures/hunt.jsonl"));
  for (std::string line; std::getline(guide, line);) {
    script.push_back(line);
    if (line.find("hunt_explained") != std::string::npos) script.push_back(dump("explained.json"));
  }
  script.push_back(dump("cured.json"));
  studio.play(script, {"coarse.taxels.json"});

  const Json explained = studio.state("explained.json"), cured = studio.state("cured.json");
  EXPECT_NE(explained["messages"][0]["text"].get<std::string>().find("while the force stayed"), std::string::npos);
  const Json& verdict = explained["explain"]["verdict"];
  EXPECT_EQ(verdict["cause"], "sampling_noise") << verdict;
  EXPECT_GT(std::abs(verdict["noise"].get<double>()), 10 * std::abs(verdict["contact"].get<double>()));
  EXPECT_GE(cured["simulation"]["time"], 2.3);
  EXPECT_EQ(cured["messages"].size(), explained["messages"].size()) << "it did not pause again";
}

}  // namespace
}  // namespace taxel::test
