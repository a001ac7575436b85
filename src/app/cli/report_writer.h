// Writer of the JSON objects that commands print with --json, independent of the JSON library.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "app/cli/console.h"
#include "core/base/math.h"

namespace taxel::cli {

/// Layout of the printed text. Every command keeps the layout that its readers know.
enum class JsonStyle {
  indented,        ///< two spaces for each level, every value on a line of its own
  short_arrays,    ///< two spaces for each level, arrays of plain values on one line
  narrow_indents,  ///< one space for each level, every value on a line of its own
  one_line         ///< no line breaks but the one at the end
};

/// Builds one JSON object. Keys keep the order of the calls. Lengths, forces and pressures are in SI units. Numbers
/// that are not finite become null, and bytes that are not UTF-8 (in names of files) become replacement characters.
class ReportWriter {
 public:
  ReportWriter();
  ~ReportWriter();
  ReportWriter(const ReportWriter&) = delete;
  ReportWriter& operator=(const ReportWriter&) = delete;

  /// Adds a text, bool, number, vector or null, an optional of them (null if it is empty), or an array of them.
  template <class T>
  void operator()(std::string_view key, const T& value) {
    if constexpr (std::is_same_v<T, std::nullptr_t> || std::is_same_v<T, bool>) {
      put(key, value);
    } else if constexpr (std::is_convertible_v<const T&, std::string_view>) {
      put(key, std::string_view(value));
    } else if constexpr (std::is_floating_point_v<T>) {
      put(key, static_cast<double>(value));
    } else if constexpr (std::is_integral_v<T>) {
      put(key, static_cast<std::conditional_t<std::is_signed_v<T>, std::int64_t, std::uint64_t>>(value));
    } else if constexpr (std::is_same_v<T, dvec3>) {
      (*this)(key, std::array{value.x, value.y, value.z});
    } else if constexpr (std::is_same_v<T, dvec2>) {
      (*this)(key, std::array{value.x, value.y});
    } else if constexpr (requires { value.has_value(); }) {
      value ? (*this)(key, *value) : put(key, nullptr);
    } else {
      open(key, Kind::array);
      for (const auto& item : value) (*this)({}, item);
      close();
    }
  }
  /// Adds an object whose keys write(*this) adds.
  template <class Write>
  void object(std::string_view key, const Write& write) {
    open(key, Kind::object);
    write(*this);
    close();
  }
  /// Adds an array with an object for each item, whose keys write(*this, item) adds.
  template <class Items, class Write>
  void list(std::string_view key, const Items& items, const Write& write) {
    open(key, Kind::array);
    for (const auto& item : items) object({}, [&](ReportWriter& w) { write(w, item); });
    close();
  }
  /// Adds all keys of the object in a JSON text, which must be valid.
  void keys_of(const std::string& json_text);

  /// Returns the whole object as text with a newline at its end.
  [[nodiscard]] std::string text(JsonStyle style = JsonStyle::indented) const;

 private:
  using Scalar = std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string_view>;
  enum class Kind { object, array };
  void put(std::string_view key, const Scalar& value);
  void open(std::string_view key, Kind kind);
  void close();

  struct Tree;
  std::unique_ptr<Tree> tree_;
};

/// Returns a report as JSON text. A report has the functions visit(ReportWriter&) and text().
template <class Report>
std::string json_of(const Report& report, JsonStyle style = JsonStyle::indented) {
  ReportWriter writer;
  report.visit(writer);
  return writer.text(style);
}

/// Prints a report to stdout: as JSON with --json, otherwise as text. Throws Error if stdout cannot be written.
template <class Report>
void print_report(Console& console, const Report& report, JsonStyle style = JsonStyle::indented) {
  console.result(console.json() ? json_of(report, style) : report.text());
}

}  // namespace taxel::cli
