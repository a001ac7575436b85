// A window at rest: the end of a job of every kind is drawn without an input, LAYOUT pauses the run, and messages leave
// when they are over.
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "scenario_lines.h"
#include "virtual_screen.h"

namespace taxel::test {
namespace {

constexpr int kWidth = 1300, kHeight = 1500;

/// One job: the type of its result, the lines that begin it, and what another program does while it is awaited.
struct RestingJob {
  std::string slot;
  Lines begin;
  std::function<void(const std::filesystem::path&)> act = {};
  double seconds = 3;  ///< rest, in which the job ends
};

/// Writes the layout and its mesh into the folder of the test, and returns the arguments of a window without the tour.
std::vector<std::string> own_fingertip(const StudioProgram& studio) {
  std::filesystem::copy_file(kMeshFile, studio.folder() / "finger.obj");
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"] = {{"file", "finger.obj"}};
  layout["sampling"]["density"] = 1e5;
  write_text(studio.folder() / "few.taxels.json", layout.dump());
  std::filesystem::create_directories(studio.folder() / "state");
  write_text(studio.folder() / "state/settings.json",
             R"({"tour_seen": true, "panel_bars": false, "panel_plot": false, "panel_section": false,)"
             R"( "panel_outliner": false, "panel_taxels": false})");
  return {"--state-dir",      "state",
          "--autosave-every", "1",
          "--scenario",       TAXEL_SOURCE_DIR "/tests/fixtures/box_sweep.json",
          "few.taxels.json"};
}

const std::string kAside = R"({"event": "mouse_move", "at": [900, 9]})";
const std::string kStill = R"({"event": "mouse_move", "at": [901, 9]})";

std::string rest(double seconds) {
  return R"({"do": "rest", "seconds": )" + std::to_string(seconds) + "}";
}

const std::vector<RestingJob> kInLayout{
    {"BuiltModel", {kLayoutMode, kIdle, key("a"), kIdle, key("f"), kIdle, type("5"), kIdle, key("Enter")}},
    {"Outcome", {}},
    {"PatternResult", {key("g", kCtrl)}},
    {"ShownFields",
     {key("Escape"), kIdle, click("[246, 12]"), kIdle, press("View/Taxels and fields"), kIdle,
      press("Coverage and overlap")}},
    {"Measured", {key("m"), kIdle, click(taxel(3)), kIdle, click(taxel(9))}},
    {"PressedProbe", {key("Escape"), kIdle, key("x"), kIdle, click(taxel(3))}},
    {"ComparedMesh",
     {},
     [](const std::filesystem::path& folder) {
       write_text(folder / "finger.obj", file_text(kMeshFile) + "v 0 0 0\n# changed\n");
     }},
    {"LoadResult", {R"({"event": "drop", "files": [")" + kMeshFile + R"("]})", kIdle, press("Discard")}},
};

const std::vector<RestingJob> kInSimulate{
    {"ExplainedStep", {key("="), key("="), R"({"do": "wait_time", "time": 1.3})", key("Space"), kIdle, key("e")}},
    {"ExactCurve", {press("Show in the plot")}, {}, 6},
    {"MeasuredErrors", {key("F4")}},
    {"ReadingsResult", {press("Panels"), kIdle, press("Models")}, {}, 15},
    {"ReadingsResult", {press("Simulation"), kIdle, press("Compare with the paper's released model")}, {}, 8},
};

Lines typed(const std::string& field, const std::string& text) {
  return {press("Study/" + field), kIdle, key("a", kCtrl), type(text), key("Enter"), kIdle};
}

const std::vector<RestingJob> kStudies{
    {"StudyCurves",
     joined({{key("Space"), kIdle, press("Panels"), kIdle, press("Study"), kIdle},
             typed("Vary from", "0.5"),
             typed("Vary to", "1 mm"),
             typed("Vary values", "2"),
             {press("Study/Run study")}}),
     {},
     8},
    // The note at its end leaves by itself after six seconds, and a slow machine writes for several.
    {"SavedStudy", {press("Study/Save as batch..."), kIdle, type("written"), key("Enter")}, {}, 18},
};

/// Returns the rows of a picture above the status line, which has measured times.
std::string above_status(const std::string& picture) {
  constexpr std::size_t kStatusRows = 40;
  return picture.substr(0, std::size_t{4} * kWidth * (kHeight - kStatusRows));
}

/// Plays the jobs one after the other in a real window. After each the picture must be the same after a move of the
/// mouse.
void expect_ends_are_drawn(const std::vector<RestingJob>& jobs) {
  if (const std::string missing = VirtualScreen::missing(); !missing.empty()) GTEST_SKIP() << missing << " is absent";
  const StudioProgram studio;
  const VirtualScreen screen(studio.folder(), kWidth, kHeight);
  std::string script = kIdle + "\n";
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    for (const std::string& line : jobs[i].begin) script += line + "\n";
    for (const std::string& line : {kAside, dump("begun" + std::to_string(i) + ".json"), rest(jobs[i].seconds), kStill,
                                    dump("moved" + std::to_string(i) + ".json"), rest(1.5)})
      script += line + "\n";
  }
  write_text(studio.folder() / "script.jsonl", script + R"({"do": "quit"})" + "\n");
  std::vector<std::string> command{"/usr/bin/env",
                                   "-C",
                                   studio.folder().string(),
                                   "DISPLAY=" + screen.name(),
                                   STUDIO_PROGRAM,
                                   "--live",
                                   "--script",
                                   "script.jsonl",
                                   "--size",
                                   std::to_string(kWidth) + "x" + std::to_string(kHeight)};
  const std::vector<std::string> arguments = own_fingertip(studio);
  command.insert(command.end(), arguments.begin(), arguments.end());
  os::ChildProcess program;
  ASSERT_TRUE(program.start(command, studio.folder() / "errors"));
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const auto exists = [&](const char* name) {
      return std::filesystem::exists(studio.folder() / (name + std::to_string(i) + ".json"));
    };
    ASSERT_TRUE(holds_within(90, [&] { return exists("begun"); }))
        << jobs[i].slot << ": " << file_text(studio.folder() / "errors");
    if (jobs[i].act) jobs[i].act(studio.folder());
    std::string at_rest;
    ASSERT_TRUE(holds_within(60, [&] {
      const std::string now = screen.picture();
      if (exists("moved")) return true;
      at_rest = now;
      return false;
    })) << jobs[i].slot;
    ::poll(nullptr, 0, 600);
    EXPECT_TRUE(above_status(screen.picture()) == above_status(at_rest)) << jobs[i].slot << ": drawn at its end";
  }
}

