// The command palette: the entries that natural words find, and the reasons of entries that are not possible now.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "app/studio/frame/app.h"
#include "app/studio/frame/keymap.h"
#include "app/studio/frame/search.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/guide/guide_text.h"
#include "app/studio/nouns/inspector/inspector_state.h"
#include "app/studio/shell/interface/carry_out.h"
#include "app/studio/shell/menus/found.h"
#include "ui/tools/running.h"

namespace taxel::ui {
namespace {

const std::vector<Found>& entries() {
  static const std::vector<Found> all = all_found();
  return all;
}

/// Returns the names of the first entries for a typed text, best first.
std::vector<std::string> names_for(std::string_view typed, std::size_t count = 1000) {
  std::vector<std::string> names;
  for (const std::size_t i : find_entries(typed, entries()))
    if (names.size() < count) names.push_back(entries()[i].texts.name);
  return names;
}

std::string best_for(std::string_view typed) {
  const std::vector<std::string> names = names_for(typed, 1);
  return names.empty() ? "" : names.front();
}

bool lists(std::string_view typed, const std::string& name) {
  const std::vector<std::string> names = names_for(typed);
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Words as a person would type them, and the entry that they mean.
struct Natural {
  const char *typed, *name;
};

// Words of roboticists and of users of Blender and MuJoCo.
constexpr Natural kNatural[] = {
    {"export json", "Export layout..."},
    {"save layout", "Save"},
    {"attach sensor", "Attach a layout"},
    {"breakpoint", "Pause when a taxel jumps"},
    {"error bars", "Error bars"},
    {"repair mesh", "Repair level"},
    {"units", "Unit"},
    {"density", "Density"},
    {"stiffness", "Modulus"},
    {"friction", "Friction"},
    {"opaque", "X-ray"},
    {"settings", "Inspector"},
    {"preferences", "Light theme"},
    {"manual", "User guide"},
    {"follow camera", "Track the body: the camera goes along (Esc frees it)"},
    {"parameter sweep", "Study"},
    {"screenshot", "Save screenshot"},
    {"render video", "Export video..."},
    {"gif", "Export video..."},
    {"undo", "Undo"},
    {"delete taxel", "Delete"},
    {"duplicate", "Duplicate"},
    {"mirror", "Mirror, linked"},
    {"grid of taxels", "Grid of taxels"},
    {"hexagonal", "Hexagonal of taxels"},
    {"csv", "Export taxels (CSV)..."},
    {"point cloud", "Samples"},
    {"heatmap", "Heat map"},
    {"pressure plot", "Plot"},
    {"force arrow", "Traction arrows"},
    {"young's modulus", "Young's modulus (kPa)"},
    {"poisson", "Poisson's ratio"},
    {"silicone", "Elastomer"},
    {"thickness", "Thickness"},
    {"damping", "Dissipation"},
    {"timestep", "Time step"},
    {"gravity", "Physics"},
    {"joint angles", "Joints"},
    {"motors", "Actuators"},
    {"keyframe", "Keyframes"},
    {"contact forces", "Traction arrows"},
    {"wireframe", "Wireframe"},
    {"x-ray", "X-ray"},
    {"clipping plane", "Clip plane"},
    {"ortho", "Orthographic view"},
    {"top view", "Top view"},
    {"zoom to selection", "Frame selection or contact"},
    {"fullscreen", "Full screen"},
    {"dark mode", "Light theme"},
    {"font size", "Larger interface"},
    {"shortcuts", "Keys and mouse"},
    {"help", "User guide"},
    {"tutorial", "Tour"},
    {"examples", "Files of the examples..."},
    {"open urdf", "Open..."},
    {"import stl", "Open..."},
    {"noise", "Noise"},
    {"hysteresis", "Hysteresis"},
    {"crosstalk", "Crosstalk"},
    {"calibration", "Calibrated"},
    {"tare", "Tare"},
    {"sampling rate", "Rate"},
    {"random seed", "Seed"},
    {"receptive field size", "Radius (mm)"},
    {"geodesic", "Receptive fields: Euclidean vs. geodesic"},
    {"show normals", "Sample normals"},
    {"measure distance", "Measure"},
    {"record", "Record"},
    {"rosbag", "Export recording..."},
    {"play", "Run / Pause"},
    {"slow motion", "Slower"},
    {"rewind", "Reset"},
    {"compare layouts", "Compare with a layout..."},
    {"exit", "Quit"},
};

// Words with typing errors, in another order, and other words for the same thing.
constexpr Natural kOther[] = {
    {"stifness", "Modulus"},
    {"firction", "Friction"},
    {"densty", "Density"},
    {"screnshot", "Save screenshot"},
    {"exprot layout", "Export layout..."},
    {"layout export", "Export layout..."},
    {"selection frame", "Frame selection or contact"},
    {"mirorr", "Mirror, linked"},
    {"hysterisis", "Hysteresis"},
    {"taxel remove", "Delete"},
    {"colour scheme", "Light theme"},
    {"color scheme", "Light theme"},
    {"heat-map", "Heat map"},
    {"orthogrphic", "Orthographic view"},
    {"shorcuts", "Keys and mouse"},
    {"bars error", "Error bars"},
    {"mesh unit", "Unit"},
    {"mesh repare", "Repair"},
    {"brekpoint", "Pause when a taxel jumps"},
    {"keyfarme", "Keyframes"},
    {"gravty", "Physics"},
    {"plane clip", "Clip plane"},
    {"viedo", "Export video..."},
    {"thikness", "Thickness"},
    {"undo list", "Undo history"},
    {"poison ratio", "Poisson's ratio"},
    {"calibraton", "Calibrated"},
    {"why does it jump", "Explain the reading"},
    {"real sensor data", "Import real recording..."},
    {"how do I measure a distance", "Measure"},
};

void expect_among_first_three(const Natural& row) {
  const std::vector<std::string> first = names_for(row.typed, 3);
  std::string found;
  for (const std::string& name : first) found += "\n  " + name;
  EXPECT_NE(std::find(first.begin(), first.end(), row.name), first.end())
      << '"' << row.typed << "\" is to find \"" << row.name << "\", finds" << found;
}

TEST(Palette, FindsNaturalWordsAmongTheFirstThree) {
  static_assert(std::size(kNatural) == 74);
  for (const Natural& row : kNatural) expect_among_first_three(row);
}

TEST(Palette, FindsTypingErrorsAndOtherOrdersAmongTheFirstThree) {
  static_assert(std::size(kOther) == 30);
  for (const Natural& row : kOther) expect_among_first_three(row);
}

TEST(Palette, FindsTheIntendedCommand) {
  EXPECT_EQ(best_for("export"), "Export layout...");
  EXPECT_EQ(best_for("LAYOUT MODE"), "LAYOUT");
  EXPECT_EQ(best_for("cov"), "Coverage and overlap");
  EXPECT_EQ(best_for("box"), "Select in a box");
  EXPECT_EQ(best_for("lasso"), "Select in a lasso");
  EXPECT_EQ(best_for("  mirror "), "Mirror, linked");
  EXPECT_EQ(best_for("back mesh"), "Project back to the mesh") << "words in any order";
  EXPECT_EQ(best_for("ctrl+e"), "Export layout...") << "by its chord";
  EXPECT_EQ(best_for("prjbk"), "Project back to the mesh") << "letters in their order";
  EXPECT_EQ(best_for("select i"), "Select in a box") << "a name that begins so goes before one that has it within";
}

TEST(Palette, FindsCommandsBySynonyms) {
  EXPECT_EQ(best_for("turntable"), "Make a film around the contact");
  EXPECT_EQ(best_for("perspective"), "Orthographic view");
  EXPECT_TRUE(lists("colour", "Light theme"));
  EXPECT_TRUE(lists("color", "Light theme"));
  EXPECT_FALSE(lists("colour", "Save screenshot"));
}

TEST(Palette, KnowsTheLabelsOfItsSynonyms) {
  std::set<std::string> names;
  for (const Found& entry : entries()) names.insert(entry.texts.name);
  names.insert("Find a command...");  // the help finds it
  std::set<std::string_view> labels;
  for (const std::string_view label : labels_with_synonyms()) {
    EXPECT_TRUE(names.contains(std::string(label))) << label << " was renamed without its synonyms";
    EXPECT_TRUE(labels.insert(label).second) << label << " is listed twice";
  }
}

TEST(Palette, FindsEveryEntryFirstByItsWholeName) {
  for (const Found& entry : entries()) EXPECT_EQ(best_for(entry.texts.name), entry.texts.name);
}

TEST(Palette, ListsCommandsWithoutATextAndNothingForNonsense) {
  const auto commands = static_cast<std::size_t>(
      std::count_if(entries().begin(), entries().end(), [](const Found& entry) { return entry.target.index() == 0; }));
  EXPECT_EQ(names_for("").size(), commands);
  EXPECT_EQ(names_for("   ").size(), commands);
  EXPECT_TRUE(names_for("xqzzy").empty());
  EXPECT_TRUE(names_for(std::string(10'000, 'a')).empty());
  EXPECT_TRUE(names_for("\xff\xfe").empty());
}

TEST(Palette, HasCommandsPartsGesturesAndHeadings) {
  std::set<std::size_t> kinds;
  for (const Found& entry : entries()) kinds.insert(entry.target.index());
  EXPECT_EQ(kinds.size(), 4U);
  EXPECT_TRUE(lists("tangential stiffness", "Tangential stiffness")) << "a field of the table of settings";
  EXPECT_TRUE(lists("BioTac", "BioTac, 19 electrodes")) << "an example";
  EXPECT_TRUE(lists("ecoflex", "Ecoflex 00-30")) << "a preset";
  EXPECT_EQ(best_for("Find why a taxel jumps"), "Find why a taxel jumps") << "a heading";
}

TEST(Palette, SaysWhyAnEntryIsNotPossible) {
  test::Running run;
  const auto why = [&](const char* name) {
    const auto found =
        std::find_if(entries().begin(), entries().end(), [&](const Found& entry) { return entry.texts.name == name; });
    return why_not_now(*found, run.scene.app);
  };
  EXPECT_EQ(why("Move"), "Only in LAYOUT (Ctrl+1)");
  EXPECT_EQ(why("Radius (mm)"), "Select a taxel first");
  EXPECT_EQ(why("Undo"), "There is no edit to undo");
  EXPECT_EQ(why("Density"), "");
  run.scene.app.viewer->mode = Mode::layout;
  EXPECT_EQ(why("Move"), "Select a taxel first");
  run.scene.app.viewer->selection.taxels = {1};
  EXPECT_EQ(why("Move"), "");
  EXPECT_EQ(why("Radius (mm)"), "");
}

TEST(Bindings, NameTheirNeeds) {
  for (const Binding& row : bindings())
    EXPECT_EQ(row.enabled != nullptr, row.needs != nullptr || row.why_disabled != nullptr) << row.label;
}

TEST(TypingErrors, CountMissingAddedWrongAndExchangedLetters) {
  EXPECT_EQ(typing_errors("friction", "friction", 2), 0U);
  EXPECT_EQ(typing_errors("fricton", "friction", 2), 1U);
  EXPECT_EQ(typing_errors("fricction", "friction", 2), 1U);
  EXPECT_EQ(typing_errors("fraction", "friction", 2), 1U);
  EXPECT_EQ(typing_errors("firction", "friction", 2), 1U);
  EXPECT_EQ(typing_errors("friktoin", "friction", 2), 2U);
  EXPECT_EQ(typing_errors("abc", "friction", 2), 3U) << "no more than one above the limit";
  EXPECT_EQ(typing_errors("", "ab", 2), 2U);
}

TEST(Search, PrefersNamesOverFurtherWordsAndHelp) {
  const std::vector<SearchTexts> texts{
      {"Alpha", "", "", "", "the gamma of it"}, {"Beta", "", "gamma", "", ""}, {"Gamma", "", "", "", ""}};
  const std::vector<SearchWords> words(texts.begin(), texts.end());
  const std::vector<const SearchWords*> entries{&words[0], &words[1], &words[2]};
  EXPECT_EQ(search("gamma", entries), (std::vector<std::size_t>{2, 1, 0}));
  EXPECT_EQ(search("the gamma", entries), (std::vector<std::size_t>{2, 1, 0})) << "articles are left out";
  EXPECT_EQ(search("Gamma beta", entries).front(), 1U) << "both words match";
}

}  // namespace
}  // namespace taxel::ui
