#include "core/layout/file/taxels_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>

#include "core/base/error.h"
#include "core/base/text/expression.h"
#include "core/base/text/table.h"

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

enum Column {
  kIndex,
  kX,
  kY,
  kZ,
  kNormX,
  kNormY,
  kNormZ,
  kRadius,
  kParent,
  kName,
  kQuatX,
  kQuatY,
  kQuatZ,
  kQuatW,
  kColumns
};

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
                                       {"object name in blender", kName},
                                       {"px", kX},
                                       {"py", kY},
                                       {"pz", kZ},
                                       {"pos_x", kX},
                                       {"pos_y", kY},
                                       {"pos_z", kZ},
                                       {"normal_x", kNormX},
                                       {"normal_y", kNormY},
                                       {"normal_z", kNormZ},
                                       {"qx", kQuatX},
                                       {"qy", kQuatY},
                                       {"qz", kQuatZ},
                                       {"qw", kQuatW}};
constexpr const char* kShownNames[] = {"Index",  "X",      "Y",    "Z",  "NormX", "NormY", "NormZ",
                                       "Radius", "Parent", "Name", "QX", "QY",    "QZ",    "QW"};
constexpr Column kNormals[] = {kNormX, kNormY, kNormZ}, kQuaternion[] = {kQuatX, kQuatY, kQuatZ, kQuatW};

class Table {
 public:
  Table(const std::string& text, const std::string& file, double unit)
      : form_(guess_table_form(text)), rows_(split_rows(text, file, form_.separator)), file_(file) {
    if (rows_.empty()) throw Error(file_, "holds no table");
    std::fill(std::begin(at_), std::end(at_), -1);
    std::fill(std::begin(factor_), std::end(factor_), unit);
    const std::vector<std::string>& head = rows_.front().fields;
    headless_ = std::all_of(head.begin(), head.end(),
                            [&](const std::string& field) { return number_of(field, form_.decimal).has_value(); });
    if (headless_)
      for (std::size_t i = 0; i < std::min<std::size_t>(head.size(), 6); ++i) at_[kX + i] = static_cast<int>(i);
    else
      read_head(rows_.front());
    for (const Column column : {kX, kY, kZ})
      if (at_[column] < 0) fail(rows_.front(), column, "is missing");
    require_all(kNormals, "is missing: a normal has three");
    require_all(kQuaternion, "is missing: a quaternion has four");
    if (has(kNormX) && has(kQuatX)) fail(rows_.front(), kQuatX, "is not read together with a normal: leave one out");
  }

  CsvTaxels read() {
    CsvTaxels out{{}, has(kNormX) || has(kQuatX), has(kRadius)};
    out.has_units = has_units_;
    for (std::size_t i = headless_ ? 0 : 1; i < rows_.size(); ++i) read_row(rows_[i], out);
    if (out.taxels.empty()) throw Error(file_, "holds no taxel");
    const std::vector<std::string>& head = rows_.front().fields;
    for (std::size_t i = 0; i < head.size(); ++i)
      if (std::find(std::begin(at_), std::end(at_), static_cast<int>(i)) == std::end(at_))
        out.unread.push_back(headless_ ? fmt::format("#{}", i + 1) : head[i]);
    return out;
  }

 private:
  [[nodiscard]] bool has(Column column) const { return at_[column] >= 0; }
  [[noreturn]] void fail(const CsvRow& row, Column column, const std::string& message) const {
    throw Error(file_, fmt::format("line {}, column {}", row.line, kShownNames[column]), message);
  }

  /// Throws Error if some of the columns are there and others are missing.
  template <class Columns>
  void require_all(const Columns& columns, const std::string& message) const {
    const bool has_some = std::any_of(std::begin(columns), std::end(columns), [&](Column c) { return has(c); });
    for (const Column column : columns)
      if (has_some && !has(column)) fail(rows_.front(), column, message);
  }

  void read_head(const CsvRow& head) {
    for (std::size_t i = 0; i < head.fields.size(); ++i) {
      const std::string whole = lower_case(head.fields[i]);
      const ColumnHead parts = column_head(head.fields[i]);
      for (const ColumnName& name : kColumnNames) {
        const bool is_whole = whole == name.word;
        if (!is_whole && lower_case(parts.name) != name.word) continue;
        if (has(name.column)) fail(head, name.column, "is in the header twice");
        at_[name.column] = static_cast<int>(i);
        if (!is_whole) read_unit(head, name.column, parts.unit);
        break;
      }
    }
  }
  /// Reads the unit in the head of a column of lengths. Normals, quaternions and words have none.
  void read_unit(const CsvRow& head, Column column, const std::string& text) {
    const bool is_length = (column >= kX && column <= kZ) || column == kRadius;
    if (!is_length || text.empty()) return;
    const std::string word = text == "inch" || text == "inches" ? "in" : text;
    const std::optional<Quantity> unit = unit_named(word);
    if (!unit || !(unit->kind == kLength))
      fail(head, column, fmt::format("unit must be a length such as mm, is \"{}\"", text));
    factor_[column] = number_in(*unit, Quantity{1, 1, 0, kLength});
    has_units_ = true;
  }
  /// Returns the text of a cell, empty if the row is too short.
  [[nodiscard]] std::string field(const CsvRow& row, Column column) const {
    const auto i = static_cast<std::size_t>(at_[column]);
    return has(column) && i < row.fields.size() ? row.fields[i] : "";
  }
  [[nodiscard]] double number(const CsvRow& row, Column column) const {
    const std::string text = field(row, column);
    if (text.empty()) fail(row, column, "is missing");
    const std::optional<double> v = number_of(text, form_.decimal);
    if (!v) fail(row, column, fmt::format("must be a number, is \"{}\"", text));
    return *v;
  }
  [[nodiscard]] int whole_number(const CsvRow& row, Column column) const {
    const double v = number(row, column);
    if (v != std::floor(v) || std::abs(v) > std::numeric_limits<int>::max())
      fail(row, column, fmt::format("must be a whole number, is \"{}\"", field(row, column)));
    return static_cast<int>(v);
  }

  [[nodiscard]] double length(const CsvRow& row, Column column) const {
    return times_unit(number(row, column), factor_[column]);
  }
  /// Returns the z axis of the row's quaternion.
  [[nodiscard]] dvec3 axis_of(const CsvRow& row) const {
    const dquat q(number(row, kQuatW), number(row, kQuatX), number(row, kQuatY), number(row, kQuatZ));
    if (!(std::abs(glm::length(q) - 1) < 0.01))
      fail(row, kQuatX, fmt::format("the quaternion must have length 1, has {:.4g}", glm::length(q)));
    return glm::normalize(q) * dvec3(0, 0, 1);
  }

  template <class T>
  void read_disc(const CsvRow& row, T& disc) const {
    disc.center = {length(row, kX), length(row, kY), length(row, kZ)};
    if (has(kNormX)) disc.normal = dvec3(number(row, kNormX), number(row, kNormY), number(row, kNormZ));
    if (has(kQuatX)) disc.normal = axis_of(row);
    if (has(kRadius)) disc.radius = length(row, kRadius);
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

  TableForm form_;
  std::vector<CsvRow> rows_;
  std::string file_;
  int at_[kColumns];         ///< index of each column, -1 if it is missing
  double factor_[kColumns];  ///< length of the unit of each column [m]
  bool headless_ = false, has_units_ = false;
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
  return Table(utf8_text(text), file, unit).read();
}

}  // namespace taxel
