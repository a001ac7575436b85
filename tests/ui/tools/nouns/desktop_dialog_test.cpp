// The desktop's file dialog in place of the window's: questions, replies, errors and second requests.
#include <gtest/gtest.h>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/compare/compare_state.h"
#include "app/studio/nouns/files/desktop_dialog.h"
#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/files/export.h"
#include "app/studio/nouns/files/file_dialog.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/generate/generate_state.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/real/real_commands.h"
#include "app/studio/nouns/scene/controls_state.h"
#include "app/studio/shell/interface/carry_out.h"
#include "core/mesh/formats/mesh_format.h"
#include "fixtures/temp_folder.h"

namespace taxel::ui {
namespace {

using ReplyKind = os::FileReply::Kind;

constexpr int kTasks = static_cast<int>(FileTask::save_scene) + 1;

/// Records the questions of the window. The test sets the user's reply.
class RecordedChooser final : public os::FileChooser {
 public:
  void open(const os::FileQuestion& question) override { questions.push_back(question); }
  std::optional<os::FileReply> poll() override { return std::exchange(reply, std::nullopt); }
  void close() override { ++closed; }

  std::vector<os::FileQuestion> questions;
  std::optional<os::FileReply> reply;
  int closed = 0;  ///< number of calls of close()
};

/// The parts of a window that uses the desktop's dialog. The folder of the window's dialog is /data.
struct WindowWithDesktop {
  WindowUi ui;
  FileDialog dialog;
  Messages messages;
  std::vector<FileNotice> notices;
  std::vector<std::string> geoms{"tip", "pad"};
  RecordedChooser& chooser;
  DesktopDialog desktop;

  WindowWithDesktop() : WindowWithDesktop(std::make_unique<RecordedChooser>()) {}
  explicit WindowWithDesktop(std::unique_ptr<RecordedChooser> recorded)
      : chooser(*recorded), desktop(std::move(recorded)) {
    dialog.desktop = DesktopChooser::found;
    dialog.folder = "/data";
  }

