// The exception for bad input, and the entry of a list of rule violations.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace taxel {

/// Bad input. `file` and `where` (a JSON pointer, a line, a face, a taxel) may be empty. what() reads
/// "FILE: WHERE: message", the form that the command line prints after "taxel: ".
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message) : Error("", "", message) {}
  Error(const std::string& file, const std::string& message) : Error(file, "", message) {}
  Error(const std::string& file, const std::string& where, const std::string& message)
      : std::runtime_error(join(file, where, message)), file_(file), where_(where), message_(message) {}

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] const std::string& where() const { return where_; }
  [[nodiscard]] const std::string& message() const { return message_; }

 private:
  static std::string join(const std::string& file, const std::string& where, const std::string& message) {
    std::string text;
    if (!file.empty()) text += file + ": ";
    if (!where.empty()) text += where + ": ";
    return text + message;
  }
  std::string file_, where_, message_;
};

enum class Severity { note, warning, error };

/// One rule violation in a document. It is listed, not thrown.
struct Problem {
  std::string file;
  std::string pointer;  ///< JSON pointer such as /taxels/3/radius, or empty for the whole file
  Severity severity = Severity::error;
  std::string code;     ///< stable word such as "radius_not_positive"
  std::string message;  ///< one sentence with the offending value
  std::string fix;      ///< the remedy; may be empty
};
using Problems = std::vector<Problem>;

inline const char* to_string(Severity s) {
  switch (s) {
    case Severity::note:
      return "note";
    case Severity::warning:
      return "warning";
    case Severity::error:
      return "error";
  }
  return "error";
}

}  // namespace taxel
