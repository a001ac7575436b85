// Reads a text file word by word and names the line in its messages. Does not depend on the locale.
#pragma once

#include <string>
#include <string_view>

#include "core/base/math.h"

namespace taxel {

/// The mark that some programs write before a text in UTF-8.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// A position in a text that advances line by line and word by word.
class TextCursor {
 public:
  /// `file` is named in messages. `comment` begins a comment that reaches to the end of its line; 0 for no comments.
  /// A byte order mark at the begin of the text is passed over.
  TextCursor(std::string_view text, std::string file, char comment)
      : text_(text), file_(std::move(file)), comment_(comment), next_(text.starts_with(kByteOrderMark) ? 3 : 0) {}

  /// Advances to the next line that has a word. Returns false at the end of the text. A backslash at the end of a line
  /// joins the next line to it.
  bool next_line();
  /// Returns the next word of the current line, or an empty word at the line's end.
  std::string_view word();
  /// Returns the next word of this line or of a later one, or an empty word at the end of the text.
  std::string_view word_anywhere();
  /// Passes over the rest of this line and the lines up to the next empty line, or to the end of the text.
  void skip_paragraph();
  /// Goes on at a position in bytes from the begin of the text, in the midst of a line. Line numbers do not change.
  void continue_at(std::size_t offset);
  /// Returns a word as a number. Throws Error naming the file and the line if the word is empty or not a number.
  double number(std::string_view word) const;
  /// Returns a word as a whole number. Throws Error naming the file and the line if the word is not one.
  long long integer(std::string_view word) const;
  /// Reads three numbers from this line. Throws Error naming the file and the line if one is missing or not finite.
  dvec3 finite_point();

  /// Throws Error naming the file and the current line.
  [[noreturn]] void fail(const std::string& message) const;
  /// Returns the position after the current line, in bytes from the begin of the text.
  [[nodiscard]] std::size_t offset() const { return next_; }

 private:
  std::string_view text_;
  std::string file_;
  char comment_;
  std::string_view rest_;  ///< remainder of the current line
  std::size_t next_;       ///< begin of the next line
  int line_number_ = 0;    ///< number of the current line, from 1
};

}  // namespace taxel
