// The user guide as blocks of text, read from its Markdown. The guide is built into the program.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace taxel::ui {

/// A part of a page that is drawn as a whole.
struct GuideBlock {
  enum class Kind { heading, paragraph, item, code, table };
  Kind kind = Kind::paragraph;
  int level = 0;                               ///< level of a heading, 1 to 6
  std::string text;                            ///< without marks of Markdown; empty for a table
  std::vector<std::vector<std::string>> rows;  ///< rows of a table; the first one names the columns
};

/// Returns the blocks of a page. Lines of a paragraph are joined. Emphasis, code and links keep their text only, and
/// pictures become their descriptions in brackets.
[[nodiscard]] std::vector<GuideBlock> read_guide(std::string_view markdown);

/// Returns the user guide of this program.
[[nodiscard]] const std::vector<GuideBlock>& user_guide();

/// Returns the headings of a page in their order, except its title.
[[nodiscard]] std::vector<std::string> headings_of(const std::vector<GuideBlock>& page);

}  // namespace taxel::ui
