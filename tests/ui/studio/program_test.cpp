// The program itself: options, invalid scripts, a real window, settings.
#include <gtest/gtest.h>

#include <cstdlib>
#include <regex>

#include "app/studio/frame/keymap.h"
#include "studio_program.h"

namespace taxel::test {
namespace {

TEST(Options, PrintEveryKeyByListBindings) {
  const StudioProgram studio;
  const Outcome outcome = run_program(STUDIO_PROGRAM, {"--list-bindings"}, studio.folder());
  EXPECT_EQ(outcome.status, 0);
  for (const ui::Binding& b : ui::bindings()) {
    if (b.chord == 0) continue;
    EXPECT_NE(outcome.out.find(ui::chord_name(b.chord)), std::string::npos) << b.label;
    EXPECT_NE(outcome.out.find(b.label), std::string::npos);
  }
}

TEST(Options, RefuseBadUsageInOneLineWithStatusTwo) {
  const StudioProgram studio;
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"--no-such-option"},
                                                    {"--size", "12"},
                                                    {"--size", "0x0"},
                                                    {"--frames", "-3"},
                                                    {"--headless", "--script", "missing.jsonl"},
                                                    {"--headless", "--shader-dir", "nowhere"}}) {
    const Outcome outcome = run_program(STUDIO_PROGRAM, arguments, studio.folder());
    EXPECT_EQ(outcome.status, 2) << arguments.back();
    EXPECT_EQ(outcome.err.rfind("taxelstudio: ", 0), 0U) << outcome.err;
  }
}

TEST(Options, NameCommitAndMuJoCoByVersion) {
  const StudioProgram studio;
  const Outcome outcome = run_program(STUDIO_PROGRAM, {"--version"}, studio.folder());
  EXPECT_EQ(outcome.status, 0);
  const std::regex line(
      R"(taxelstudio \d+\.\d+\.\d+, commit ([0-9a-f]{12}(-dirty)?|unknown), MuJoCo \d+\.\d+\.\d+, Dear ImGui .+\n)");
  EXPECT_TRUE(std::regex_match(outcome.out, line)) << outcome.out;
#ifdef TAXEL_PROGRAM
  const std::string other = run_program(TAXEL_PROGRAM, {"--version"}, studio.folder()).out;
  EXPECT_EQ(outcome.out.substr(12, outcome.out.find(", Dear") - 12), other.substr(6, other.size() - 7)) << "one build";
#endif
}

TEST(Options, WriteAScreenshotAndTheStateWithoutAScript) {
  const StudioProgram studio;
  const Outcome outcome = run_program(
      STUDIO_PROGRAM,
      {"--headless", "--frames", "4", "--size", "900x600", "--screenshot", "a.png", "--dump-state", "a.json"},
      studio.folder());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const Picture picture = studio.picture("a.png");
  EXPECT_EQ(picture.width, 900);
  EXPECT_EQ(picture.height, 600);
  EXPECT_EQ(studio.state("a.json")["pace"]["pictures"], 4);
}

TEST(Options, RefuseABadFileInOneLineWithStatusTwo) {
  const StudioProgram studio;
  for (const char* file : {"gone.taxels.json", "gone.xml"}) {
    const Outcome outcome =
        run_program(STUDIO_PROGRAM, {"--headless", "--frames", "2", "--dump-state", "a.json", file}, studio.folder());
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, std::string("taxelstudio: ") + file + ": no such file\n");
    EXPECT_NE(studio.state("a.json")["messages"].dump().find("no such file"), std::string::npos) << "the same there";
  }
}

TEST(Options, FailIfAScreenshotCannotBeWritten) {
  const StudioProgram studio;
  const Outcome outcome = run_program(
      STUDIO_PROGRAM, {"--headless", "--frames", "1", "--screenshot", "no/such/folder/a.png"}, studio.folder());
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("no/such/folder/a.png"), std::string::npos) << outcome.err;
}

TEST(Script, NamesTheLineOfAnErrorAndExitsWithTwo) {
  const StudioProgram studio;
  const std::vector<std::pair<std::string, std::string>> bad{
      {"{\"frame\": 1", "line 2: is no JSON object"},
      {R"({"event": "click", "do": "quit"})", "line 2: needs either"},
      {R"({"event": "leap"})", "line 2: does not know the event \"leap\""},
      {R"({"do": "leap"})", "line 2: does not know the command"},
      {R"({"frame": 1e30, "do": "quit"})", "line 2: \"frame\" must be a whole number below 2^31, is 1e+30"},
      {R"({"event": "click", "at": [1]})", "line 2: needs 2 numbers"},
      {R"({"event": "click", "at": {"widget": "No Such Button"}})", "line 2: no widget \"No Such Button\""},
      {R"({"event": "click", "at": {"taxel": 77}})", "line 2: there is no taxel 77"},
      {R"({"event": "click", "at": {"world": [0, 0, 50]}})", "line 2: the point is outside"},
      {R"({"event": "key", "key": "Leap"})", "line 2: does not know the key"},
      {R"({"event": "key", "key": "a", "colour": 1})", "line 2: does not know \"colour\""},
      {R"({"do": "expect", "pointer": "/mode", "equals": "layout"})", "line 2: expected /mode"},
      {R"({"do": "expect", "pointer": "/no/such", "equals": 1})", "line 2: expected /no/such"},
  };
  for (const auto& [line, message] : bad) {
    const Outcome outcome = studio.run({R"({"frame": 1, "do": "wait_idle"})", line});
    EXPECT_EQ(outcome.status, 2) << line;
    EXPECT_NE(outcome.err.find(message), std::string::npos) << line << " -> " << outcome.err;
  }
}

