// The file dialog: paths, extensions, and the command for a file.
#include <gtest/gtest.h>

#include "app/studio/nouns/files/desktop_dialog.h"
#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/files/export.h"
#include "app/studio/nouns/files/file_dialog.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/generate/generate_state.h"
#include "app/studio/nouns/real/real_commands.h"
#include "app/studio/nouns/scene/controls_state.h"

namespace taxel::ui {
namespace {

/// The command of a task for a path; it has to be of this kind.
template <class Kind>
Kind command_for(FileTask task, const std::string& path, const std::string& exists = "") {
  FileDialog dialog;
  dialog.task = task;
  dialog.exists = exists;
  return *file_command(dialog, {"tip", "pad"}, path).get_if<Kind>();
}

TEST(BeginDialog, EmptiesTheFieldsAndKeepsTheFolder) {
  FileDialog dialog;
  dialog.folder = "/data", dialog.path = "old", dialog.filter = "ol", dialog.exists = "/data/old";
  begin_dialog(dialog, FileTask::save_scene);
  EXPECT_EQ(dialog.task, FileTask::save_scene);
  EXPECT_TRUE(dialog.open && dialog.wants_focus);
  EXPECT_EQ(dialog.folder, "/data");
  EXPECT_TRUE(dialog.path.empty() && dialog.filter.empty() && dialog.exists.empty());
}

TEST(PathIn, SeparatesFolderAndNameOnce) {
  EXPECT_EQ(path_in("/data", "a.csv"), "/data/a.csv");
  EXPECT_EQ(path_in("/", "a.csv"), "/a.csv");
  EXPECT_EQ(path_in("", "a.csv"), "a.csv");
}

TEST(ParentOf, EndsAtTheRoot) {
  EXPECT_EQ(parent_of("/home/data"), "/home");
  EXPECT_EQ(parent_of("/home/data/"), "/home") << "with a slash at the end";
  EXPECT_EQ(parent_of("/home"), "/");
  EXPECT_EQ(parent_of("/"), "/");
}

TEST(FileCommand, OpensAndReadsPathsAsTheyAre) {
  EXPECT_EQ(command_for<OpenFile>(FileTask::open, "/a/hand").path, "/a/hand");
  EXPECT_EQ(command_for<ReadPoints>(FileTask::read_points, "/a/dots").path, "/a/dots");
  EXPECT_EQ(command_for<ReadRealRecording>(FileTask::import_recording, "/a/run").path, "/a/run");
}

TEST(FileCommand, AttachesALayoutToTheChosenGeoms) {
  const AttachLayout command = command_for<AttachLayout>(FileTask::attach_layout, "/a/tip.taxels.json");
  EXPECT_EQ(command.geoms, (std::vector<std::string>{"tip", "pad"}));
  EXPECT_EQ(command.path, "/a/tip.taxels.json");
}

TEST(FileCommand, AddsTheExtensionOfTheTask) {
  EXPECT_EQ(command_for<SaveProject>(FileTask::save_project, "/a/hand").path, "/a/hand.taxelproj");
  EXPECT_EQ(command_for<SaveScene>(FileTask::save_scene, "/a/hand.xml").path, "/a/hand.xml");
  EXPECT_EQ(command_for<ExportFile>(FileTask::export_picture, "/a/hand.csv").path, "/a/hand.csv.png");
  EXPECT_EQ(command_for<ExportFile>(FileTask::export_video, "/a/frames").path, "/a/frames") << "a folder of images";
}

TEST(FileCommand, KeepsEveryFormatThatALayoutIsWrittenIn) {
  const auto path_of = [](const std::string& path) {
    return command_for<ExportFile>(FileTask::export_layout, path).path;
  };
  EXPECT_EQ(path_of("/a/tip"), "/a/tip.taxels.json");
  EXPECT_EQ(path_of("/a/tip.csv"), "/a/tip.csv");
  EXPECT_EQ(path_of("/a/tip.yaml"), "/a/tip.yaml");
  EXPECT_EQ(path_of("/a/tip.pdf"), "/a/tip.pdf.taxels.json") << "no format of layouts";
}

TEST(FileCommand, ReplacesOnlyTheFileThatTheUserWasAskedAbout) {
  EXPECT_FALSE(command_for<SaveProject>(FileTask::save_project, "/a/hand").replace);
  EXPECT_TRUE(command_for<SaveProject>(FileTask::save_project, "/a/hand", "/a/hand.taxelproj").replace);
  EXPECT_FALSE(command_for<SaveProject>(FileTask::save_project, "/a/arm", "/a/hand.taxelproj").replace);
}

TEST(FileCommand, PassesTheSizeOfAnImageOn) {
  FileDialog dialog;
  dialog.task = FileTask::export_picture;
  dialog.width = 640, dialog.height = 480;
  const auto command = *file_command(dialog, {}, "/a/view.png").get_if<ExportFile>();
  EXPECT_EQ(command.width, 640);
  EXPECT_EQ(command.height, 480);
}

}  // namespace
}  // namespace taxel::ui
