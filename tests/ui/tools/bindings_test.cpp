// The rows of commands, overlays and panels: unique keys, and menus in blocks.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/nouns/demo/demo_state.h"
#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/files/export.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/menus/window_commands.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "app/studio/nouns/view/view_commands.h"

namespace taxel::ui {
namespace {

TEST(Rows, HaveUniqueSettingsKeys) {
  std::set<std::string> keys;
  for (const OverlaySpec& row : overlays()) EXPECT_TRUE(keys.insert(row.key).second) << row.key;
  for (const Feature* row : features()) {
    if (row->key == nullptr) continue;
    EXPECT_TRUE(keys.insert(row->key).second) << row->key;
  }
}

TEST(Rows, HaveAMenuEntryForPanelsThatTheUserOpens) {
  std::set<std::string> titles;
  for (const Feature* row : features()) {
    if (std::string(row->title).empty()) {
      EXPECT_TRUE(row->draw == nullptr && row->dock == Dock::none);
    } else {
      EXPECT_TRUE(titles.insert(row->title).second) << row->title;
    }
    EXPECT_EQ(row->draw == nullptr, row->dock == Dock::none) << row->title;
    EXPECT_EQ(row->opens == Opens::by_user, row->key != nullptr) << row->title;
    if (row->opens == Opens::never) {
      EXPECT_EQ(row->label, nullptr) << row->title;
      continue;
    }
    const Binding& entry = binding_of(TogglePanel{row});
    if (row->label == nullptr) {
      EXPECT_STRNE(entry.menu, "Panels") << row->title;
    } else {
      EXPECT_STREQ(entry.menu, "Panels") << row->title;
      EXPECT_EQ(std::string(entry.label), row->label);
    }
  }
}

TEST(Rows, PutOverlaysIntoTheViewMenu) {
  for (const OverlaySpec& row : overlays()) {
    const Binding& binding = binding_of(ToggleOverlay{row.on});
    EXPECT_TRUE(std::string(binding.menu).starts_with("View")) << row.key;
    EXPECT_EQ(std::string(binding.label), row.label);
    EXPECT_EQ(binding.chord, row.chord) << row.key;
  }
}

TEST(Bindings, FindARowByTheValuesOfItsCommand) {
  EXPECT_STREQ(binding_of(ExportFile{FileTask::export_sheet}).label, "Export sheet to print (HTML)...");
  EXPECT_STREQ(binding_of(SetMode{Mode::layout}).label, "LAYOUT");
  EXPECT_STREQ(binding_of(SetMode{Mode::simulate}).label, "SIMULATE");
  EXPECT_STREQ(binding_of(ToggleGroup{&Overlays::site_groups, 4}).label, "Sites of group 4");
}

TEST(Bindings, BeginMenusWithoutASeparator) {
  std::set<std::string> begun;
  for (const Binding& row : bindings()) {
    if (row.menu == nullptr) {
      EXPECT_FALSE(row.separated) << row.label;
    } else if (begun.insert(row.menu).second) {
      EXPECT_FALSE(row.separated) << row.label;
    }
  }
  EXPECT_EQ(begun, (std::set<std::string>{"Edit",
                                          "Edit/Layouts of the scene",
                                          "Edit/Name and order",
                                          "Edit/Selection",
                                          "Edit/Show and hide",
                                          "Edit/Transform",
                                          "File",
                                          "File/Export",
                                          "Help",
                                          "Help/Examples",
                                          "Mode",
                                          "Panels",
                                          "Simulation",
                                          "Simulation/Recorded steps",
                                          "View",
                                          "View/Camera",
                                          "View/Contact and rays",
                                          "View/Frames and labels",
                                          "View/Groups",
                                          "View/Taxels and fields",
                                          "View/Window"}));
}

TEST(Bindings, FillNoMenuWithMoreThanEighteenEntries) {
  constexpr std::size_t kMost = 18;
  std::map<std::string, std::set<std::string>> columns;  // entries and titles of submenus
  for (const Binding& row : bindings()) {
    if (row.menu == nullptr) continue;
    const std::string menu = row.menu;
    columns[menu].insert(row.label);
    if (const std::size_t slash = menu.find('/'); slash != std::string::npos)
      columns[menu.substr(0, slash)].insert(menu.substr(slash + 1));
  }
  columns["File"].insert("Open recent");
  columns["File"].insert("Examples");
  for (const auto& [menu, column] : columns) EXPECT_LE(column.size(), kMost) << menu;
}

TEST(Bindings, KeepTheEntriesOfASubmenuTogether) {
  std::set<std::string> ended;
  std::string last;
  for (const Binding& row : bindings()) {
    const std::string menu = row.menu != nullptr ? row.menu : "";
    if (menu == last) continue;
    if (last.find('/') != std::string::npos) ended.insert(last);
    EXPECT_FALSE(ended.contains(menu)) << menu << ": " << row.label;
    last = menu;
  }
}

TEST(Bindings, NameNoEntryAPanel) {
  for (const Binding& row : bindings()) EXPECT_FALSE(std::string(row.label).ends_with("panel")) << row.label;
}

TEST(Bindings, ListGuideExamplesShortcutsAndAboutInHelp) {
  std::set<std::string> help;
  for (const Binding& row : bindings())
    if (row.menu != nullptr && std::string(row.menu).starts_with("Help"))
      help.insert(std::string(row.menu) == "Help" ? row.label : "Examples");
  EXPECT_EQ(help,
            (std::set<std::string>{"About Taxel Studio", "Examples", "Find a command...",
                                   "Guide to the panel under the mouse", "Keys and mouse", "Tour", "User guide"}));
}

TEST(Bindings, OpenEachPanelThatTheUserCloses) {
  std::set<const Feature*> opened;
  for (const Binding& row : bindings())
    if (const auto* toggle = row.command.get_if<TogglePanel>()) opened.insert(toggle->panel);
  for (const Feature* row : features())
    if (row->opens != Opens::never) {
      EXPECT_TRUE(opened.contains(row)) << row->title;
    }
  std::set<std::string> panels;
  for (const Binding& row : bindings())
    if (row.menu != nullptr && std::string(row.menu) == "Panels") panels.insert(row.label);
  EXPECT_TRUE(panels.contains("Real"));
}

TEST(Bindings, SeparateTheBlocksOfAMenuByLines) {
  std::set<std::string> separated;
  for (const Binding& row : bindings())
    if (row.separated) separated.insert(row.label);
  EXPECT_EQ(separated, (std::set<std::string>{"About Taxel Studio", "Clip plane", "Copy taxels",
                                              "Files of the examples...", "Frames (bodies, geoms, sites, world)",
                                              "Front view", "Light theme", "Lock pressure range", "Place taxels",
                                              "Quit", "Save", "Save screenshot", "Sites of group 0", "Slower",
                                              "What does each taxel read?", "Whole run on the axes"}));
}

TEST(Bindings, NameBothChords) {
  EXPECT_EQ(chord_names(binding_of(RedoStep{})), "Ctrl+Shift+Z, Ctrl+Y");
  EXPECT_EQ(chord_names(binding_of(SaveProject{})), "Ctrl+S");
  EXPECT_EQ(chord_names(binding_of(ShowTour{})), "");
}

}  // namespace
}  // namespace taxel::ui
