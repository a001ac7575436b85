// The system around the window: full disks, read-only folders, no home, decimal commas, file names that are not UTF-8,
// irregular files, a clock that is set back.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "script_lines.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

/// Sets the radius of all taxels to 3.5 mm, typed with a decimal point.
const Lines kEditAll{kIdle, kLayoutMode, kIdle, key("a"),     kIdle, key("f"),
                     kIdle, type("3.5"), kIdle, key("Enter"), kIdle};

class WindowSurroundings : public testing::Test {
 protected:
  /// Plays the lines in a shell command that begins with `before`, offscreen.
  Outcome play_after(const std::string& before, const Lines& lines,
                     const std::string& arguments = "--state-dir state " + kLayoutFile) const {
    std::string script;
    for (const std::string& line : lines) script += line + "\n";
    write_text(folder() / "s.jsonl", script);
    return run_program("/bin/sh", {"-c", before + STUDIO_PROGRAM " --headless --script s.jsonl " + arguments},
                       folder());
  }
  [[nodiscard]] const fs::path& folder() const { return studio_.folder(); }
  [[nodiscard]] std::string messages(const std::string& state) const { return studio_.state(state)["messages"].dump(); }

  StudioProgram studio_;
};

std::string says(const std::string& text) {
  return R"({"do": "wait_for", "pointer": "/messages", "contains": ")" + text + R"("})";
}

TEST_F(WindowSurroundings, NameAFileThatDoesNotFitAndKeepTheEdit) {
  fs::copy_file(kLayoutFile, folder() / "f.taxels.json");
  fs::create_directories(folder() / "meshes");
  // A limit of 1 kB for each file, in place of a full disk.
  const std::string before = file_text(folder() / "f.taxels.json");
  const Outcome outcome = play_after("trap '' XFSZ; ulimit -f 2; exec ",
                                     joined({kEditAll,
                                             {says("Edits are not kept: "), key("e", kCtrl), kIdle, key("a", kCtrl),
                                              type((folder() / "out.taxels.json").string()), kIdle, key("Enter"), kIdle,
                                              says("out.taxels.json: writing failed: File too large"),
                                              R"({"do": "wait_for", "pointer": "/history/dirty", "equals": true})"}}),
                                     "--autosave-every 0.02 --state-dir state " + kLayoutFile);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err.find(".part"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(folder() / "out.taxels.json"));
  for (const auto& entry : fs::recursive_directory_iterator(folder()))
    EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
  EXPECT_EQ(file_text(folder() / "f.taxels.json"), before);
}

