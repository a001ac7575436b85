// Recordings of the window: the history, and every step between two presses of the button.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "fixtures/finger_scene_xml.h"
#include "script_lines.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

Lines export_as(const std::string& file) {
  return {key("e", kCtrlShift), kIdle, key("a", kCtrl), type(file), kIdle, key("Enter"), kIdle};
}
std::string in_folder(const StudioProgram& studio, const char* name) {
  return (studio.folder() / name).string();
}

/// Writes two fingers on a floor, with few samples.
std::string two_fingers(const StudioProgram& studio) {
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"]["file"] = "fingertip.obj";
  layout["sampling"]["density"] = 1e5;
  fs::copy(kMeshFile, studio.folder());
  write_text(studio.folder() / "coarse.taxels.json", layout.dump());
  write_text(studio.folder() / "scene.xml", finger_scene(finger_body("thumb", 0) + finger_body("index", 0.1),
                                                         {"thumb", "index"}, "coarse.taxels.json"));
  return in_folder(studio, "scene.xml");
}

TEST(Recording, ExportsTheHistoryLikeTheCommandLine) {
#ifdef TAXEL_PROGRAM
  const StudioProgram studio;
  const std::string scene = two_fingers(studio);
  studio.play(joined({{key("Space"), kIdle, key("Backspace"), kIdle},
                      {key("Right"), key("Right"), key("Right"), kIdle},
                      export_as(in_folder(studio, "history")),
                      export_as(in_folder(studio, "table.csv")),
                      export_as(in_folder(studio, "state.jsonl")),
                      export_as(in_folder(studio, "bag.mcap")),
                      {dump("state.json")}}),
              {scene});
  run_program(TAXEL_PROGRAM, {"run", scene, "--seconds", "0.006", "--out", "same", "--tactile-state"}, studio.folder());
  for (const char* file : {"readings.csv", "readings.npz"})
    EXPECT_TRUE(file_text(studio.folder() / "history" / file) == file_text(studio.folder() / "same" / file)) << file;
  EXPECT_TRUE(file_text(studio.folder() / "table.csv") == file_text(studio.folder() / "same/readings.csv"));
  EXPECT_TRUE(file_text(studio.folder() / "state.jsonl") == file_text(studio.folder() / "same/tactile_state.jsonl"));
  EXPECT_FALSE(fs::exists(studio.folder() / "bag.mcap"));
  EXPECT_NE(studio.state("state.json")["messages"].dump().find("python -m taxel.mcap FOLDER FILE.mcap"),
            std::string::npos);
  EXPECT_NE(studio.state("state.json")["messages"].dump().find("Recorded 3 steps in"), std::string::npos);
#else
  GTEST_SKIP() << "the command line is not built";
#endif
}

TEST(Recording, RecordsFromPressToPressAndIsExplained) {
  const StudioProgram studio;
  studio.play({key("="), key("="), wait_time(1.1), press("Record"), kIdle, kIdle, wait_time(1.5), dump("on.json"),
               key("r", kCtrl), kIdle, dump("off.json")});
  const Json on = studio.state("on.json")["simulation"], off = studio.state("off.json")["simulation"];
  EXPECT_TRUE(on["history"]["recording"]["on"]);
  EXPECT_GT(on["history"]["recording"]["steps"].get<int>(), 20);
  EXPECT_FALSE(off["history"]["recording"]["on"]);
  std::istringstream rows(file_text(studio.folder() / "recording-1/readings.csv"));
  std::string row;
  std::getline(rows, row);
  double last = 0;
  int count = 0;
  for (; std::getline(rows, row); ++count) {
    const double time = std::stod(row);
    EXPECT_NEAR(time - (count > 0 ? last : time - 0.001), 0.001, 1e-9) << "every step";
    last = time;
  }
  EXPECT_GE(count, on["history"]["recording"]["steps"].get<int>());
#ifdef TAXEL_PROGRAM
  const Outcome explained =
      run_program(TAXEL_PROGRAM, {"explain", "recording-1", "--taxel", "3", "--time", std::to_string(last), "--json"},
                  studio.folder());
  EXPECT_EQ(explained.status, 0) << explained.err;
  EXPECT_EQ(explained.err, "") << "the recomputed contact gives the recorded readings";
#endif
}

TEST(Recording, ReportsAFileThatCannotBeWritten) {
  const StudioProgram studio;
  studio.play(joined({{key("Right"), kIdle},
                      export_as("/proc/none.csv"),
                      {dump("refused.json")},
                      export_as(in_folder(studio, "here.csv")),
                      {dump("state.json")}}));
  EXPECT_NE(studio.state("refused.json")["messages"].dump().find("/proc/none.csv"), std::string::npos);
  EXPECT_TRUE(fs::exists(studio.folder() / "here.csv"));
}

}  // namespace
}  // namespace taxel::test
