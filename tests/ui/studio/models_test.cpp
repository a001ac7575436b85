// The Models panel through the program: the displayed step and the recorded steps as other models read them, with the
// numbers of `taxel models`.
#include <gtest/gtest.h>

#include <cmath>

#include "csv_row.h"
#include "script_lines.h"

namespace taxel::test {
namespace {

const char* const kModelWords[] = {"reading", "star", "weighted_sum", "exact", "tactile", "touch"};

/// Writes our fingertip with few samples, yet enough for all models to read them.
std::vector<std::string> few_samples(const StudioProgram& studio) {
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"]["file"] = kMeshFile;
  layout["sampling"]["density"] = 5e5;
  write_text(studio.folder() / "few.taxels.json", layout.dump());
  return {"--size", "1280x1500", "few.taxels.json"};
}

/// Paused soon after the first touch, with the panel open.
const Lines kOpened{key("="),
                    key("="),
                    R"({"do": "wait_time", "time": 0.9})",
                    key("Space"),
                    kIdle,
                    press("Panels"),
                    kIdle,
                    press("Models"),
                    kIdle,
                    dump("opened.json")};

TEST(ModelsPanel, ReadsTheDisplayedStepLikeTheCommandLine) {
  const StudioProgram studio;
  studio.play(kOpened, few_samples(studio));
  const Json state = studio.state("opened.json"), &models = state["models"];
  ASSERT_TRUE(models.is_object()) << state["models"].dump();
  EXPECT_EQ(models["problem"], "");
  EXPECT_EQ(models["step"], state["simulation"]["step"]);
  EXPECT_EQ(models["models"]["reading"]["values"], state["simulation"]["readings"]);
  EXPECT_GE(models["steps"], models["due"]);
  EXPECT_GT(models["due"], 60);
  EXPECT_LE(models["due"], 120);
  for (const char* word : kModelWords) {
    EXPECT_EQ(models["models"][word]["values"].size(), 12U) << word;
    EXPECT_EQ(models["models"][word]["missing"], "") << word;
    EXPECT_GT(models["models"][word]["peak"].get<double>(), 0) << word << " of taxel " << models["taxel"];
  }
#ifdef TAXEL_PROGRAM
  const Outcome swept = run_program(TAXEL_PROGRAM,
                                    {"sweep", "--layout", "few.taxels.json", "--object", "box", "--past", "0.002",
                                     "--record-every", "0.00001", "--out", "run", "--quiet"},
                                    studio.folder());
  ASSERT_EQ(swept.status, 0) << swept.err;
  // Every step is a row: the first step and this one.
  const double time = state["simulation"]["time"];
  const std::string number = std::to_string(std::lround(1e3 * time));
  const Outcome said = run_program(TAXEL_PROGRAM, {"models", "run", "--every", number, "--out", "models.csv", "--json"},
                                   studio.folder());
  ASSERT_EQ(said.status, 0) << said.err;
  std::map<std::string, double> row = csv_row(studio.folder() / "models.csv", time);
  ASSERT_NEAR(row["time"], time, 1e-9);
  for (const char* word : kModelWords) {
    for (std::size_t k = 0; k < 12; ++k) {
      const double window = models["models"][word]["values"][k], line = row[word + ("_" + std::to_string(k))];
      EXPECT_NEAR(window, line, 1e-9 * std::abs(line)) << word << " " << k;
    }
  }
#endif
}

TEST(ModelsPanel, FollowsScrubbingAndTheNextRun) {
  const StudioProgram studio;
  const Lines back{key("Left"), key("Left"), kIdle, dump("back.json")};
  const Lines on{key("Right"), kIdle, dump("on.json"), press("Model row 3"), kIdle, dump("row.json")};
  const Lines again{key("Backspace"), kIdle, key("Space"),      R"({"do": "wait_time", "time": 0.87})",
                    key("Space"),     kIdle, dump("again.json")};
  studio.play(joined({kOpened, back, on, again}), few_samples(studio));
  for (const char* file : {"back.json", "on.json", "again.json"}) {
    const Json state = studio.state(file);
    EXPECT_EQ(state["models"]["step"], state["simulation"]["step"]) << file;
    EXPECT_EQ(state["models"]["models"]["reading"]["values"], state["simulation"]["readings"]) << file;
    EXPECT_GE(state["models"]["steps"], state["models"]["due"]) << file;
  }
  EXPECT_EQ(studio.state("row.json")["selection"]["taxel"], 3);
  EXPECT_EQ(studio.state("row.json")["models"]["taxel"], 3);
}

}  // namespace
}  // namespace taxel::test
