#include "app/studio/nouns/guide/guide_text.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace taxel::studio {

std::string_view embedded_file(std::string_view name);

}  // namespace taxel::studio

namespace taxel::ui {
namespace {

std::string_view without_outer_spaces(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

/// Returns the end of a link or picture that begins at text[at] with '[', and its text.
std::pair<std::size_t, std::string_view> link_at(std::string_view text, std::size_t at) {
  const std::size_t middle = text.find("](", at);
  const std::size_t end = middle == std::string_view::npos ? middle : text.find(')', middle);
  if (end == std::string_view::npos) return {at, {}};
  return {end + 1, text.substr(at + 1, middle - at - 1)};
}

/// Returns whether an asterisk at text[at] begins or ends an emphasis, which a product such as 2*3 does not.
bool is_emphasis(std::string_view text, std::size_t at) {
  const auto is_word = [&](std::size_t i) {
    return i < text.size() && std::isalnum(static_cast<unsigned char>(text[i])) != 0;
  };
  return !(at > 0 && is_word(at - 1) && is_word(at + 1));
}

/// Returns a line of Markdown as plain text.
std::string plain_text(std::string_view line) {
  std::string out;
  bool is_code = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    const bool is_picture = c == '!' && i + 1 < line.size() && line[i + 1] == '[';
    if (c == '`') {
      is_code = !is_code;
    } else if (!is_code && (is_picture || c == '[')) {
      const auto [end, text] = link_at(line, is_picture ? i + 1 : i);
      if (end <= i + 1) {
        out += c;
        continue;
      }
      out += is_picture ? "[Picture: " + plain_text(text) + "]" : plain_text(text);
      i = end - 1;
    } else if (is_code || c != '*' || !is_emphasis(line, i)) {
      out += c;
    }
  }
  return out;
}

/// Returns the cells of a row of a table. A bar in code is no end of a cell if a backslash precedes it.
std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells;
  std::string cell;
  line.remove_prefix(1);
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\\' && i + 1 < line.size() && line[i + 1] == '|') continue;
    if (line[i] == '|' && (i == 0 || line[i - 1] != '\\')) {
      cells.push_back(plain_text(without_outer_spaces(std::exchange(cell, {}))));
    } else {
      cell += line[i];
    }
  }
  return cells;
}

bool is_rule_of_table(std::string_view line) {
  return line.starts_with('|') && line.find_first_not_of("|-: ") == std::string_view::npos &&
         line.find('-') != std::string_view::npos;
}

/// Returns the length of the mark of a list's item, such as "- " or "12. ", or 0.
std::size_t item_mark(std::string_view line) {
  if (line.starts_with("- ")) return 2;
  const std::size_t digits = line.find_first_not_of("0123456789");
  return digits > 0 && digits != std::string_view::npos && line.substr(digits).starts_with(". ") ? digits + 2 : 0;
}

/// Collects the blocks of a page line by line.
class GuideReader {
 public:
  void take(std::string_view raw) {
    const std::string_view line = without_outer_spaces(raw);
    if (line.starts_with("```")) {
      is_code_ = !is_code_;
      if (is_code_) add(GuideBlock::Kind::code);
      joins_ = false;
    } else if (is_code_) {
      std::string& text = blocks_.back().text;
      text += (text.empty() ? "" : "\n") + std::string(raw);
    } else if (line.empty()) {
      joins_ = false;
    } else if (line.starts_with('#')) {
      take_heading(line);
    } else if (line.starts_with('|')) {
      take_row(line);
    } else {
      take_text(line);
    }
  }
  std::vector<GuideBlock> blocks() && { return std::move(blocks_); }

 private:
  void add(GuideBlock::Kind kind, std::string text = {}) {
    blocks_.emplace_back();
    blocks_.back().kind = kind;
    blocks_.back().text = std::move(text);
  }
  void take_heading(std::string_view line) {
    const std::size_t level = line.find_first_not_of('#');
    if (level == std::string_view::npos) return;
    add(GuideBlock::Kind::heading, plain_text(without_outer_spaces(line.substr(level))));
    blocks_.back().level = static_cast<int>(level);
    joins_ = false;
  }
  void take_row(std::string_view line) {
    if (is_rule_of_table(line)) return;
    if (!joins_ || blocks_.back().kind != GuideBlock::Kind::table) add(GuideBlock::Kind::table);
    blocks_.back().rows.push_back(cells_of(line));
    joins_ = true;
  }
  void take_text(std::string_view line) {
    const std::size_t mark = item_mark(line);
    const bool continues = joins_ && mark == 0 && blocks_.back().kind != GuideBlock::Kind::table;
    if (continues) {
      blocks_.back().text += ' ' + plain_text(line);
    } else {
      const bool is_dash = line.starts_with('-');
      add(mark > 0 ? GuideBlock::Kind::item : GuideBlock::Kind::paragraph,
          plain_text(is_dash ? line.substr(mark) : line));
    }
    joins_ = true;
  }

  std::vector<GuideBlock> blocks_;
  bool is_code_ = false;  ///< whether the lines are those of a block of code
  bool joins_ = false;    ///< whether the next line of text continues the last block
};

}  // namespace

std::vector<GuideBlock> read_guide(std::string_view markdown) {
  GuideReader reader;
  while (!markdown.empty()) {
    const std::size_t end = std::min(markdown.find('\n'), markdown.size());
    reader.take(markdown.substr(0, end));
    markdown.remove_prefix(std::min(end + 1, markdown.size()));
  }
  return std::move(reader).blocks();
}

const std::vector<GuideBlock>& user_guide() {
  static const std::vector<GuideBlock> guide = read_guide(studio::embedded_file("docs/user_guide.md"));
  return guide;
}

std::vector<std::string> headings_of(const std::vector<GuideBlock>& page) {
  std::vector<std::string> headings;
  for (const GuideBlock& block : page)
    if (block.kind == GuideBlock::Kind::heading && block.level > 1) headings.push_back(block.text);
  return headings;
}

}  // namespace taxel::ui