  bool update() { return desktop.update({ui, dialog, messages, notices, 1.5}, geoms); }
  /// Requests a dialog as the window does, with a proposed name.
  void request(FileTask task, const std::string& name = "") {
    begin_dialog(dialog, task);
    dialog.path = name;
    EXPECT_TRUE(update());
  }
  void reply(ReplyKind kind, const std::string& path, const std::string& problem = "") {
    chooser.reply = os::FileReply{kind, path, problem};
    EXPECT_TRUE(update());
    EXPECT_FALSE(desktop.is_open());
  }
  /// Requests a file and chooses a path. Returns the command, which has to be of this kind.
  template <class Kind>
  Kind chosen(FileTask task, const std::string& path) {
    request(task);
    reply(ReplyKind::chosen, path);
    return *ui.commands.back().get_if<Kind>();
  }
};

TEST(DesktopTask, LeavesPicturesAndVideosToTheWindowsDialog) {
  for (int i = 0; i < kTasks; ++i) {
    const auto task = static_cast<FileTask>(i);
    const bool has_options = task == FileTask::export_picture || task == FileTask::export_video;
    EXPECT_EQ(desktop_task(task).has_value(), !has_options) << i;
  }
}

TEST(DesktopTask, HasTheTitleFolderAndNameOfTheWindowsDialog) {
  for (int i = 0; i < kTasks; ++i) {
    FileDialog dialog;
    dialog.task = static_cast<FileTask>(i);
    dialog.folder = "/data", dialog.path = "hand.part";
    const std::optional<DesktopTask> task = desktop_task(dialog.task);
    if (!task) continue;
    const os::FileQuestion question = desktop_question(dialog);
    EXPECT_EQ(question.title, row_of(dialog.task).title);
    EXPECT_EQ(question.start, task->saves ? "/data/hand.part" : "/data/") << question.title;
    ASSERT_EQ(question.filters.size(), 2U) << question.title;
    EXPECT_EQ(question.filters[1].name, "All files");
    EXPECT_EQ(question.filters[1].patterns, "*");
    const std::string extension = row_of(dialog.task).extension;
    EXPECT_NE((question.filters[0].patterns + " ").find("*" + extension), std::string::npos) << question.title;
  }
}

TEST(DesktopTask, ListsTheFilesOfItsTask) {
  const std::string layouts =
      "*.taxels.json *.TAXELS.JSON *.json *.JSON *.csv *.CSV *.yaml *.YAML *.yml *.YML *.txt *.TXT *.probes.json "
      "*.PROBES.JSON *.npz *.NPZ *.xml *.XML *.mjcf *.MJCF *.sites.xml *.SITES.XML *.urdf *.URDF *.xacro *.XACRO";
  const std::vector<std::tuple<FileTask, bool, std::string>> tasks{
      {FileTask::save_project, true, "*.taxelproj *.TAXELPROJ"},
      {FileTask::export_layout, true, layouts},
      {FileTask::export_taxels, true, "*.csv *.CSV"},
      {FileTask::export_samples, true, "*.csv *.CSV"},
      {FileTask::export_comparison, true, "*.csv *.CSV"},
      {FileTask::export_fits, true, "*.csv *.CSV"},
      {FileTask::export_sheet, true, "*.html *.HTML"},
      {FileTask::export_plot, true, "*.svg *.SVG *.pdf *.PDF"},
      {FileTask::export_frame, true, "*.taxelframe *.TAXELFRAME"},
      {FileTask::export_recording, true, "*.csv *.CSV *.npz *.NPZ *.jsonl *.JSONL"},
      {FileTask::keep_recording, true, "*.csv *.CSV *.npz *.NPZ *.jsonl *.JSONL"},
      {FileTask::save_scene, true, "*.xml *.XML"},
      {FileTask::import_recording, false, "*.csv *.CSV *.txt *.TXT *.tsv *.TSV"},
      {FileTask::attach_layout, false, layouts},
      {FileTask::compare_layout, false, layouts},
      {FileTask::read_points, false, "*.csv *.CSV *.txt *.TXT *.tsv *.TSV *.png *.PNG *.jpg *.JPG *.jpeg *.JPEG"}};
  for (const auto& [task, saves, patterns] : tasks) {
    EXPECT_EQ(desktop_task(task).value().saves, saves) << patterns;
    EXPECT_EQ(desktop_task(task).value().filter.patterns, patterns);
  }
  const DesktopTask open = desktop_task(FileTask::open).value();
  EXPECT_FALSE(open.saves);
  for (const char* pattern :
       {"*.taxelproj", "*.taxels.json", "*.yaml", "*.xml", "*.taxelframe", "*batch.json", "*.stl", "*.STL"})
    EXPECT_NE((open.filter.patterns + " ").find(std::string(pattern) + " "), std::string::npos) << pattern;
  for (const MeshFormat& format : kMeshFormats)
    EXPECT_NE(open.filter.patterns.find(format.extension), std::string::npos) << format.name;
}

TEST(BeginDialog, RequestsTheDesktopsDialogIfItIsUsed) {
  FileDialog dialog;
  begin_dialog(dialog, FileTask::open);
  EXPECT_TRUE(dialog.open && !dialog.waits_for_desktop) << "a script";
  dialog = {};
  dialog.desktop = DesktopChooser::found;
  begin_dialog(dialog, FileTask::open);
  EXPECT_TRUE(!dialog.open && dialog.waits_for_desktop);
  begin_own_dialog(dialog, FileTask::open);
  EXPECT_TRUE(dialog.open && !dialog.waits_for_desktop) << "in place of the request";
  dialog.open = false;
  begin_dialog(dialog, FileTask::export_picture);
  EXPECT_TRUE(dialog.open && !dialog.waits_for_desktop) << "a picture has a size";
  dialog.open = dialog.prefers_desktop = false;
  begin_dialog(dialog, FileTask::open);
  EXPECT_TRUE(dialog.open && !dialog.waits_for_desktop) << "switched off";
}

TEST(DesktopDialog, OpensOnRequestAndWaitsForTheReply) {
  WindowWithDesktop window;
  EXPECT_FALSE(window.update());
  EXPECT_TRUE(window.chooser.questions.empty());
  window.request(FileTask::save_project, "hand.taxelproj");
  ASSERT_EQ(window.chooser.questions.size(), 1U);
  EXPECT_EQ(window.chooser.questions[0].title, "Save the project");
  EXPECT_EQ(window.chooser.questions[0].start, "/data/hand.taxelproj");
  EXPECT_TRUE(window.desktop.is_open());
  EXPECT_FALSE(window.update()) << "the window rests";
  EXPECT_FALSE(window.dialog.open || window.dialog.waits_for_desktop);
  EXPECT_TRUE(window.ui.commands.empty() && window.messages.empty());
}

TEST(DesktopDialog, PostsTheCommandOfTheChosenFile) {
  WindowWithDesktop window;
  EXPECT_EQ(window.chosen<OpenFile>(FileTask::open, "/a/hand.stl").path, "/a/hand.stl");
  EXPECT_EQ(window.dialog.folder, "/a") << "the next dialog begins here";
  EXPECT_EQ(window.chosen<ReadPoints>(FileTask::read_points, "/a/dots.csv").path, "/a/dots.csv");
  EXPECT_EQ(window.chosen<ReadRealRecording>(FileTask::import_recording, "/a/run.csv").path, "/a/run.csv");
  EXPECT_EQ(window.chosen<CompareLayout>(FileTask::compare_layout, "/a/b.taxels.json").path, "/a/b.taxels.json");
  EXPECT_EQ(window.chosen<SaveScene>(FileTask::save_scene, "/a/hand.xml").path, "/a/hand.xml");
  const auto plot = window.chosen<ExportFile>(FileTask::export_plot, "/a/plot.pdf");
  EXPECT_EQ(plot.task, FileTask::export_plot);
  EXPECT_EQ(plot.path, "/a/plot.pdf");
}

TEST(DesktopDialog, AttachesALayoutToTheGeomsOfTheRequest) {
  WindowWithDesktop window;
  window.request(FileTask::attach_layout);
  window.geoms = {"palm"};
  window.reply(ReplyKind::chosen, "/a/tip.taxels.json");
  EXPECT_EQ(window.ui.commands.back().get_if<AttachLayout>()->geoms, (std::vector<std::string>{"tip", "pad"}));
}

TEST(DesktopDialog, ReplacesOnlyTheFileThatTheDesktopAskedAbout) {
  WindowWithDesktop window;
  const auto saved = window.chosen<SaveProject>(FileTask::save_project, "/a/hand.taxelproj");
  EXPECT_EQ(saved.path, "/a/hand.taxelproj");
  EXPECT_TRUE(saved.replace);
  const auto extended = window.chosen<SaveProject>(FileTask::save_project, "/a/hand");
  EXPECT_EQ(extended.path, "/a/hand.taxelproj");
  EXPECT_FALSE(extended.replace) << "the desktop asked about another file";
}

TEST(DesktopDialog, ReplacesNoFolderAndNoFileOfAnotherProgram) {
  const taxel::test::TempFolder folder;
  WindowWithDesktop window;
  EXPECT_FALSE(window.chosen<ExportFile>(FileTask::export_recording, folder.path().string()).replace);
  const std::string file = folder.write("hand.taxelproj", "{}").string();
  EXPECT_TRUE(window.chosen<SaveProject>(FileTask::save_project, file).replace);
  window.notices.push_back({file, "was changed", {}});
  EXPECT_FALSE(window.chosen<SaveProject>(FileTask::save_project, file).replace);
}

TEST(DesktopDialog, EndsWithoutAFileByCancel) {
  WindowWithDesktop window;
  window.request(FileTask::save_project);
  window.reply(ReplyKind::cancelled, "");
  ASSERT_EQ(window.ui.commands.size(), 1U);
  EXPECT_TRUE(window.ui.commands[0].is<DialogClosed>());
  EXPECT_TRUE(window.messages.empty());
  EXPECT_FALSE(window.dialog.open);
}

TEST(DesktopDialog, GivesWayToTheWindowsDialogAfterAnError) {
  WindowWithDesktop window;
  window.request(FileTask::export_plot, "hand.svg");
  window.reply(ReplyKind::failed, "", "exit status 255");
  EXPECT_TRUE(window.dialog.open && window.dialog.wants_focus);
  EXPECT_EQ(window.dialog.task, FileTask::export_plot);
  EXPECT_EQ(window.dialog.path, "hand.svg");
  EXPECT_EQ(window.ui.commands.back().get_if<ListFolder>()->path, "/data");
  ASSERT_EQ(window.messages.size(), 1U);
  EXPECT_EQ(window.messages[0].severity, Severity::warning);
  EXPECT_NE(window.messages[0].text.find("exit status 255"), std::string::npos) << window.messages[0].text;
}

TEST(DesktopDialog, KeepsTheFirstOfTwoRequests) {
  WindowWithDesktop window;
  window.request(FileTask::save_project, "hand.taxelproj");
  window.request(FileTask::open);
  EXPECT_EQ(window.chooser.questions.size(), 1U);
  ASSERT_EQ(window.messages.size(), 1U);
  EXPECT_NE(window.messages[0].text.find("Save the project"), std::string::npos) << window.messages[0].text;
  EXPECT_TRUE(window.ui.commands.empty());
  window.reply(ReplyKind::chosen, "/a/hand.taxelproj");
  EXPECT_EQ(window.ui.commands.back().get_if<SaveProject>()->path, "/a/hand.taxelproj");
}

TEST(DesktopDialog, DropsTheWaitingCommandIfItCannotAskWhereToSave) {
  WindowWithDesktop window;
  window.request(FileTask::open);
  window.request(FileTask::save_project);
  ASSERT_EQ(window.ui.commands.size(), 1U);
  EXPECT_TRUE(window.ui.commands[0].is<DialogClosed>());
}

TEST(DesktopDialog, IsClosedWithItsDocumentUnlessItOpensOne) {
  WindowWithDesktop window;
  window.request(FileTask::open);
  window.desktop.leave_document();
  EXPECT_TRUE(window.desktop.is_open());
  EXPECT_EQ(window.chooser.closed, 0);
  window.reply(ReplyKind::cancelled, "");
  window.request(FileTask::export_layout);
  window.desktop.leave_document();
  EXPECT_FALSE(window.desktop.is_open());
  EXPECT_EQ(window.chooser.closed, 1);
}

TEST(ToggleDesktopDialog, IsDisabledWithItsReason) {
  App app;
  const Binding& row = binding_of(ToggleDesktopDialog{});
  EXPECT_STREQ(row.menu, "File");
  EXPECT_FALSE(is_enabled(row, app) || is_checked(row, app));
  EXPECT_NE(why_disabled(row, app), "");
  app.get<FileDialog>().desktop = DesktopChooser::missing;
  EXPECT_FALSE(is_enabled(row, app) || is_checked(row, app));
  EXPECT_EQ(why_disabled(row, app), "No desktop file dialog found: install zenity or kdialog");
  EXPECT_EQ(why_disabled(binding_of(UndoStep{}), app), "There is no edit to undo");
}

TEST(ToggleDesktopDialog, IsOnWhereThereIsOne) {
  App app;
  app.get<FileDialog>().desktop = DesktopChooser::found;
  const Binding& row = binding_of(ToggleDesktopDialog{});
  EXPECT_TRUE(is_enabled(row, app) && is_checked(row, app));
  EXPECT_EQ(why_disabled(row, app), "");
  carry_out_if_enabled(row, app);
  EXPECT_FALSE(is_checked(row, app) || uses_desktop(app.get<FileDialog>()));
  carry_out_if_enabled(row, app);
  EXPECT_TRUE(uses_desktop(app.get<FileDialog>()));
}

}  // namespace
}  // namespace taxel::ui
