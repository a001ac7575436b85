// New layouts and the example files: their contents, unsaved edits before them, and folders that cannot be written.
#include <gtest/gtest.h>

#include "app/studio/nouns/files/document_commands.h"
#include "script_lines.h"

namespace taxel::test {
namespace {

const Lines kNew{key("n", kCtrl), kIdle};
const Lines kEdit{kLayoutMode, kIdle, click(taxel(3)), kIdle, key("Delete"), kIdle};
const Lines kExamples{press("File"), kIdle, press("Examples"), kIdle};
const Lines kOpenExamples = joined({kExamples, {press("Files of the examples..."), kIdle}});

TEST(NewLayout, HasNoTaxelsAndIsSavedAsUntitled) {
  const StudioProgram studio;
  studio.play(joined({kNew,
                      {dump("new.json"), R"({"do": "screenshot", "file": "new.png"})", click(in_view(0.5, 0.5), kCtrl),
                       kIdle, dump("placed.json"), key("s", kCtrl), kIdle, dump("asks.json"), key("Enter"), kIdle,
                       dump("saved.json")}}),
              {"--empty"});
  const Json fresh = studio.state("new.json");
  EXPECT_EQ(fresh["mode"], "layout");
  EXPECT_EQ(fresh["title"], "Untitled - Taxel Studio");
  EXPECT_EQ(fresh["document"]["file"], "");
  EXPECT_EQ(fresh["document"]["layout"]["taxels"], Json::array());
  EXPECT_EQ(fresh["document"]["layout"]["readout"]["method"], "exact");
  EXPECT_TRUE(fresh["document"]["mesh"]["closed"]);
  EXPECT_FALSE(fresh["history"]["dirty"]);
  EXPECT_TRUE(fresh["simulation"].is_null());
  const Json placed = studio.state("placed.json");
  EXPECT_EQ(placed["document"]["layout"]["taxels"].size(), 1U);
  EXPECT_TRUE(placed["history"]["dirty"]);
  const Json saved = studio.state("saved.json");
  EXPECT_FALSE(saved["history"]["dirty"]);
  EXPECT_EQ(saved["document"]["file"], (studio.folder() / "Untitled.taxelproj").string());
  EXPECT_TRUE(std::filesystem::exists(studio.folder() / "Untitled.taxelproj"));
  EXPECT_TRUE(std::filesystem::exists(studio.folder() / "fingertip.obj")) << "the mesh is next to the project";
}

TEST(NewLayout, AsksBeforeUnsavedEditsAreLost) {
  const StudioProgram studio;
  studio.play(joined({kEdit,
                      kNew,
                      {dump("asks.json"), press("Cancel"), kIdle, dump("cancelled.json")},
                      kNew,
                      {press("Discard"), kIdle, dump("discarded.json")}}),
              {kLayoutFile});
  const auto taxels = [&](const char* file) { return studio.state(file)["document"]["layout"]["taxels"].size(); };
  EXPECT_NE(studio.state("asks.json")["widgets"].dump().find("Discard"), std::string::npos);
  EXPECT_EQ(taxels("cancelled.json"), 11U);
  EXPECT_EQ(taxels("discarded.json"), 0U);
  EXPECT_FALSE(studio.state("discarded.json")["history"]["dirty"]);
}

TEST(NewLayout, SaysThatTaxelsAreMissingForARun) {
  const StudioProgram studio;
  studio.play(joined({kNew, {key("Space"), kIdle, dump("state.json")}}), {"--empty"});
  EXPECT_NE(studio.state("state.json")["messages"].dump().find("the layout has no taxels"), std::string::npos);
  EXPECT_EQ(studio.state("state.json")["mode"], "layout");
}

TEST(Examples, AreTheSameInTheMenusFileAndHelp) {
  const StudioProgram studio;
  studio.play(
      joined({kExamples, {dump("file.json"), press("iCub fingertip, 12 taxels"), kIdle, kIdle, dump("opened.json")}}),
      {"--empty"});
  studio.play({press("Help"), kIdle, press("Examples"), kIdle, dump("help.json")}, {"--empty"});
  const auto entries = [](const Json& state) {
    std::vector<std::string> labels;
    for (const Json& widget : state["widgets"])
      if (labels.empty() ? widget["label"] == "Fingertip sweep" : labels.back() != "Files of the examples...")
        labels.push_back(widget["label"]);
    return labels;
  };
  const std::vector<std::string> in_file = entries(studio.state("file.json"));
  EXPECT_GT(in_file.size(), 5U);
  EXPECT_EQ(in_file, entries(studio.state("help.json")));
  EXPECT_TRUE(studio.state("opened.json")["title"].get<std::string>().starts_with("iCub fingertip, 12 taxels"));
}

TEST(Examples, OpenFromTheDialogWhereverTheProgramIs) {
  const StudioProgram studio;
  const std::filesystem::path folder = studio.folder() / "state/examples";
  studio.play(
      joined({kOpenExamples,
              {dump("dialog.json"), R"({"do": "screenshot", "file": "dialog.png"})", press("layouts/"), kIdle,
               press("Path"), kIdle, type("fingertip.taxels.json"), kIdle, key("Enter"), kIdle, dump("layout.json")}}),
      {"--state-dir", "state", "--empty"});
  EXPECT_NE(studio.state("dialog.json")["widgets"].dump().find("scenes/"), std::string::npos);
  const Json layout = studio.state("layout.json");
  EXPECT_EQ(layout["document"]["file"], (folder / "layouts/fingertip.taxels.json").string());
  EXPECT_EQ(layout["document"]["layout"]["taxels"].size(), 12U);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    ++files;
    const std::filesystem::path source = TAXEL_SOURCE_DIR "/assets" / entry.path().lexically_relative(folder);
    EXPECT_EQ(file_text(entry.path()), file_text(source)) << source;
  }
  EXPECT_GE(files, 12U);
  studio.play({kIdle, dump("hand.json")}, {(folder / "scenes/hand_grasps_ball.xml").string()});
  EXPECT_EQ(studio.state("hand.json")["simulation"]["sensors"].size(), 5U) << "its meshes and layout were found";
}

TEST(Examples, KeepTheChangesOfTheUser) {
  const StudioProgram studio;
  const std::filesystem::path mesh = studio.folder() / "state/examples/meshes/grip.obj";
  std::filesystem::create_directories(mesh.parent_path());
  write_text(mesh, "mine");
  studio.play(kOpenExamples, {"--state-dir", "state", "--empty"});
  EXPECT_EQ(file_text(mesh), "mine");
  EXPECT_TRUE(std::filesystem::exists(mesh.parent_path() / "fingertip.obj")) << "only missing files are written";
}

TEST(Examples, NameTheFolderThatCannotBeWritten) {
  const StudioProgram studio;
  std::filesystem::create_directories(studio.folder() / "state");
  write_text(studio.folder() / "state/examples", "a file is in the way");
  studio.play(joined({kOpenExamples, {dump("state.json")}}), {"--state-dir", "state", "--empty"});
  const Json state = studio.state("state.json");
  EXPECT_NE(state["messages"].dump().find("state/examples"), std::string::npos) << state["messages"];
  EXPECT_EQ(state["widgets"].dump().find("Filter"), std::string::npos) << "the dialog stays closed";
}

}  // namespace
}  // namespace taxel::test
