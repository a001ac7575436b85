// Words and numbers of a text file, with the line for messages. Independent of the locale.
#pragma once

#include <string>
#include <string_view>

#include "core/base/math.h"

namespace taxel {

/// Reads a text line by line, word by word.
class TextCursor {
 public:
  /// `comment` starts a comment that reaches to the end of its line; 0: none.
  TextCursor(std::string_view text, std::string file, char comment)
      : text_(text), file_(std::move(file)), comment_(comment) {}

  /// Goes to the next line that has a word; false at the end. A backslash at the end of a line continues it.
  bool next_line();
  /// The next word of the current line, or an empty one at its end.
  std::string_view word();
  /// The next word, of this line or of a later one; an empty one at the end of the text.
  std::string_view word_anywhere();
  /// A word as a number. Throws Error naming file and line when it is none.
  double number(std::string_view word) const;
  long long integer(std::string_view word) const;
  /// Three numbers from this line, finite; throws Error otherwise.
  dvec3 finite_point();

  [[noreturn]] void fail(const std::string& message) const;
  [[nodiscard]] int line() const { return line_number_; }
  /// The position after the current line.
  [[nodiscard]] std::size_t offset() const { return next_; }

 private:
  std::string_view text_;
  std::string file_;
  char comment_;
  std::string_view rest_;  ///< of the current line
  std::size_t next_ = 0;   ///< begin of the next line
  int line_number_ = 0;    ///< of the current line, from 1
};

}  // namespace taxel
