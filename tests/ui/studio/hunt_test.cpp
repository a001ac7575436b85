// The search for an artifact in the user guide, as in its images: found by "jumps while the force stays", explained,
// and removed with more samples.
#include <gtest/gtest.h>

#include <sstream>

#include "script_lines.h"

namespace taxel::test {
namespace {

struct Hunted {
  Json explained, cured;
};

/// A change of the guide's script: lines that contain `from` are replaced by `to`.
struct Change {
  std::string from, to;
};
/// Plays the script of the guide.
Hunted hunt(const std::string& scenario, const std::vector<Change>& changes) {
  const StudioProgram studio;
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"]["file"] = kMeshFile;
  layout["sampling"]["density"] = 2.5e5;
  layout["sampling"]["weights"] = "equal";
  layout["material"]["field"] = "star";
  write_text(studio.folder() / "coarse.taxels.json", layout.dump());
  Lines script;
  std::istringstream guide(file_text(TAXEL_SOURCE_DIR "/scripts/pictures/hunt.jsonl"));
  std::vector<int> changed(changes.size());
  for (std::string line; std::getline(guide, line);) {
    for (std::size_t i = 0; i < changes.size(); ++i) {
      if (line.find(changes[i].from) != std::string::npos) line = changes[i].to, ++changed[i];
    }
    script.push_back(line);
    if (line.find("hunt_explained") != std::string::npos) script.push_back(dump("explained.json"));
  }
  EXPECT_EQ(changed, std::vector<int>(changes.size(), 1)) << "the script is another one";
  script.push_back(dump("cured.json"));
  studio.play(script, {"--scenario", TAXEL_SOURCE_DIR "/tests/fixtures/" + scenario, "coarse.taxels.json"});
  return {studio.state("explained.json"), studio.state("cured.json")};
}

void expect_found_and_cured(const Hunted& hunted) {
  const auto& [explained, cured] = hunted;
  EXPECT_NE(explained["messages"][0]["text"].get<std::string>().find("while the force stayed"), std::string::npos);
  const Json& verdict = explained["explain"]["verdict"];
  EXPECT_EQ(verdict["cause"], "sampling_noise") << verdict;
  EXPECT_GT(cured["simulation"]["time"], explained["simulation"]["time"]) << "beyond where it paused";
  EXPECT_EQ(cured["messages"].size(), explained["messages"].size()) << "it did not pause again";
}

TEST(Hunt, FindsExplainsAndCuresTheArtifact) {
  const Hunted hunted = hunt("edge_sweep.json", {});
  expect_found_and_cured(hunted);
  const Json& verdict = hunted.explained["explain"]["verdict"];
  const double contact = std::abs(verdict["contact"].get<double>());
  EXPECT_GT(std::abs(verdict["noise"].get<double>()), 3 * contact);
  EXPECT_LT(contact, verdict["limit"].get<double>() / 3) << "the contact is far from a jump";
  EXPECT_GE(hunted.cured["simulation"]["time"], 3.2);
}

/// Over the edge of a box, the contact itself hardly changes, relative to the largest reading of the sensor.
TEST(Hunt, ExplainsTheArtifactOverABoxBySamplesAlone) {
  const std::string jump = R"({"event": "double_click", "at": {"widget": "Timeline/Jump"}})";
  const Hunted hunted = hunt("box_sweep.json", {{R"("Timeline/Jump")", press("of sensor") + "\n" + kIdle + "\n" + jump},
                                                {R"("wait_time")", R"({"do": "wait_time", "time": 2.3})"}});
  expect_found_and_cured(hunted);
  const Json& verdict = hunted.explained["explain"]["verdict"];
  EXPECT_GT(std::abs(verdict["noise"].get<double>()), 10 * std::abs(verdict["contact"].get<double>()));
  EXPECT_GE(hunted.cured["simulation"]["time"], 2.3);
}

}  // namespace
}  // namespace taxel::test