TEST_F(WindowSurroundings, ReportAReadOnlyFolderAndKeepTheEdit) {
  fs::create_directories(folder() / "state");
  fs::permissions(folder() / "state", fs::perms::owner_read | fs::perms::owner_exec);
  // Root may write everywhere, but not without this capability.
  const Outcome outcome = play_after(::geteuid() == 0 ? "exec setpriv --bounding-set -dac_override " : "exec ",
                                     joined({kEditAll, {says("Permission denied"), dump("edited.json")}}));
  fs::permissions(folder() / "state", fs::perms::owner_all);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST_F(WindowSurroundings, MayLackAHomeAndAnEnvironment) {
  const Outcome outcome =
      play_after("exec env -i sh -c 'exec ", joined({kEditAll, {dump("edited.json")}}), kLayoutFile + "'");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(taxel_of(studio_.state("edited.json")["document"]["layout"], 3)["radius"], 0.0035);
}

TEST_F(WindowSurroundings, GiveTheSameNumbersWithDecimalCommas) {
  ASSERT_EQ(run_program("/usr/bin/localedef", {"-i", "de_DE", "-f", "UTF-8", "./de_DE.UTF-8"}, folder()).status, 0);
  const auto exported = [&](const std::string& before, const std::string& file) {
    const Outcome outcome =
        play_after(before + "exec ", joined({kEditAll,
                                             {key("e", kCtrl), kIdle, key("a", kCtrl), type((folder() / file).string()),
                                              kIdle, key("Enter"), kIdle}}));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return file_text(folder() / file);
  };
  const std::string point = exported("export LC_ALL=C; ", "point.taxels.json");
  EXPECT_EQ(exported("export LOCPATH=" + folder().string() + " LC_ALL=de_DE.UTF-8; ", "comma.taxels.json"), point);
  EXPECT_NE(point.find("0.0035"), std::string::npos);
}

TEST_F(WindowSurroundings, MayHaveFileNamesThatAreNotUnicode) {
  const fs::path odd = folder() / "d\xe9t\xe9";
  fs::create_directories(odd);
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"]["file"] = "f.obj";
  fs::copy_file(TAXEL_SOURCE_DIR "/assets/meshes/fingertip.obj", odd / "f.obj");
  write_text(odd / "f.taxels.json", layout.dump());
  const std::string arguments = "--state-dir '" + (odd / "state").string() + "' ";
  EXPECT_EQ(play_after("exec ", joined({kEditAll, {key("s", kCtrl), kIdle, dump("saved.json")}}),
                       arguments + "'" + (odd / "f.taxels.json").string() + "'")
                .status,
            0);
  EXPECT_EQ(studio_.state("saved.json")["document"]["layout"]["taxels"].size(), 12U);
  EXPECT_TRUE(fs::exists(odd / "state/settings.json"));
  EXPECT_EQ(play_after("exec ", {kIdle, dump("next.json")}, arguments + "--empty").status, 0)
      << "settings can be read again";
  EXPECT_EQ(studio_.state("next.json")["messages"].size(), 0U);
}

TEST_F(WindowSurroundings, ReportAndSetAsideSettingsThatAreNoFile) {
  const fs::path state = folder() / "state";
  fs::create_directories(state);
  ASSERT_EQ(::mkfifo((state / "settings.json").c_str(), 0600), 0);
  ASSERT_EQ(::mkfifo((state / "arrangement-simulate.ini").c_str(), 0600), 0);
  EXPECT_EQ(play_after("exec ", {kIdle, dump("pipe.json")}).status, 0);
  EXPECT_NE(messages("pipe.json").find("settings.json: is not a regular file"), std::string::npos)
      << messages("pipe.json");
  EXPECT_NE(messages("pipe.json").find("arrangement-simulate.ini: is not a regular file"), std::string::npos);
  EXPECT_TRUE(fs::is_fifo(state / "settings.json.broken"));
  EXPECT_TRUE(fs::is_regular_file(state / "settings.json"));
  write_text(state / "settings.json", R"({"dark": false, "scale": [], "wireframe": true})");
  EXPECT_EQ(play_after("exec ", {kIdle, dump("wrong.json")}).status, 0);
  EXPECT_NE(messages("wrong.json").find("/scale: has a value that it cannot have"), std::string::npos);
  EXPECT_TRUE(studio_.state("wrong.json")["overlays"]["wireframe"]) << "the others are kept";
  EXPECT_NE(file_text(state / "settings.json.broken").find("[]"), std::string::npos);
}

// The clock is set back between the edit and its autosave. The edit is saved in time, and the next start offers it.
TEST_F(WindowSurroundings, StopNothingIfTheClockIsSetBack) {
  play_after(
      // AddressSanitizer accepts no library before itself, unless its check is off.
      "export ASAN_OPTIONS=\"$ASAN_OPTIONS:verify_asan_link_order=0\" LD_PRELOAD=" CLOCK_SET_BACK "; exec ",
      joined({kEditAll, {dump("edited.json"), R"({"do": "rest", "seconds": 600})"}}),
      "--live --autosave-every 2 --state-dir state " + kLayoutFile +
          " & for i in $(seq 1500); do ls state/autosave/*.taxelproj && break; sleep 0.1; done; kill -9 $!; wait $!");
  ASSERT_TRUE(fs::exists(folder() / "edited.json"));
  ASSERT_EQ(
      play_after("exec ", {kIdle, press("Recover"), kIdle, dump("recovered.json")}, "--empty --state-dir state").status,
      0);
  EXPECT_EQ(taxel_of(studio_.state("recovered.json")["document"]["layout"], 3)["radius"], 0.0035);
}

}  // namespace
}  // namespace taxel::test
