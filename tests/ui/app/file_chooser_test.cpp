// The desktop's file dialog, with a shell script as the program that displays it.
#include "core/base/os/file_chooser.h"

#include <gtest/gtest.h>

#include <chrono>

#include "core/base/os/process.h"
#include "fixtures/fake_zenity.h"
#include "fixtures/surroundings.h"
#include "fixtures/temp_folder.h"

namespace taxel::os {
namespace {

using Kind = FileReply::Kind;

/// A dialog of a shell script. KDE's choice between several programs is left out.
struct ScriptedDialog {
  test::TempFolder folder;
  test::Surroundings surroundings;
  std::unique_ptr<FileChooser> chooser = make_file_chooser();

  explicit ScriptedDialog(const std::string& lines)
      : surroundings({{"PATH", test::path_with_zenity(folder.path(), lines)}, {"XDG_SESSION_DESKTOP", "gnome"}}) {}

  /// Returns the reply, for which it waits a minute at most.
  FileReply ask(const FileQuestion& question) {
    chooser->open(question);
    std::optional<FileReply> reply;
    const auto began = std::chrono::steady_clock::now();
    while (!reply && std::chrono::steady_clock::now() - began < std::chrono::minutes(1)) reply = chooser->poll();
    EXPECT_FALSE(chooser->poll()) << "a reply is returned once";
    return reply.value();
  }
};

FileReply reply_to(const std::string& lines) {
  return ScriptedDialog(lines).ask({false, "Open", "/data/", {}});
}

TEST(FileChooser, ReturnsThePathThatTheProgramPrints) {
  const FileReply reply = reply_to("echo '/data/my hand.taxelproj'");
  EXPECT_EQ(reply.kind, Kind::chosen);
  EXPECT_EQ(reply.path, "/data/my hand.taxelproj");
  EXPECT_EQ(reply_to("echo /data/steps/").path, "/data/steps") << "a folder, without its last slash";
  EXPECT_EQ(reply_to("printf /data/a").path, "/data/a") << "without the end of the line";
}

TEST(FileChooser, ReportsCancelByStatusOne) {
  EXPECT_EQ(reply_to("exit 1").kind, Kind::cancelled);
}

TEST(FileChooser, FailsByAnotherStatusOrWithoutAPath) {
  const auto problem_of = [](const std::string& lines) {
    const FileReply reply = reply_to(lines);
    EXPECT_EQ(reply.kind, Kind::failed) << lines;
    return reply.problem;
  };
  EXPECT_EQ(problem_of("exit 255"), "exit status 255");
  EXPECT_EQ(problem_of("echo /data/a; exit 5"), "exit status 5");
  EXPECT_EQ(problem_of("exit 0"), "no path was returned");
  EXPECT_EQ(problem_of("echo a.taxelproj"), "no path was returned") << "a relative path";
  EXPECT_EQ(problem_of("kill -9 $$"), "no path was returned");
}

TEST(FileChooser, PassesTheQuestionOn) {
  ScriptedDialog dialog(R"(printf '%s\n' "$@" > "$0.arguments"; exit 1)");
  const auto arguments_of = [&](const FileQuestion& question) {
    EXPECT_EQ(dialog.ask(question).kind, Kind::cancelled);
    return test::file_text(dialog.folder.path() / "programs" / "zenity.arguments");
  };
  const std::string saves =
      arguments_of({true, "Save it", "/data/my hand.csv", {{"Tables", "*.csv *.CSV"}, {"All files", "*"}}});
  for (const char* line :
       {"--file-selection\n", "--filename=/data/my hand.csv\n", "--title\nSave it\n",
        "--file-filter\nTables|*.csv *.CSV\n--file-filter\nAll files|*\n", "--save\n", "--confirm-overwrite\n"})
    EXPECT_NE(saves.find(line), std::string::npos) << line << saves;
  const std::string opens = arguments_of({false, "Open it", "/data/", {}});
  EXPECT_NE(opens.find("--filename=/data/\n"), std::string::npos) << opens;
  EXPECT_EQ(opens.find("--save\n"), std::string::npos) << opens;
}

TEST(FileChooser, EndsTheProgramWhenClosed) {
  ScriptedDialog dialog(R"(echo $$ > "$0.id"; exec sleep 600)");
  dialog.chooser->open({false, "Open", "/data/", {}});
  const std::filesystem::path file = dialog.folder.path() / "programs" / "zenity.id";
  std::string id;
  const auto began = std::chrono::steady_clock::now();
  while (!id.ends_with('\n') && std::chrono::steady_clock::now() - began < std::chrono::minutes(1)) {
    EXPECT_FALSE(dialog.chooser->poll());
    if (std::filesystem::exists(file)) id = test::file_text(file);
  }
  ASSERT_TRUE(has_process(std::stoi(id)));
  dialog.chooser->close();
  EXPECT_FALSE(has_process(std::stoi(id)));
  EXPECT_FALSE(dialog.chooser->poll()) << "no reply";
  dialog.chooser->close();
}

TEST(FileChooser, IsFoundIfPathHasItsProgram) {
  const test::TempFolder folder;
  test::path_with_zenity(folder.path(), "exit 1");
  const std::filesystem::path programs = folder.path() / "programs";
  const auto is_found_in = [](const std::string& path) {
    const test::Surroundings surroundings({{"PATH", path}});
    return has_file_chooser();
  };
  EXPECT_TRUE(is_found_in("/nowhere:" + programs.string()));
  EXPECT_FALSE(is_found_in(folder.path().string()));
  EXPECT_FALSE(is_found_in(""));
  std::filesystem::permissions(programs / "zenity", std::filesystem::perms::owner_read);
  EXPECT_FALSE(is_found_in(programs.string())) << "a file that is no program";
  std::filesystem::rename(programs / "zenity", programs / "kdialog");
  std::filesystem::permissions(programs / "kdialog", std::filesystem::perms::owner_all);
  EXPECT_TRUE(is_found_in(programs.string()));
}

}  // namespace
}  // namespace taxel::os
