// The desktop's file dialog in the program: in a real window, under a script, and at the end of the program.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "app/studio/nouns/menus/window_commands.h"
#include "core/base/os/process.h"
#include "fixtures/fake_zenity.h"
#include "fixtures/surroundings.h"
#include "script_lines.h"

namespace taxel::test {
namespace {

/// Returns whether the window's own file dialog is open.
bool has_own_dialog(const Json& state) {
  const Json& widgets = state["widgets"];
  return std::any_of(widgets.begin(), widgets.end(), [](const Json& widget) { return widget["label"] == "Folder"; });
}

bool has_no_display_to_start() {
  return std::system("command -v xvfb-run > /dev/null 2>&1") != 0;
}

/// Presses Ctrl+O in an empty real window, with a shell script as the desktop's dialog. Returns the state after that.
Json state_after_open(const StudioProgram& studio, const std::string& zenity) {
  std::string script;
  for (const std::string& line : {kIdle, key("o", kCtrl), kIdle, dump("state.json"), std::string(R"({"do": "quit"})")})
    script += line + "\n";
  write_text(studio.folder() / "script.jsonl", script);
  const Outcome outcome = run_program(
      "/usr/bin/env",
      {"PATH=" + path_with_zenity(studio.folder(), zenity), "XDG_SESSION_DESKTOP=gnome", "xvfb-run", "-a", "-s",
       "-screen 0 1400x900x24", STUDIO_PROGRAM, "--script", "script.jsonl", "--live", "--desktop-dialog", "--empty"},
      studio.folder());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return studio.state("state.json");
}

TEST(RealWindow, OpensTheFileOfTheDesktopsDialog) {
  if (has_no_display_to_start()) GTEST_SKIP() << "xvfb-run is not installed";
  const StudioProgram studio;
  const Json state =
      state_after_open(studio, R"(printf '%s\n' "$@" > "$0.arguments"; sleep 0.3; echo ")" + kLayoutFile + "\"");
  EXPECT_EQ(state["document"]["file"], kLayoutFile);
  EXPECT_FALSE(has_own_dialog(state));
  const std::string arguments = file_text(studio.folder() / "programs" / "zenity.arguments");
  EXPECT_NE(arguments.find("Open a project, layout, mesh, MuJoCo scene, saved step or study\n"), std::string::npos);
  EXPECT_NE(arguments.find("--filename=" + std::filesystem::canonical(studio.folder()).string() + "/\n"),
            std::string::npos)
      << arguments;
}

TEST(RealWindow, StaysEmptyIfTheDesktopsDialogIsCancelled) {
  if (has_no_display_to_start()) GTEST_SKIP() << "xvfb-run is not installed";
  const StudioProgram studio;
  const Json state = state_after_open(studio, "touch \"$0.called\"; exit 1");
  EXPECT_TRUE(std::filesystem::exists(studio.folder() / "programs" / "zenity.called"));
  EXPECT_FALSE(has_own_dialog(state));
  EXPECT_TRUE(state["messages"].empty()) << state["messages"].dump();
}

TEST(RealWindow, OpensItsOwnDialogIfTheDesktopsFails) {
  if (has_no_display_to_start()) GTEST_SKIP() << "xvfb-run is not installed";
  const StudioProgram studio;
  const Json state = state_after_open(studio, "exit 255");
  EXPECT_TRUE(has_own_dialog(state));
  EXPECT_NE(state["messages"].dump().find("The desktop's file dialog ended with an error (exit status 255)"),
            std::string::npos)
      << state["messages"].dump();
}

TEST(Script, UsesTheWindowsOwnFileDialog) {
  const StudioProgram studio;
  const Surroundings surroundings({{"PATH", path_with_zenity(studio.folder(), "touch \"$0.called\"; exit 1")}});
  studio.play({kIdle, key("o", kCtrl), kIdle, dump("state.json")}, {kLayoutFile});
  EXPECT_TRUE(has_own_dialog(studio.state("state.json")));
  EXPECT_FALSE(std::filesystem::exists(studio.folder() / "programs" / "zenity.called"));
}

TEST(Save, AsksBeforeAnAddedExtensionReplacesAFile) {
  const StudioProgram studio;
  const std::string chosen = (studio.folder() / "hand").string(), written = chosen + ".taxelproj";
  write_text(written, "mine");
  const Surroundings surroundings(
      {{"PATH", path_with_zenity(studio.folder(), "echo \"" + chosen + "\"")}, {"XDG_SESSION_DESKTOP", "gnome"}});
  const Lines save{kLayoutMode, kIdle, key("s", kCtrl), kIdle, dump("asked.json")};
  studio.play(save, {"--desktop-dialog", kLayoutFile});
  EXPECT_TRUE(has_own_dialog(studio.state("asked.json")));
  EXPECT_EQ(file_text(written), "mine");
  studio.play(joined({save, {key("Enter"), kIdle}}), {"--desktop-dialog", kLayoutFile});
  EXPECT_EQ(Json::parse(file_text(written))["format"], "taxel-project") << "asked for once more";
}

TEST(Quit, EndsTheDesktopsDialog) {
  const StudioProgram studio;
  const Surroundings surroundings({{"PATH", path_with_zenity(studio.folder(), R"(echo $$ > "$0.id"; exec sleep 600)")},
                                   {"XDG_SESSION_DESKTOP", "gnome"}});
  studio.play({kIdle, key("o", kCtrl), R"({"do": "rest", "seconds": 3})", R"({"do": "quit"})"},
              {"--desktop-dialog", kLayoutFile});
  const int id = std::stoi(file_text(studio.folder() / "programs" / "zenity.id"));
  EXPECT_FALSE(os::has_process(id));
}

}  // namespace
}  // namespace taxel::test
