// Recordings out of the window: the history, and every step between two presses of the button.
#include <gtest/gtest.h>

#include "script_lines.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

Lines export_as(const std::string& file) {
  return {key("e", kCtrlShift), kIdle, key("a", kCtrl), type(file), kIdle, key("Enter"), kIdle};
}
std::string run_until(double time) {
  return R"({"do": "wait_time", "time": )" + std::to_string(time) + "}";
}
std::string in_folder(const StudioProgram& studio, const char* name) {
  return (studio.folder() / name).string();
}

TEST(Recording, TheHistoryGoesOutAsTheCommandLineRecordsIt) {
#ifdef TAXEL_PROGRAM
  const StudioProgram studio;
  const std::string scene = TAXEL_SOURCE_DIR "/assets/scenes/five_fingers.xml";
  studio.play(joined({{key("Space"), kIdle, key("Backspace"), kIdle},
                      {key("Right"), key("Right"), key("Right"), kIdle},
                      export_as(in_folder(studio, "history")),
                      export_as(in_folder(studio, "table.csv")),
                      export_as(in_folder(studio, "state.jsonl")),
                      {dump("state.json")}}),
              {scene});
  run_program(TAXEL_PROGRAM, {"run", scene, "--seconds", "0.003", "--out", "same", "--tactile-state"}, studio.folder());
  for (const char* file : {"readings.csv", "readings.npz"})
    EXPECT_TRUE(file_text(studio.folder() / "history" / file) == file_text(studio.folder() / "same" / file)) << file;
  EXPECT_TRUE(file_text(studio.folder() / "table.csv") == file_text(studio.folder() / "same/readings.csv"));
  EXPECT_TRUE(file_text(studio.folder() / "state.jsonl") == file_text(studio.folder() / "same/tactile_state.jsonl"));
  EXPECT_NE(studio.state("state.json")["messages"].dump().find("Recorded 3 steps in"), std::string::npos);
#else
  GTEST_SKIP() << "the command line is not built";
#endif
}

TEST(Recording, FromPressToPressAndTheFolderIsExplained) {
  const StudioProgram studio;
  studio.play({key("="), key("="), run_until(1.25), press("Record"), run_until(1.3), dump("on.json"),
               R"({"do": "screenshot", "file": "on.png"})", key("r", kCtrl), kIdle, dump("off.json")});
  const Json on = studio.state("on.json")["simulation"], off = studio.state("off.json")["simulation"];
  EXPECT_TRUE(on["history"]["recording"]["on"]);
  EXPECT_FALSE(off["history"]["recording"]["on"]);
  EXPECT_NEAR(on["history"]["recording"]["steps"].get<double>(), 60, 40);
  const fs::path run = studio.folder() / "recording-1";
  EXPECT_TRUE(fs::exists(run / "readings.csv"));
#ifdef TAXEL_PROGRAM
  const Outcome explained = run_program(
      TAXEL_PROGRAM, {"explain", "recording-1", "--taxel", "3", "--time", "1.3", "--json"}, studio.folder());
  EXPECT_EQ(explained.status, 0) << explained.err;
  EXPECT_EQ(explained.err, "") << "the contact computed anew reads what was recorded";
#endif
}

TEST(Recording, WhatCannotBeWrittenIsTold) {
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