TEST(RealWindow, DrawsTheEndsOfJobsOfTheEditorAtRest) {
  expect_ends_are_drawn(kInLayout);
}

TEST(RealWindow, DrawsTheEndsOfJobsAboutTheRunAtRest) {
  expect_ends_are_drawn(kInSimulate);
}

TEST(RealWindow, DrawsTheEndsOfStudiesAtRest) {
  expect_ends_are_drawn(kStudies);
}

// A new kind of job needs a row above. The name of a kind is the type of its result.
TEST(JobKinds, AreAllTriedInAWindowAtRest) {
  const std::regex slot(R"(NewestWins<.*, (?:ui::)?(\w+)>)");
  std::set<std::string> tried, found;
  for (const auto* jobs : {&kInLayout, &kInSimulate, &kStudies})
    for (const RestingJob& job : *jobs) tried.insert(job.slot);
  const std::filesystem::path root = TAXEL_SOURCE_DIR "/src/app/studio";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    const std::string file = entry.path().lexically_relative(root).generic_string();
    if (!entry.is_regular_file() || file.starts_with("host/jobs/")) continue;
    const std::string text = file_text(entry.path());
    for (std::sregex_iterator it(text.begin(), text.end(), slot), end; it != end; ++it) found.insert((*it)[1]);
  }
  EXPECT_EQ(found, tried);
}

TEST(LayoutMode, PausesTheRunUntilItIsLeft) {
  const StudioProgram studio;
  studio.play({R"({"do": "wait_time", "time": 0.2})", kLayoutMode, kIdle, dump("entered.json"), at_frame(60),
               dump("later.json"), key("2", kCtrl), at_frame(80), dump("left.json")},
              {kLayoutFile});
  const auto time = [&](const char* file) { return studio.state(file)["simulation"]["time"].get<double>(); };
  EXPECT_FALSE(studio.state("entered.json")["simulation"]["playing"]);
  EXPECT_EQ(time("later.json"), time("entered.json"));
  EXPECT_GT(time("left.json"), time("later.json") + 0.1) << "it goes on";
}

