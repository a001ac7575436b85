#include "core/mesh/formats/text_cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "core/base/error.h"

namespace taxel {
namespace {

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// Returns a word for a message: at most kShown characters, and printable even if the file is binary.
std::string quoted(std::string_view word) {
  constexpr std::size_t kShown = 24;
  std::string text = "'";
  for (const char c : word.substr(0, kShown)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (word.size() > kShown ? "...'" : "'");
}

template <class T>
bool parse_number(std::string_view word, T& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

}  // namespace

bool TextCursor::next_line() {
  while (next_ < text_.size()) {
    const std::size_t end = std::min(text_.find('\n', next_), text_.size());
    rest_ = text_.substr(next_, end - next_);
    next_ = std::min(end + 1, text_.size());  // the last line may end without a newline
    ++line_number_;
    if (comment_ != 0) rest_ = rest_.substr(0, rest_.find(comment_));
    while (!rest_.empty() && is_space(rest_.front())) rest_.remove_prefix(1);
    if (!rest_.empty()) return true;
  }
  rest_ = {};
  next_ = text_.size();
  return false;
}

std::string_view TextCursor::word() {
  while (!rest_.empty() && is_space(rest_.front())) rest_.remove_prefix(1);
  if (rest_.starts_with('\\') && rest_.find_first_not_of(" \t\r", 1) == std::string_view::npos) {
    if (!next_line()) return {};
    return word();
  }
  std::size_t length = 0;
  while (length < rest_.size() && !is_space(rest_[length])) ++length;
  const std::string_view found = rest_.substr(0, length);
  rest_.remove_prefix(length);
  return found;
}

std::string_view TextCursor::word_anywhere() {
  std::string_view found = word();
  while (found.empty() && next_line()) found = word();
  return found;
}

void TextCursor::skip_paragraph() {
  rest_ = {};
  bool empty = false;
  while (next_ < text_.size() && !empty) {
    const std::size_t end = std::min(text_.find('\n', next_), text_.size());
    const std::string_view line = text_.substr(next_, end - next_);
    empty = std::all_of(line.begin(), line.end(), is_space);
    next_ = std::min(end + 1, text_.size());
    ++line_number_;
  }
}

void TextCursor::continue_at(std::size_t offset) {
  rest_ = {};
  next_ = std::min(offset, text_.size());
}

double TextCursor::number(std::string_view word) const {
  double value = 0;
  if (word.empty()) fail("a number is missing");
  if (!parse_number(word, value)) fail(quoted(word) + " is not a number");
  return value;
}

long long TextCursor::integer(std::string_view word) const {
  long long value = 0;
  if (word.empty()) fail("a number is missing");
  if (!parse_number(word, value)) fail(quoted(word) + " is not a whole number");
  return value;
}

dvec3 TextCursor::finite_point() {
  dvec3 p;
  for (int i = 0; i < 3; ++i) p[i] = number(word());
  if (!is_finite(p)) fail(fmt::format("coordinate is not finite ({}, {}, {})", p.x, p.y, p.z));
  return p;
}

void TextCursor::fail(const std::string& message) const {
  throw Error(file_, fmt::format("line {}", line_number_), message);
}

}  // namespace taxel
