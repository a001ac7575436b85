#include "core/base/text/csv.h"

#include <fmt/format.h>

#include "core/base/error.h"

namespace taxel {
namespace {

/// Splits a text into rows and fields, character by character.
class Reader {
 public:
  Reader(const std::string& text, const std::string& file, char separator)
      : text_(text), file_(file), separator_(separator) {
    const std::string mark = "\xEF\xBB\xBF";  // some programs write this mark before UTF-8
    if (text.starts_with(mark)) at_ = mark.size();
  }

  std::vector<CsvRow> rows() {
    std::vector<CsvRow> rows;
    while (at_ < text_.size()) {
      CsvRow row = next_row();
      const bool empty = row.fields.size() == 1 && row.fields[0].empty();
      if (!empty) rows.push_back(std::move(row));
    }
    return rows;
  }

 private:
  [[noreturn]] void fail(int line, const std::string& message) const {
    throw Error(file_, fmt::format("line {}", line), message);
  }
  [[nodiscard]] bool at_end_of_line() const { return at_ >= text_.size() || text_[at_] == '\n' || text_[at_] == '\r'; }
  [[nodiscard]] static bool blank(char c) { return c == ' ' || c == '\t'; }
  [[nodiscard]] bool skips(char c) const { return blank(c) && c != separator_; }

  CsvRow next_row() {
    CsvRow row{line_, {}};
    if (text_[at_] == '#') {
      while (!at_end_of_line()) ++at_;
      row.fields.emplace_back();
    } else {
      row.fields.push_back(next_field());
      while (!at_end_of_line()) {
        ++at_;  // the separator
        row.fields.push_back(next_field());
      }
    }
    if (at_ < text_.size() && text_[at_] == '\r') ++at_;
    if (at_ < text_.size() && text_[at_] == '\n') ++at_;
    ++line_;
    return row;
  }

  [[nodiscard]] bool separates(char c) {
    if (separator_ == '\0' && (c == ',' || c == ';' || c == '\t')) separator_ = c;
    return c == separator_;
  }

  std::string next_field() {
    while (at_ < text_.size() && skips(text_[at_]) && !(separator_ == '\0' && text_[at_] == '\t')) ++at_;
    if (at_ < text_.size() && text_[at_] == '"') return quoted_field();
    std::string field;
    while (!at_end_of_line() && !separates(text_[at_])) {
      if (text_[at_] == '"') fail(line_, "a quote is inside of a field");
      field += text_[at_++];
    }
    while (!field.empty() && blank(field.back())) field.pop_back();
    return field;
  }

  std::string quoted_field() {
    const int begin = line_;
    std::string field;
    for (++at_;; ++at_) {
      if (at_ >= text_.size()) fail(begin, "a quote is not closed");
      if (text_[at_] == '"') {
        if (at_ + 1 >= text_.size() || text_[at_ + 1] != '"') break;
        ++at_;
      }
      if (text_[at_] == '\n') ++line_;
      field += text_[at_];
    }
    ++at_;
    while (at_ < text_.size() && skips(text_[at_]) && !(separator_ == '\0' && text_[at_] == '\t')) ++at_;
    if (!at_end_of_line() && !separates(text_[at_])) fail(line_, "a quoted field goes on behind its quote");
    return field;
  }

  const std::string& text_;
  const std::string& file_;
  std::size_t at_ = 0;
  int line_ = 1;
  char separator_;  ///< '\0' if not known yet
};

}  // namespace

std::string csv_field(const std::string& text) {
  const bool trimmed = text.starts_with(' ') || text.ends_with(' ') || text.starts_with('#');
  if (!trimmed && text.find_first_of(",\"\r\n\t") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::vector<CsvRow> parse_csv(const std::string& text, const std::string& file, char separator) {
  return Reader(text, file, separator).rows();
}

}  // namespace taxel
