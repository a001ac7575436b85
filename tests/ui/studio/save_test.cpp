// Saving, exporting, leaving unsaved edits, and getting them back after a crash.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <thread>

#include "script_lines.h"

namespace taxel::test {
namespace {

/// Looks at the layout and makes the radius of taxel 3 three millimetres.
const Lines kEdit{kLayoutMode,  kIdle, R"({"event": "click", "at": {"taxel": 3}})", kIdle, key("f"), type("3"), kIdle,
                  key("Enter"), kIdle};

/// Opens a dialog by a key, types a name and presses Enter.
Lines in_dialog(const std::string& letter, const std::string& name) {
  return {key(letter, kCtrl), kIdle, type(name), kIdle, key("Enter"), kIdle};
}

double radius_of_3(const Json& layout) {
  return taxel_of(layout, 3)["radius"];
}

TEST(Save, AsAProjectThatOpensAgain) {
  const StudioProgram studio;
  const std::string file = (studio.folder() / "mine.taxelproj").string();
  studio.play(joined({kEdit,
                      {dump("edited.json"), R"({"event": "wheel", "at": [500, 300], "y": 3})", kIdle},
                      in_dialog("s", file),
                      {dump("saved.json"), key("z", kCtrl), kIdle, dump("undone.json"), key("y", kCtrl), kIdle,
                       dump("redone.json")}}),
              {kLayoutFile});
  EXPECT_TRUE(studio.state("edited.json")["history"]["dirty"]);
  EXPECT_EQ(studio.state("edited.json")["title"].get<std::string>().front(), '*');
  const Json saved = studio.state("saved.json");
  EXPECT_FALSE(saved["history"]["dirty"]);
  EXPECT_NE(saved["title"].get<std::string>().front(), '*');
  EXPECT_EQ(saved["document"]["file"], file);
  EXPECT_TRUE(studio.state("undone.json")["history"]["dirty"]);
  EXPECT_FALSE(studio.state("redone.json")["history"]["dirty"]) << "as it was saved";
  const std::string bytes = file_text(file);
  EXPECT_EQ(Json::parse(bytes)["format"], "taxel-project");

  studio.play({kIdle, dump("opened.json"), R"({"event": "wheel", "at": [500, 300], "y": 2})", key("s", kCtrl), kIdle},
              {file});
  const Json opened = studio.state("opened.json");
  EXPECT_EQ(opened["mode"], "layout") << "one goes on editing";
  EXPECT_EQ(opened["document"]["layout"], saved["document"]["layout"]);
  EXPECT_NE(saved["camera"], studio.state("edited.json")["camera"]);
  EXPECT_EQ(opened["camera"], saved["camera"]) << "as it was left";
  EXPECT_EQ(Json::parse(file_text(file))["layout"], Json::parse(bytes)["layout"]) << "Ctrl+S writes where it is";
}

TEST(Save, ExportImportExportGivesTheSameBytes) {
  const StudioProgram studio;
  const std::string first = (studio.folder() / "one.taxels.json").string();
  const std::string second = (studio.folder() / "two.taxels.json").string();
  studio.play(joined({kEdit, in_dialog("e", (studio.folder() / "one").string()), {dump("exported.json")}}));
  EXPECT_TRUE(studio.state("exported.json")["history"]["dirty"]) << "an export is no save";
  EXPECT_EQ(radius_of_3(Json::parse(file_text(first))), 0.003);
  EXPECT_EQ(Json::parse(file_text(first))["mesh"]["file"], "fingertip.obj") << "which was written beside it";
  studio.play(joined({{kLayoutMode, kIdle}, in_dialog("e", second)}), {first});
  EXPECT_EQ(file_text(first), file_text(second));
#ifdef TAXEL_PROGRAM
  EXPECT_EQ(run_program(TAXEL_PROGRAM, {"check", first}, studio.folder()).status, 0);
#endif
}

TEST(Save, AsksBeforeItReplacesAFileAndSaysWhyItCannotWrite) {
  const StudioProgram studio;
  const std::string there = (studio.folder() / "there.taxels.json").string();
  write_text(there, "mine");
  studio.play(joined({kEdit, in_dialog("e", there), {dump("asked.json"), key("Esc"), kIdle}}), {kLayoutFile});
  EXPECT_EQ(file_text(there), "mine");
  EXPECT_NE(studio.state("asked.json")["widgets"].dump().find("Export"), std::string::npos) << "the dialog is open";
  studio.play(joined({kEdit, in_dialog("e", there), {key("Enter"), kIdle}}), {kLayoutFile});
  EXPECT_EQ(radius_of_3(Json::parse(file_text(there))), 0.003) << "asked for once more";
  studio.play(joined({kEdit, in_dialog("s", "/proc/none.taxelproj"), {dump("refused.json")}}), {kLayoutFile});
  const Json refused = studio.state("refused.json");
  EXPECT_NE(refused["messages"].dump().find("/proc/none.taxelproj"), std::string::npos);
  EXPECT_TRUE(refused["history"]["dirty"]);
}

TEST(Close, AsksWhetherToSave) {
  const StudioProgram studio;
  const std::string file = (studio.folder() / "kept.taxelproj").string();
  const std::string close = R"({"event": "close"})";
  const Lines cancel{close, kIdle, dump("asked.json"), press("Unsaved changes/Cancel"), kIdle, dump("cancelled.json")};
  const Lines save{
      close, kIdle, press("Unsaved changes/Save"), kIdle, type(file), kIdle, key("Enter"), kIdle, dump("never.json")};
  studio.play(joined({kEdit, cancel, save}), {kLayoutFile});
  EXPECT_NE(studio.state("asked.json")["widgets"].dump().find("Discard"), std::string::npos);
  EXPECT_TRUE(studio.state("cancelled.json")["history"]["dirty"]);
  EXPECT_EQ(radius_of_3(Json::parse(file_text(file))["layout"]), 0.003);
  EXPECT_FALSE(std::filesystem::exists(studio.folder() / "never.json")) << "saved, then closed";
}

TEST(Close, DiscardsWhenToldSoAndAsksBeforeAnotherFileToo) {
  const StudioProgram studio;
  const std::string open = R"({"event": "drop", "files": [")" + kLayoutFile + R"("]})";
  studio.play(joined({kEdit,
                      {open, kIdle, dump("asked.json"), press("Unsaved changes/Discard"), kIdle, dump("opened.json"),
                       R"({"event": "close"})", kIdle, dump("never.json")}}),
              {kLayoutFile});
  EXPECT_EQ(radius_of_3(studio.state("asked.json")["document"]["layout"]), 0.003);
  EXPECT_EQ(radius_of_3(studio.state("opened.json")["document"]["layout"]), 0.006);
  EXPECT_EQ(studio.state("opened.json")["history"]["depth"], 0);
  EXPECT_FALSE(std::filesystem::exists(studio.folder() / "never.json")) << "nothing to ask";
}

TEST(Empty, StartsWithoutADocument) {
  const StudioProgram studio;
  studio.play({kIdle, dump("empty.json"), press("Fingertip sweep"), kIdle, dump("sweep.json")}, {"--empty"});
  EXPECT_TRUE(studio.state("empty.json")["document"].is_null());
  EXPECT_TRUE(studio.state("empty.json")["simulation"].is_null());
  EXPECT_EQ(studio.state("sweep.json")["document"]["layout"]["taxels"].size(), 12U);
}

TEST(StateFolder, KeepsSettingsUnderScripts) {
  const StudioProgram studio;
  studio.play({kIdle, key("w"), kIdle}, {"--empty", "--state-dir", "state"});
  studio.play({kIdle, dump("again.json")}, {"--empty", "--state-dir", "state"});
  EXPECT_TRUE(studio.state("again.json")["overlays"]["wireframe"]);
}

/// A script that goes on for ever is played until `enough`; then the program is killed. Edits are to be kept every so
/// many seconds of the script.
template <class Done>
void play_and_kill(const StudioProgram& studio, const Lines& lines, const char* every, const Done& enough) {
  std::string script;
  for (const std::string& line : lines) script += line + "\n";
  script += R"({"frame": 100000000, "do": "quit"})";
  write_text(studio.folder() / "endless.jsonl", script + "\n");
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    if (::chdir(studio.folder().c_str()) != 0) ::_exit(125);
    ::execl(STUDIO_PROGRAM, STUDIO_PROGRAM, "--script", "endless.jsonl", "--state-dir", "state", "--autosave-every",
            every, kLayoutFile.c_str(), in_a_window() ? nullptr : "--headless", nullptr);
    ::_exit(126);
  }
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(120);
  bool done = false;
  while (!done && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    done = enough();
  }
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(done) << "it did not get so far";
  EXPECT_TRUE(WIFSIGNALED(status));
}

bool is_kept(const std::filesystem::path& folder) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".taxelproj") return true;
  return false;
}

