// The user guide in the window: its Markdown as blocks, and the sections that panels name.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/studio/frame/feature.h"
#include "app/studio/nouns/guide/guide_text.h"

namespace taxel::ui {
namespace {

using Kind = GuideBlock::Kind;

TEST(GuideText, JoinsTheLinesOfAParagraph) {
  const std::vector<GuideBlock> page = read_guide("# Title\n\nOne\ntwo.\n\nThree.\n");
  ASSERT_EQ(page.size(), 3U);
  EXPECT_EQ(page[0].kind, Kind::heading);
  EXPECT_EQ(page[0].level, 1);
  EXPECT_EQ(page[1].text, "One two.");
  EXPECT_EQ(page[2].text, "Three.");
}

TEST(GuideText, KeepsTheTextOfMarks) {
  EXPECT_EQ(read_guide("Press *Fix it* or `taxel run --x *`, see [the page](page.md#part).").front().text,
            "Press Fix it or taxel run --x *, see the page.");
  EXPECT_EQ(read_guide("![A finger](a.png)").front().text, "[Picture: A finger]");
  EXPECT_EQ(read_guide("`2*3.5`, 2*3 and ] and [").front().text, "2*3.5, 2*3 and ] and [");
}

TEST(GuideText, ReadsTablesItemsAndCode) {
  const std::vector<GuideBlock> page = read_guide(
      "| a | b |\n| --- | --- |\n| 1 | `x \\| y` |\n\n1. First\n2. Second\n   more\n- Third\n\n```\na  b\n\nc\n```\n");
  ASSERT_EQ(page.size(), 5U);
  EXPECT_EQ(page[0].rows, (std::vector<std::vector<std::string>>{{"a", "b"}, {"1", "x | y"}}));
  EXPECT_EQ(page[1].text, "1. First");
  EXPECT_EQ(page[2].text, "2. Second more");
  EXPECT_EQ(page[3].text, "Third");
  EXPECT_EQ(page[4].kind, Kind::code);
  EXPECT_EQ(page[4].text, "a  b\n\nc");
}

TEST(UserGuide, IsBuiltIntoTheProgram) {
  const std::vector<std::string> headings = headings_of(user_guide());
  ASSERT_GT(headings.size(), 20U);
  EXPECT_EQ(std::count(headings.begin(), headings.end(), "Author a layout"), 1);
  for (const GuideBlock& block : user_guide())
    for (const auto& row : block.rows) EXPECT_EQ(row.size(), block.rows.front().size()) << row.front();
}

TEST(UserGuide, HasTheSectionOfEachPanel) {
  const std::vector<std::string> headings = headings_of(user_guide());
  for (const Feature* row : features()) {
    if (row->guide != nullptr) {
      EXPECT_EQ(std::count(headings.begin(), headings.end(), row->guide), 1) << row->title << ": " << row->guide;
    } else {
      EXPECT_EQ(row->draw, nullptr) << row->title << " has no section of the guide";
    }
  }
}

}  // namespace
}  // namespace taxel::ui
