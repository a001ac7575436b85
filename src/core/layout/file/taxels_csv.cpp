#include "core/layout/file/taxels_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>

#include "core/base/error.h"
#include "core/base/text/csv.h"

namespace taxel {
namespace {

template <class T>
void append_row(std::string& text, std::int64_t index, const T& disc, const std::string& parent,
                const std::string& name, bool has_normal) {
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{},{},{},{},", index, disc.center.x, disc.center.y, disc.center.z);
  if (has_normal) fmt::format_to(out, "{},{},{},", disc.normal.x, disc.normal.y, disc.normal.z);
  fmt::format_to(out, "{},{},{}\n", disc.radius, csv_field(parent), csv_field(name));
}

template <class T>
void check_finite_disc(const T& disc, int taxel) {
  if (!is_finite(disc.center) || !is_finite(disc.normal) || !std::isfinite(disc.radius))
    throw Error("", fmt::format("taxel {}", taxel), "must be finite to be written");
}

std::optional<double> to_number(const std::string& text) {
  double v = 0;
  const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const auto read = std::from_chars(begin, text.data() + text.size(), v);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size() || !std::isfinite(v)) return std::nullopt;
  return v;
}

enum Column { kIndex, kX, kY, kZ, kNormX, kNormY, kNormZ, kRadius, kParent, kName, kColumns };

struct ColumnName {
  const char* word;
  Column column;
};
constexpr ColumnName kColumnNames[] = {{"index", kIndex},
                                       {"id", kIndex},
                                       {"taxel", kIndex},
                                       {"x", kX},
                                       {"y", kY},
                                       {"z", kZ},
                                       {"normx", kNormX},
                                       {"normy", kNormY},
                                       {"normz", kNormZ},
                                       {"nx", kNormX},
                                       {"ny", kNormY},
                                       {"nz", kNormZ},
                                       {"radius", kRadius},
                                       {"r", kRadius},
                                       {"parent", kParent},
                                       {"name", kName},
                                       {"object name in blender", kName}};
constexpr const char* kShownNames[] = {"Index", "X", "Y", "Z", "NormX", "NormY", "NormZ", "Radius", "Parent", "Name"};

std::string lower_case_field(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

class Table {
 public:
  Table(const std::string& text, const std::string& file, double unit)
      : rows_(parse_csv(text, file)), file_(file), unit_(unit) {
    if (rows_.empty()) throw Error(file_, "holds no table");
    std::fill(std::begin(at_), std::end(at_), -1);
    const std::vector<std::string>& head = rows_.front().fields;
    headless_ = std::all_of(head.begin(), head.end(), [](const std::string& field) { return to_number(field); });
    if (headless_)
      for (std::size_t i = 0; i < std::min<std::size_t>(head.size(), 6); ++i) at_[kX + i] = static_cast<int>(i);
    else
      read_head(rows_.front());
    for (const Column column : {kX, kY, kZ})
      if (at_[column] < 0) fail(rows_.front(), column, "is missing");
    const bool some = has(kNormX) || has(kNormY) || has(kNormZ);
    for (const Column column : {kNormX, kNormY, kNormZ})
      if (some && !has(column)) fail(rows_.front(), column, "is missing: a normal has three");
  }

  CsvTaxels read() {
    CsvTaxels out{{}, has(kNormX), has(kRadius)};
    for (std::size_t i = headless_ ? 0 : 1; i < rows_.size(); ++i) read_row(rows_[i], out);
    if (out.taxels.empty()) throw Error(file_, "holds no taxel");
    return out;
  }

 private:
  [[nodiscard]] bool has(Column column) const { return at_[column] >= 0; }
  [[noreturn]] void fail(const CsvRow& row, Column column, const std::string& message) const {
    throw Error(file_, fmt::format("line {}, column {}", row.line, kShownNames[column]), message);
  }

  void read_head(const CsvRow& head) {
    for (std::size_t i = 0; i < head.fields.size(); ++i)
      for (const ColumnName& name : kColumnNames) {
        if (lower_case_field(head.fields[i]) != name.word) continue;
        if (has(name.column)) fail(head, name.column, "is in the header twice");
        at_[name.column] = static_cast<int>(i);
      }
  }
  /// Returns the text of a cell, empty if the row is too short.
  [[nodiscard]] std::string field(const CsvRow& row, Column column) const {
    const auto i = static_cast<std::size_t>(at_[column]);
    return has(column) && i < row.fields.size() ? row.fields[i] : "";
  }
  [[nodiscard]] double number(const CsvRow& row, Column column) const {
    const std::string text = field(row, column);
    if (text.empty()) fail(row, column, "is missing");
    const std::optional<double> v = to_number(text);
    if (!v) fail(row, column, fmt::format("must be a number, is \"{}\"", text));
    return *v;
  }
  [[nodiscard]] int whole_number(const CsvRow& row, Column column) const {
    const double v = number(row, column);
    if (v != std::floor(v) || std::abs(v) > std::numeric_limits<int>::max())
      fail(row, column, fmt::format("must be a whole number, is \"{}\"", field(row, column)));
    return static_cast<int>(v);
  }

  template <class T>
  void read_disc(const CsvRow& row, T& disc) const {
    disc.center = unit_ * dvec3(number(row, kX), number(row, kY), number(row, kZ));
    if (has(kNormX)) disc.normal = dvec3(number(row, kNormX), number(row, kNormY), number(row, kNormZ));
    if (has(kRadius)) disc.radius = unit_ * number(row, kRadius);
  }

  void read_row(const CsvRow& row, CsvTaxels& out) const {
    std::vector<Taxel>& taxels = out.taxels;
    const std::string named = field(row, kParent);
    const bool is_prim = named.starts_with('/');
    const int parent = named.empty() || is_prim ? -1 : whole_number(row, kParent);
    if (parent != -1) {
      const auto found =
          std::find_if(taxels.begin(), taxels.end(), [&](const Taxel& taxel) { return taxel.id == parent; });
      if (found == taxels.end()) fail(row, kParent, fmt::format("no row before has the Index {}", parent));
      Subtaxel subtaxel;
      subtaxel.radius = found->radius;
      read_disc(row, subtaxel);
      found->subtaxels.push_back(subtaxel);
      return;
    }
    Taxel taxel;
    taxel.id = field(row, kIndex).empty() ? static_cast<int>(taxels.size()) : whole_number(row, kIndex);
    taxel.name = field(row, kName);
    read_disc(row, taxel);
    taxels.push_back(std::move(taxel));
    out.prims.push_back(is_prim ? named : "");
  }

  std::vector<CsvRow> rows_;
  std::string file_;
  double unit_;
  int at_[kColumns];  ///< index of each column, -1 if it is missing
  bool headless_ = false;
};

}  // namespace

std::string taxels_to_csv(const std::vector<Taxel>& taxels, const CsvStyle& style) {
  std::string text =
      style.normals ? "Index,X,Y,Z,NormX,NormY,NormZ,Radius,Parent,Name\n" : "Index,X,Y,Z,Radius,Parent,Name\n";
  std::int64_t next = 0;
  for (const Taxel& taxel : taxels) next = std::max<std::int64_t>(next, std::int64_t{taxel.id} + 1);
  for (const Taxel& taxel : taxels) {
    check_finite_disc(taxel, taxel.id);
    append_row(text, taxel.id, taxel, style.parent, taxel.name, style.normals);
    for (const Subtaxel& subtaxel : taxel.subtaxels) {
      check_finite_disc(subtaxel, taxel.id);
      append_row(text, next++, subtaxel, fmt::format("{}", taxel.id), "", style.normals);
    }
  }
  return text;
}

CsvTaxels parse_taxels_csv(const std::string& text, const std::string& file, double unit) {
  return Table(text, file, unit).read();
}

}  // namespace taxel
