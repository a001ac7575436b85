// Commands found by part of their names.
#include "app/studio/features/menus/palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace taxel::ui {
namespace {

Action best(std::string_view typed) {
  return find_commands(typed).at(0)->action;
}

TEST(Palette, FindsWhatIsMeant) {
  EXPECT_EQ(best("export"), Action::export_layout);
  EXPECT_EQ(best("LAYOUT MODE"), Action::mode_layout);
  EXPECT_EQ(best("cov"), Action::toggle_coverage);
  EXPECT_EQ(best("box"), Action::box_select);
  EXPECT_EQ(best("lasso"), Action::lasso_select);
  EXPECT_EQ(best("  mirror "), Action::mirror);
  EXPECT_EQ(best("back mesh"), Action::project_back) << "words in any order";
  EXPECT_EQ(best("ctrl+e"), Action::export_layout) << "by its chord";
  EXPECT_EQ(best("prjbk"), Action::project_back) << "letters in their order";
  EXPECT_EQ(best("select i"), Action::box_select) << "a name that begins so goes before one that has it within";
}

TEST(Palette, EveryCommandIsFoundFirstByItsWholeName) {
  for (const Binding& b : bindings()) {
    const std::vector<const Binding*> found = find_commands(b.label);
    if (b.context == Context::gesture || b.action == Action::escape || b.action == Action::palette) {
      EXPECT_EQ(std::find(found.begin(), found.end(), &b), found.end()) << b.label;
    } else {
      ASSERT_FALSE(found.empty()) << b.label;
      EXPECT_EQ(std::string(found.front()->label), b.label);
    }
  }
}

TEST(Palette, NothingTypedIsEverythingAndNonsenseNothing) {
  const auto commands =
      static_cast<std::size_t>(std::count_if(bindings().begin(), bindings().end(), [](const Binding& b) {
        return b.context != Context::gesture && b.action != Action::escape && b.action != Action::palette;
      }));
  EXPECT_EQ(find_commands("").size(), commands);
  EXPECT_EQ(find_commands("   ").size(), commands);
  EXPECT_TRUE(find_commands("xqzzy").empty());
  EXPECT_TRUE(find_commands(std::string(10'000, 'a')).empty());
  EXPECT_TRUE(find_commands("\xff\xfe").empty());
}

}  // namespace
}  // namespace taxel::ui
