// Commands found by part of their names.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "app/studio/frame/app.h"
#include "app/studio/frame/keymap.h"
#include "app/studio/nouns/camera/camera_state.h"
#include "app/studio/nouns/files/export.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/menus/window_commands.h"
#include "app/studio/nouns/taxel/taxel_commands.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "app/studio/nouns/video/video_commands.h"
#include "app/studio/nouns/view/view_commands.h"
#include "app/studio/shell/menus/menus.h"

namespace taxel::ui {
namespace {

/// Whether a command is the best match for the typed text.
template <class C>
bool finds(std::string_view typed, const C& command) {
  return find_commands(typed).at(0) == &binding_of(command);
}

/// Whether a command is among the matches for the typed text.
template <class C>
bool lists(std::string_view typed, const C& command) {
  const std::vector<const Binding*> found = find_commands(typed);
  return std::find(found.begin(), found.end(), &binding_of(command)) != found.end();
}

bool is_listed(const Binding& row) {
  return row.context != Context::gesture && !row.command.is<Escape>() && !row.command.is<OpenPalette>();
}

TEST(Palette, FindsTheIntendedCommand) {
  EXPECT_TRUE(finds("export", ExportFile{FileTask::export_layout}));
  EXPECT_TRUE(finds("LAYOUT MODE", SetMode{Mode::layout}));
  EXPECT_TRUE(finds("cov", ToggleOverlay{&Overlays::coverage}));
  EXPECT_TRUE(finds("box", ToggleTool{Tool::box}));
  EXPECT_TRUE(finds("lasso", ToggleTool{Tool::lasso}));
  EXPECT_TRUE(finds("  mirror ", MirrorSelected{}));
  EXPECT_TRUE(finds("back mesh", ProjectSelectedBack{})) << "words in any order";
  EXPECT_TRUE(finds("ctrl+e", ExportFile{FileTask::export_layout})) << "by its chord";
  EXPECT_TRUE(finds("prjbk", ProjectSelectedBack{})) << "letters in their order";
  EXPECT_TRUE(finds("select i", ToggleTool{Tool::box})) << "a name that begins so goes before one that has it within";
}

TEST(Palette, FindsCommandsBySynonyms) {
  EXPECT_TRUE(finds("gif", ExportFile{FileTask::export_video}));
  EXPECT_TRUE(finds("movie", ExportFile{FileTask::export_video}));
  EXPECT_TRUE(finds("turntable", MakeFilm{}));
  EXPECT_TRUE(finds("dark", ToggleTheme{}));
  EXPECT_TRUE(lists("colour", ToggleTheme{}));
  EXPECT_TRUE(lists("color", ToggleTheme{}));
  EXPECT_TRUE(finds("screenshot", TakeScreenshot{}));
  EXPECT_TRUE(lists("snapshot", TakeScreenshot{}));
  EXPECT_FALSE(lists("colour", TakeScreenshot{}));
  EXPECT_TRUE(finds("perspective", ToggleOrthographic{}));
}

TEST(Palette, KnowsTheLabelsOfItsSynonyms) {
  std::size_t with_synonyms = 0;
  for (const Binding& b : bindings()) with_synonyms += synonyms_of(b.label).empty() ? 0 : 1;
  EXPECT_EQ(with_synonyms, synonym_count()) << "a label was renamed without its synonyms";
}

TEST(Palette, FindsEveryCommandFirstByItsWholeName) {
  for (const Binding& b : bindings()) {
    const std::vector<const Binding*> found = find_commands(b.label);
    if (!is_listed(b)) {
      EXPECT_EQ(std::find(found.begin(), found.end(), &b), found.end()) << b.label;
    } else {
      ASSERT_FALSE(found.empty()) << b.label;
      EXPECT_EQ(std::string(found.front()->label), b.label);
    }
  }
}

TEST(Palette, ListsEverythingWithoutATextAndNothingForNonsense) {
  const auto commands = static_cast<std::size_t>(std::count_if(bindings().begin(), bindings().end(), is_listed));
  EXPECT_EQ(find_commands("").size(), commands);
  EXPECT_EQ(find_commands("   ").size(), commands);
  EXPECT_TRUE(find_commands("xqzzy").empty());
  EXPECT_TRUE(find_commands(std::string(10'000, 'a')).empty());
  EXPECT_TRUE(find_commands("\xff\xfe").empty());
}

}  // namespace
}  // namespace taxel::ui