/// Killed as soon as its edit is kept.
void edit_and_kill(const StudioProgram& studio, const std::string& kept) {
  play_and_kill(studio, kEdit, "0.02", [&] { return is_kept(studio.folder() / kept); });
}

TEST(Recovery, AfterAKillTheEditsAreOfferedAndCanBeHadBack) {
  const StudioProgram studio;
  edit_and_kill(studio, "state/autosave");
  const std::vector<std::string> arguments{"--empty", "--state-dir", "state"};
  studio.play({kIdle, dump("offered.json"), press("Recover"), kIdle, dump("recovered.json"),
               R"({"do": "screenshot", "file": "recovered.png"})"},
              arguments);
  EXPECT_FALSE(studio.state("offered.json")["recovery"].get<std::string>().empty());
  const Json recovered = studio.state("recovered.json");
  EXPECT_EQ(radius_of_3(recovered["document"]["layout"]), 0.003);
  EXPECT_TRUE(recovered["history"]["dirty"]);
  EXPECT_EQ(recovered["document"]["file"], kLayoutFile);
  EXPECT_TRUE(recovered["recovery"].get<std::string>().empty());
  studio.play({kIdle, dump("again.json")}, arguments);
  EXPECT_TRUE(studio.state("again.json")["recovery"].get<std::string>().empty()) << "the program ended as it should";
}

