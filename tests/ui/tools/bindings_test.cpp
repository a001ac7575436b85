// The rows of commands, overlays and panels: unique keys, and menus in blocks.
#include <gtest/gtest.h>

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
    EXPECT_STREQ(binding.menu, "View") << row.key;
    EXPECT_EQ(std::string(binding.label), row.label);
    EXPECT_EQ(binding.chord, row.chord) << row.key;
  }
}

TEST(Bindings, FindARowByTheValuesOfItsCommand) {
  EXPECT_STREQ(binding_of(ExportFile{FileTask::export_sheet}).label, "Export sheet to print (HTML)...");
  EXPECT_STREQ(binding_of(SetMode{Mode::layout}).label, "Layout mode");
  EXPECT_STREQ(binding_of(SetMode{Mode::simulate}).label, "Simulate mode");
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
  EXPECT_EQ(begun, (std::set<std::string>{"Edit", "File", "File/Export", "Help", "Help/Examples", "Mode", "Panels",
                                          "Simulation", "View", "View/Camera", "View/Groups"}));
}

TEST(Bindings, SeparateTheBlocksOfAMenuByLines) {
  std::set<std::string> separated;
  for (const Binding& row : bindings())
    if (row.separated) separated.insert(row.label);
  EXPECT_EQ(separated, (std::set<std::string>{"Clip plane", "Copy taxels", "Frames (bodies, geoms, sites, world)",
                                              "Front view", "Full screen", "Hide", "Light theme", "Lock pressure range",
                                              "New layout on this geom", "Place taxels", "Quit", "Rename in the table",
                                              "Save", "Save screenshot", "Select in a box", "Sites of group 0",
                                              "Slower", "Transparent sensor"}));
}

TEST(Bindings, NameBothChords) {
  EXPECT_EQ(chord_names(binding_of(RedoStep{})), "Ctrl+Shift+Z, Ctrl+Y");
  EXPECT_EQ(chord_names(binding_of(SaveProject{})), "Ctrl+S");
  EXPECT_EQ(chord_names(binding_of(ShowTour{})), "");
}

}  // namespace
}  // namespace taxel::ui