TEST(LayoutMode, RunsInSimulateBySpace) {
  const StudioProgram studio;
  studio.play(
      {R"({"do": "wait_time", "time": 0.2})", key("Space"), kLayoutMode, kIdle, dump("entered.json"), key("2", kCtrl),
       kIdle, dump("back.json"), kLayoutMode, kIdle, key("Space"), at_frame(80), dump("runs.json")},
      {kLayoutFile});
  EXPECT_FALSE(studio.state("back.json")["simulation"]["playing"]) << "it was paused before";
  const Json runs = studio.state("runs.json");
  EXPECT_EQ(runs["mode"], "simulate");
  EXPECT_TRUE(runs["simulation"]["playing"]);
  EXPECT_GT(runs["simulation"]["time"], studio.state("entered.json")["simulation"]["time"].get<double>());
}

/// Returns the labels of the status line that begin with a word.
std::vector<std::string> in_status(const Json& state, const std::string& begin) {
  std::vector<std::string> found;
  for (const Json& widget : state["widgets"])
    if (const std::string label = widget["label"]; widget["panel"] == "Status" && label.starts_with(begin))
      found.push_back(label);
  return found;
}

TEST(StatusLine, HasTheForceOfTheProbeInLayout) {
  const StudioProgram studio;
  studio.play({key("="), key("="), R"({"do": "wait_time", "time": 1.3})", key("Space"), kIdle, dump("run.json"),
               kLayoutMode, kIdle, dump("plain.json"), key("x"), kIdle,
               R"({"event": "mouse_move", "at": )" + taxel(3) + "}", kIdle, dump("probed.json")},
              {kLayoutFile});
  EXPECT_EQ(in_status(studio.state("run.json"), "force ").size(), 1U);
  EXPECT_TRUE(in_status(studio.state("plain.json"), "force ").empty()) << "nothing is pressed";
  const Json probed = studio.state("probed.json");
  char expected[32] = {};
  std::snprintf(expected, sizeof expected, "force %.3f N", probed["probe"]["reading"]["force"].get<double>());
  EXPECT_EQ(in_status(probed, "force "), std::vector<std::string>{expected});
  EXPECT_TRUE(in_status(probed, "time ").empty());
}

/// Returns whether the line shows a message with this text.
bool shows_message(const Json& state, const std::string& text) {
  for (const Json& message : state["messages"])
    if (message["text"].get<std::string>().find(text) != std::string::npos && message["shown"]) return true;
  return false;
}

TEST(MessageLine, LosesMessagesThatAreOver) {
  const StudioProgram studio;
  studio.play({kLayoutMode,
               kIdle,
               key("v", kCtrl),
               kIdle,
               dump("refused.json"),
               key("a"),
               kIdle,
               key("Delete"),
               kIdle,
               dump("edited.json"),
               key("n", kCtrl),
               kIdle,
               press("Discard"),
               kIdle,
               key("2", kCtrl),
               kIdle,
               dump("empty.json"),
               click(in_view(0.5, 0.5), kCtrl),
               kIdle,
               kIdle,
               dump("placed.json")},
              {kLayoutFile});
  const Json refused = studio.state("refused.json");
  ASSERT_EQ(refused["messages"].size(), 1U);
  EXPECT_TRUE(refused["messages"][0]["shown"]) << "the clipboard has no taxels";
  EXPECT_FALSE(studio.state("edited.json")["messages"][0]["shown"]) << "another edit has succeeded";
  EXPECT_TRUE(shows_message(studio.state("empty.json"), "Nothing to simulate"));
  EXPECT_FALSE(shows_message(studio.state("placed.json"), "Nothing to simulate"));
}

TEST(MessageLine, LosesTheReasonOfAPauseWhenTheRunGoesOn) {
  const StudioProgram studio;
  studio.play({press("Tracks"), kIdle, key("="), key("="), press("Jump"), key("a", kCtrl), type("1"), key("Enter"),
               key("b", kShift), R"({"do": "wait_for", "pointer": "/messages", "contains": "jumped"})", kIdle,
               dump("jumped.json"), key("b", kShift), key("Space"), kIdle, dump("runs.json")},
              sparse_fingertip(studio, 1e5));
  EXPECT_TRUE(shows_message(studio.state("jumped.json"), "jumped"));
  EXPECT_FALSE(shows_message(studio.state("runs.json"), "jumped"));
}

}  // namespace
}  // namespace taxel::test