TEST(Script, PassesIfItsExpectationsHold) {
  const StudioProgram studio;
  studio.play({R"({"frame": 3, "do": "expect", "pointer": "/mode", "equals": "simulate"})",
               R"({"do": "expect", "pointer": "/simulation/time", "least": 0.02, "most": 0.2})",
               R"({"do": "expect", "pointer": "/document/name", "contains": "ingertip"})",
               R"({"event": "resize", "width": 1000, "height": 700})", R"({"do": "wait_idle"})",
               R"({"do": "screenshot", "file": "a.png"})", R"({"event": "close"})", R"({"frame": 900, "do": "quit"})"});
  EXPECT_EQ(studio.picture("a.png").width, 1000);
}

TEST(RealWindow, DrawsTheSweepInRealTime) {
  if (std::system("command -v xvfb-run > /dev/null 2>&1") != 0) GTEST_SKIP() << "xvfb-run is not installed";
  const StudioProgram studio;
#ifdef __SANITIZE_ADDRESS__
  const std::string frames = "500";  // the samples are polished for longer than 60 frames take
#else
  const std::string frames = "60";
#endif
  const Outcome outcome =
      run_program("/usr/bin/env",
                  {"XDG_CONFIG_HOME=" + studio.folder().string(), "XDG_STATE_HOME=" + studio.folder().string(),
                   "xvfb-run", "-a", "-s", "-screen 0 1400x900x24", STUDIO_PROGRAM, "--frames", frames, "--screenshot",
                   "window.png", "--dump-state", "window.json"},
                  studio.folder());
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(studio.picture("window.png").width, 1280);
  EXPECT_EQ(studio.picture("window.png").height, 800);
  const Json state = studio.state("window.json");
  EXPECT_TRUE(state["messages"].empty()) << state["messages"].dump();
  EXPECT_GT(state["simulation"]["time"], 0.1);
  EXPECT_TRUE(std::filesystem::exists(studio.folder() / "taxelstudio" / "settings.json"));
  EXPECT_TRUE(std::filesystem::exists(studio.folder() / "taxelstudio" / "arrangement-simulate.ini"));
  // The status line shows the speed of the simulation (a slow machine draws 60 frames beyond the sweep's end) and the
  // cost of a step.
  const std::string widgets = state["widgets"].dump();
  EXPECT_TRUE(std::regex_search(widgets, std::regex(R"x("simulation (\d+\.\d\d x real time|ended)")x"))) << widgets;
  EXPECT_TRUE(std::regex_search(widgets, std::regex(R"x("step (\d+ µs|\d+\.\d\d ms)")x"))) << widgets;
  EXPECT_GT(state["pace"]["step_seconds"], 1e-6);
  EXPECT_LT(state["pace"]["step_seconds"], 1.0);
  std::printf("%.1f pictures per second in a real window\n", state["pace"]["frames_per_second"].get<double>());
}

TEST(RealWindow, ReportsInOneLineThatThereIsNoDisplay) {
  const StudioProgram studio;
  const Outcome outcome = run_program(
      "/usr/bin/env", {"-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", STUDIO_PROGRAM, "--frames", "1"}, studio.folder());
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("--headless"), std::string::npos) << outcome.err;
}

TEST(Options, SayWhichOneOfTwoIsToBeLeftOut) {
  const StudioProgram studio;
  const auto error_of = [&](const std::vector<std::string>& arguments) {
    const Outcome outcome = run_program(STUDIO_PROGRAM, arguments, studio.folder());
    EXPECT_EQ(outcome.status, 2);
    return outcome.err;
  };
  EXPECT_EQ(error_of({"tip.obj", "--empty"}),
            "taxelstudio: --empty: opens nothing, but FILE is tip.obj: leave out --empty to open the file\n");
  EXPECT_EQ(error_of({"tip.obj", "--demo"}),
            "taxelstudio: --demo: plays the fingertip sweep, but FILE is tip.obj: leave out --demo to open the file\n");
  EXPECT_EQ(error_of({"--demo", "--empty"}),
            "taxelstudio: --demo: plays the fingertip sweep, but --empty opens nothing: leave out one of them\n");
}

}  // namespace
}  // namespace taxel::test
