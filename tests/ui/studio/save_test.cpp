// Saving, exporting and leaving unsaved edits.
#include <gtest/gtest.h>

#include <cmath>

#include "script_lines.h"

namespace taxel::test {
namespace {

/// Opens the layout and sets the radius of taxel 3 to three millimetres.
const Lines kEdit{kLayoutMode,  kIdle, R"({"event": "click", "at": {"taxel": 3}})", kIdle, key("f"), type("3"), kIdle,
                  key("Enter"), kIdle};

/// Opens a dialog by a key, types a name and presses Enter.
Lines in_dialog(const std::string& letter, const std::string& name) {
  return {key(letter, kCtrl), kIdle, type(name), kIdle, key("Enter"), kIdle};
}

double radius_of_3(const Json& layout) {
  return taxel_of(layout, 3)["radius"];
}

TEST(Save, WritesAProjectThatOpensAgain) {
  const StudioProgram studio;
  const std::string file = (studio.folder() / "mine.taxelproj").string();
  studio.play(joined({kEdit,
                      {dump("edited.json"), R"({"event": "wheel", "at": {"view": [0.326, 0.681]}, "y": 3})", kIdle},
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

  studio.play({kIdle, dump("opened.json"), R"({"event": "wheel", "at": {"view": [0.326, 0.681]}, "y": 2})",
               key("s", kCtrl), kIdle},
              {file});
  const Json opened = studio.state("opened.json");
  EXPECT_EQ(opened["mode"], "layout") << "one goes on editing";
  EXPECT_EQ(opened["document"]["layout"], saved["document"]["layout"]);
  EXPECT_NE(saved["camera"], studio.state("edited.json")["camera"]);
  EXPECT_EQ(opened["camera"], saved["camera"]) << "as it was left";
  EXPECT_EQ(Json::parse(file_text(file))["layout"], Json::parse(bytes)["layout"]) << "Ctrl+S writes where it is";
}

TEST(Save, WritesALayoutIfTheNameSaysSo) {
  const StudioProgram studio;
  const std::string file = (studio.folder() / "mine.taxels.json").string();
  studio.play(joined({kEdit, in_dialog("s", file), {dump("named.json")}}), {kLayoutFile});
  EXPECT_FALSE(std::filesystem::exists(file + ".taxelproj"));
  ASSERT_TRUE(std::filesystem::exists(file));
  EXPECT_DOUBLE_EQ(radius_of_3(Json::parse(file_text(file))), 3e-3);
  const Json named = studio.state("named.json");
  EXPECT_NE(named["messages"].dump().find("Exported " + file), std::string::npos) << named["messages"];
  EXPECT_TRUE(named["history"]["dirty"]) << "the project is not saved";
}

TEST(Save, GivesTheSameBytesAfterExportImportAndExport) {
  const StudioProgram studio;
  const std::string first = (studio.folder() / "one.taxels.json").string();
  const std::string second = (studio.folder() / "two.taxels.json").string();
  studio.play(joined({kEdit, in_dialog("e", (studio.folder() / "one").string()), {dump("exported.json")}}));
  EXPECT_TRUE(studio.state("exported.json")["history"]["dirty"]) << "an export is no save";
  EXPECT_EQ(radius_of_3(Json::parse(file_text(first))), 0.003);
  EXPECT_EQ(Json::parse(file_text(first))["mesh"]["file"], "fingertip.obj")
      << "the mesh was written to the same folder";
  studio.play(joined({{kLayoutMode, kIdle}, in_dialog("e", second)}), {first});
  EXPECT_EQ(file_text(first), file_text(second));
#ifdef TAXEL_PROGRAM
  EXPECT_EQ(run_program(TAXEL_PROGRAM, {"check", first}, studio.folder()).status, 0);
#endif
}

TEST(Save, AsksBeforeReplacingAFileAndReportsWriteErrors) {
  const StudioProgram studio;
  const std::string existing_file = (studio.folder() / "there.taxels.json").string();
  write_text(existing_file, "mine");
  studio.play(joined({kEdit, in_dialog("e", existing_file), {dump("asked.json"), key("Esc"), kIdle}}), {kLayoutFile});
  EXPECT_EQ(file_text(existing_file), "mine");
  EXPECT_NE(studio.state("asked.json")["widgets"].dump().find("Export"), std::string::npos) << "the dialog is open";
  studio.play(joined({kEdit, in_dialog("e", existing_file), {key("Enter"), kIdle}}), {kLayoutFile});
  EXPECT_EQ(radius_of_3(Json::parse(file_text(existing_file))), 0.003) << "asked for once more";
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

TEST(Close, DiscardsOnRequestAndAsksBeforeAnotherFile) {
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

}  // namespace
}  // namespace taxel::test
