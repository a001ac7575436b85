// The window's own file dialog: places, the table of the folder, typed paths, existing files, and files that cannot be
// opened. Esc in a modal dialog with an open list, and the run behind a modal dialog.
#include <gtest/gtest.h>

#include <filesystem>

#include "script_lines.h"

namespace taxel::test {
namespace {

const std::string kOpen = key("o", kCtrl), kTab = key("Tab"), kEnter = key("Enter"), kEsc = key("Escape");
const Lines kSomeFrames(6, kIdle);

/// Returns lines that click on the head of a column, which needs the pointer on it one frame before.
Lines sorted_by(const std::string& column) {
  const std::string head = "Sort by " + column;
  return {R"({"event": "mouse_move", "at": {"widget": ")" + head + R"("}})", kIdle, press(head), kIdle, kIdle};
}

std::vector<std::string> names_of(const Json& state) {
  std::vector<std::string> names;
  for (const Json& entry : state["file_dialog"]["entries"]) names.push_back(entry["name"]);
  return names;
}

bool has_widget(const Json& state, const std::string& label) {
  for (const Json& widget : state["widgets"])
    if (widget["label"] == label) return true;
  return false;
}

/// Makes a folder with two meshes of different sizes and two folders, one of them with a mesh.
void make_files(const StudioProgram& studio) {
  const std::string mesh = file_text(kMeshFile);
  std::filesystem::create_directories(studio.folder() / "data/parts");
  std::filesystem::create_directories(studio.folder() / "data/probes");
  write_text(studio.folder() / "data/a.obj", mesh + "# a longer file\n");
  write_text(studio.folder() / "data/b.obj", mesh);
  write_text(studio.folder() / "data/parts/tip.obj", mesh);
}

TEST(FileDialog, SortsByTheHeadOfAColumn) {
  const StudioProgram studio;
  make_files(studio);
  studio.play(joined({{kIdle, kOpen, kIdle, type("data"), kIdle, kEnter, kIdle, kIdle, dump("name.json")},
                      sorted_by("Size"),
                      {dump("size.json")},
                      sorted_by("Size"),
                      {dump("descending.json")}}),
              {"--empty"});
  const std::vector<std::string> by_name{"parts", "probes", "a.obj", "b.obj"},
      by_size{"parts", "probes", "b.obj", "a.obj"};
  const Json state = studio.state("name.json");
  EXPECT_EQ(names_of(state), by_name);
  EXPECT_EQ(state["file_dialog"]["entries"][3]["bytes"], file_text(kMeshFile).size());
  EXPECT_EQ(names_of(studio.state("size.json")), by_size);
  EXPECT_EQ(names_of(studio.state("descending.json")), by_name) << "the largest file first";
}

TEST(FileDialog, ListsAFolderAndOpensNothingInItByADoubleClick) {
  const StudioProgram studio;
  make_files(studio);
  const auto twice = [](const std::string& label) {
    return Lines{R"({"event": "double_click", "at": {"widget": ")" + label + R"("}})", kIdle, kIdle, kIdle};
  };
  studio.play(joined({{kIdle, kOpen, kIdle, type("data"), kIdle, kEnter, kIdle, kIdle},
                      twice("parts/"),
                      {dump("listed.json")},
                      twice("tip.obj"),
                      {dump("opened.json")}}),
              {"--empty"});
  const Json listed = studio.state("listed.json")["file_dialog"];
  EXPECT_TRUE(listed["open"].get<bool>()) << "the mesh that is now at the pointer is not opened";
  EXPECT_TRUE(listed["folder"].get<std::string>().ends_with("data/parts"));
  EXPECT_FALSE(studio.state("opened.json")["file_dialog"]["open"].get<bool>());
  EXPECT_NE(studio.state("opened.json")["document"].dump().find("tip.obj"), std::string::npos);
}

TEST(FileDialog, CompletesATypedPathByTab) {
  const StudioProgram studio;
  make_files(studio);
  studio.play({kIdle,
               kOpen,
               kIdle,
               type("data/p"),
               kIdle,
               kIdle,
               dump("two.json"),
               type("a"),
               kIdle,
               kIdle,
               kTab,
               kIdle,
               kIdle,
               dump("folder.json"),
               type("t"),
               kIdle,
               kIdle,
               kTab,
               kIdle,
               kIdle,
               dump("file.json"),
               kEnter,
               kIdle,
               kIdle,
               dump("open.json")},
              {"--empty"});
  EXPECT_EQ(studio.state("two.json")["file_dialog"]["completion"], "") << "parts and probes share one letter";
  EXPECT_EQ(studio.state("folder.json")["file_dialog"]["path"], "data/parts/");
  EXPECT_EQ(studio.state("file.json")["file_dialog"]["path"], "data/parts/tip.obj");
  EXPECT_EQ(studio.state("open.json")["document"]["name"], "tip");
}

TEST(FileDialog, OffersPlacesAndTheFolderOfTheOpenFile) {
  const StudioProgram studio;
  make_files(studio);
  studio.play({kIdle, kOpen, kIdle, kIdle, dump("open.json"), press("Place Folder of the open file"), kIdle, kIdle,
               dump("place.json"), press("Place Working folder"), kIdle, kIdle, dump("working.json")},
              {"data/parts/tip.obj"});
  const Json open = studio.state("open.json"), place = studio.state("place.json");
  for (const char* label : {"Place Home", "Place Working folder", "Place Examples", "Place Folder of the open file"})
    EXPECT_TRUE(has_widget(open, label)) << label;
  EXPECT_TRUE(place["file_dialog"]["folder"].get<std::string>().ends_with("data/parts"));
  EXPECT_EQ(names_of(place), std::vector<std::string>{"tip.obj"});
  EXPECT_FALSE(studio.state("working.json")["file_dialog"]["folder"].get<std::string>().ends_with("parts"));
}

TEST(FileDialog, AsksBeforeAFileIsReplaced) {
  const StudioProgram studio;
  write_text(studio.folder() / "there.taxels.json", "kept");
  const Lines name{key("a", kCtrl), type((studio.folder() / "there.taxels.json").string()), kIdle, kIdle};
  studio.play(joined({{kIdle, kLayoutMode, kIdle, key("e", kCtrl), kIdle},
                      name,
                      {kEnter, kIdle, kIdle, dump("asked.json"), press("Replace"), kIdle, kIdle, dump("done.json")}}),
              {kLayoutFile});
  const Json asked = studio.state("asked.json");
  EXPECT_TRUE(asked["file_dialog"]["open"]);
  EXPECT_NE(asked["file_dialog"]["error"].get<std::string>().find("exists"), std::string::npos);
  EXPECT_FALSE(studio.state("done.json")["file_dialog"]["open"]);
  EXPECT_NE(file_text(studio.folder() / "there.taxels.json"), "kept");
}

/// Returns our fingertip with few samples, which is quickly compiled.
std::vector<std::string> quick_fingertip(const StudioProgram& studio) {
  return sparse_fingertip(studio, 1e5);
}

/// A list of a dialog, and an entry that is displayed only while the list is open.
struct DialogList {
  const char *list, *entry;
};

class ListsOfTheFilm : public testing::TestWithParam<DialogList> {};

TEST_P(ListsOfTheFilm, CloseByEscBeforeTheDialogDoes) {
  const StudioProgram studio;
  studio.play({wait_time(0.03), key("Space"), kIdle, press("File"), kIdle, press("Export"), kIdle,
               press("Export video..."), kIdle, press(GetParam().list), kIdle, dump("list.json"), kEsc, kIdle,
               dump("dialog.json"), kEsc, kIdle, dump("closed.json")},
              quick_fingertip(studio));
  const Json list = studio.state("list.json"), dialog = studio.state("dialog.json");
  EXPECT_TRUE(has_widget(list, GetParam().entry));
  EXPECT_FALSE(has_widget(dialog, GetParam().entry));
  EXPECT_TRUE(dialog["file_dialog"]["open"]);
  EXPECT_FALSE(studio.state("closed.json")["file_dialog"]["open"]);
}

INSTANTIATE_TEST_SUITE_P(All, ListsOfTheFilm,
                         testing::Values(DialogList{"Format", "PNG frames"}, DialogList{"Size", "1920 x 1080"},
                                         DialogList{"Steps", "From ... to"}));

TEST(ModalDialog, ClosesAListOfColumnsByEscFirst) {
  const StudioProgram studio;
  write_text(studio.folder() / "real.csv", "time,t3\n0,1\n0.01,2\n0.02,3\n0.03,4\n");
  studio.play({wait_time(0.03),
               key("Space"),
               kIdle,
               press("File"),
               kIdle,
               press("Import real recording..."),
               kIdle,
               key("a", kCtrl),
               type((studio.folder() / "real.csv").string()),
               kIdle,
               key("Enter"),
               kIdle,
               kIdle,
               press("Meaning of t3"),
               kIdle,
               dump("list.json"),
               kEsc,
               kIdle,
               dump("dialog.json"),
               kEsc,
               kIdle,
               dump("closed.json")},
              quick_fingertip(studio));
  const std::size_t in_dialog = studio.state("dialog.json")["widgets"].size();
  EXPECT_GT(studio.state("list.json")["widgets"].size(), in_dialog) << "the list was open";
  EXPECT_TRUE(has_widget(studio.state("dialog.json"), "Save mapping"));
  EXPECT_FALSE(has_widget(studio.state("closed.json"), "Save mapping"));
}

TEST(ModalDialog, PausesTheRunUntilItIsClosed) {
  const StudioProgram studio;
  studio.play(joined({{wait_time(0.05), kOpen, kIdle, kIdle, kIdle, dump("open.json")},
                      kSomeFrames,
                      {dump("later.json"), kEsc},
                      kSomeFrames,
                      {dump("closed.json")}}),
              quick_fingertip(studio));
  const Json open = studio.state("open.json"), later = studio.state("later.json"), closed = studio.state("closed.json");
  EXPECT_TRUE(later["file_dialog"]["open"]);
  EXPECT_EQ(later["simulation"]["step"], open["simulation"]["step"]);
  EXPECT_FALSE(closed["file_dialog"]["open"]);
  EXPECT_TRUE(closed["simulation"]["playing"]);
  EXPECT_GT(closed["simulation"]["step"], later["simulation"]["step"]);
}

TEST(ModalDialog, LeavesAPausedRunPaused) {
  const StudioProgram studio;
  studio.play(
      joined({{wait_time(0.05), key("Space"), kIdle, kOpen, kIdle, kIdle, kEsc}, kSomeFrames, {dump("a.json")}}),
      quick_fingertip(studio));
  EXPECT_FALSE(studio.state("a.json")["simulation"]["playing"]);
}

TEST(ModalDialog, LetsAVideoOfARunBeMadeThatPlayedBefore) {
  const StudioProgram studio;
  studio.play({wait_time(0.05), press("File"), kIdle, press("Export"), kIdle, press("Export video..."), kIdle,
               press("Path"), key("a", kCtrl), type((studio.folder() / "film.webp").string()), kIdle, key("Enter"),
               kIdle, kIdle, kIdle, dump("made.json")},
              quick_fingertip(studio));
  EXPECT_TRUE(std::filesystem::exists(studio.folder() / "film.webp")) << studio.state("made.json")["messages"];
  EXPECT_FALSE(studio.state("made.json")["simulation"]["playing"]) << "making the video paused the run";
}

TEST(ModalDialog, HoldsTheLoopOfTheDemo) {
  const StudioProgram studio;
  studio.play(joined({{R"({"do": "wait_for", "pointer": "/simulation/history/replay", "equals": 1})", kOpen, kIdle,
                       kIdle, kIdle, dump("open.json")},
                      kSomeFrames,
                      {dump("later.json"), kEsc},
                      kSomeFrames,
                      {dump("closed.json")}}),
              {"--demo"});
  const Json open = studio.state("open.json")["simulation"], later = studio.state("later.json")["simulation"],
             closed = studio.state("closed.json")["simulation"];
  EXPECT_EQ(later["step"], open["step"]);
  EXPECT_GT(closed["step"], later["step"]);
  EXPECT_TRUE(closed["history"]["demo"]["runs"]);
  EXPECT_EQ(closed["history"]["replay"], 1);
}

class WrongFile : public testing::TestWithParam<DialogList> {};

TEST_P(WrongFile, IsRefusedWithTheFilesThatCanBeOpened) {
  const StudioProgram studio;
  const std::string file = GetParam().list;
  write_text(studio.folder() / file, "Bring milk.\n");
  studio.play({kIdle, kOpen, kIdle, type((studio.folder() / file).string()), kIdle, key("Enter"), kIdle, kIdle,
               dump("typed.json"), type("x"), kIdle, dump("changed.json"), kEsc, kIdle,
               R"({"event": "drop", "files": [")" + file + R"("]})", kIdle, kIdle, dump("dropped.json")},
              {"--empty"});
  const Json typed = studio.state("typed.json")["file_dialog"];
  EXPECT_TRUE(typed["open"]) << "another name can be typed";
  const std::string error = typed["error"];
  EXPECT_TRUE(error.starts_with(file + " cannot be opened: ")) << error;
  EXPECT_NE(error.find(GetParam().entry), std::string::npos) << error;
  EXPECT_EQ(studio.state("changed.json")["file_dialog"]["error"], "") << "it was about another name";
  const std::string messages = studio.state("dropped.json")["messages"].dump();
  EXPECT_NE(messages.find(file + ": cannot be opened: "), std::string::npos) << messages;
  EXPECT_NE(messages.find(GetParam().entry), std::string::npos) << messages;
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongFile,
    testing::Values(DialogList{"notes.txt", "a .txt file can hold a layout, but the text of this one is none"},
                    DialogList{"photo.png", "Edit > Generate taxels reads the dots of an image"},
                    DialogList{"a.docx", ".taxels.json, .yaml, .csv, .urdf, .npz, .txt), mesh (.obj .stl"}));

TEST(FileDialog, LeavesOutJsonFilesThatAreNoLayoutAndNamesTheOneNextToThem) {
  const StudioProgram studio;
  std::filesystem::create_directories(studio.folder() / "run");
  write_text(studio.folder() / "run/sweep.json", R"({"format": "taxel-sweep", "version": 1, "scenario": {}})");
  write_text(studio.folder() / "run/finger.taxels.json", file_text(kLayoutFile));
  const std::string file = (studio.folder() / "run/sweep.json").string();
  studio.play({kIdle, kOpen, kIdle, type("run"), kIdle, kEnter, kIdle, kIdle, dump("listed.json"), type("sweep.json"),
               kIdle, kEnter, kIdle, dump("typed.json"), key("Escape"), kIdle,
               R"({"event": "drop", "files": [")" + file + R"("]})", kIdle, dump("dropped.json")},
              {"--empty"});
  EXPECT_EQ(names_of(studio.state("listed.json")), std::vector<std::string>{"finger.taxels.json"});
  const std::string why = "is no layout: its format is \"taxel-sweep\". Open finger.taxels.json next to it";
  EXPECT_NE(studio.state("typed.json")["file_dialog"].dump().find("Open finger.taxels.json next to it"),
            std::string::npos);
  EXPECT_NE(studio.state("dropped.json")["messages"].back()["text"].get<std::string>().find(why), std::string::npos);
  const Outcome argument = studio.run({kIdle, dump("argument.json")}, {file});
  EXPECT_NE((argument.err + file_text(studio.folder() / "argument.json")).find("Open finger.taxels.json next to it"),
            std::string::npos)
      << argument.err;
}

}  // namespace
}  // namespace taxel::test