/// Edits one after the other, and a kill in the middle of them: of what was done, only the last interval's may be lost.
TEST(Recovery, AKillLosesNoMoreThanOneInterval) {
  const StudioProgram studio;
  constexpr int kFrom = 100, kEdits = 400, kKilledAfter = 120;  // frames; edits
  constexpr int kFramesPerEdit = 10;                            // a fifth of a second
  constexpr double kEvery = 2;                                  // seconds: ten edits
  Lines lines = kEdit;
  for (int i = 1; i <= kEdits; ++i) {
    const int frame = kFrom + kFramesPerEdit * i;
    const auto at = [&](int shift, const std::string& line) {
      return R"({"frame": )" + std::to_string(frame + shift) + ", " + line.substr(1);
    };
    lines.push_back(at(0, key("f")));
    lines.push_back(at(1, type("1." + std::to_string(1000 + i).substr(1))));  // millimetres
    lines.push_back(at(3, key("Enter")));
    lines.push_back(at(6, dump("edit_" + std::to_string(i) + ".json")));
  }
  int done = 0;  // edits
  play_and_kill(studio, lines, std::to_string(kEvery).c_str(), [&] {
    while (std::filesystem::exists(studio.folder() / ("edit_" + std::to_string(done + 1) + ".json"))) ++done;
    return done >= kKilledAfter;
  });
  ASSERT_EQ(radius_of_3(studio.state("edit_" + std::to_string(kKilledAfter) + ".json")["document"]["layout"]),
            (1000 + kKilledAfter) * 1e-6);
  studio.play({kIdle, press("Recover"), kIdle, dump("recovered.json")}, {"--empty", "--state-dir", "state"});
  const double radius = radius_of_3(studio.state("recovered.json")["document"]["layout"]);
  const double kept = std::round(radius * 1e6 - 1000);
  const double interval = kEvery / (0.02 * kFramesPerEdit);
  EXPECT_GE(kept, done - interval - 3) << "of " << done << " edits; writing takes a moment";
  EXPECT_LE(kept, kEdits);
}

TEST(Recovery, CanBeThrownAway) {
  const StudioProgram studio;
  edit_and_kill(studio, "state/autosave");
  const std::vector<std::string> arguments{"--empty", "--state-dir", "state"};
  studio.play({kIdle, press("Throw away"), kIdle}, arguments);
  studio.play({kIdle, dump("again.json")}, arguments);
  EXPECT_TRUE(studio.state("again.json")["recovery"].get<std::string>().empty());
}

}  // namespace
}  // namespace taxel::test
