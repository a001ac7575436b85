#include "core/run/fit/pressed_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/base/limits.h"
#include "core/base/text/expression.h"
#include "core/base/text/table.h"
#include "core/run/real/table_text.h"

namespace taxel {
namespace {

constexpr const char* kAxisNames[] = {"x", "y", "z"};
constexpr double kDeepest = 0.999;  // of the depth of a press, at which its loading part ends

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

PoseColumn parse_pose_column(const std::string& text) {
  const auto fail = [&](const std::string& why) {
    throw Error("", "--pose", fmt::format("\"{}\" {}; write it as x=0.001 mm or x=column*0.001 mm", text, why));
  };
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) fail("has no axis");
  const std::string axis = lower_case(trimmed(text.substr(0, equals)));
  PoseColumn column;
  const auto* const found = std::find(std::begin(kAxisNames), std::end(kAxisNames), axis);
  if (found == std::end(kAxisNames)) fail(fmt::format("names the axis \"{}\", not x, y or z", axis));
  column.axis = static_cast<int>(found - std::begin(kAxisNames));
  column.column = axis;
  std::string value = trimmed(text.substr(equals + 1));
  if (const std::size_t star = value.rfind('*'); star != std::string::npos) {
    column.column = trimmed(value.substr(0, star));
    value = trimmed(value.substr(star + 1));
  }
  try {
    if (value.find_first_not_of("+-.0123456789eE ") == std::string::npos) fail("has no unit");
    column.unit = evaluate(value, "m");
  } catch (const Error& e) {
    if (e.where() == "--pose") throw;
    fail(e.message());
  }
  if (column.unit == 0 || !std::isfinite(column.unit)) fail("must not be 0");
  return column;
}

/// A table and the numbers of its columns.
struct PressedTable {
  PressedTable(const std::string& text, const PressedOptions& options, const std::string& name)
      : file(name), table(split_table(text, options.mapping, name)), reader(table, options.mapping, file) {
    reader.check_widths();
  }
  const std::string& file;
  TextTable table;
  NumberReader reader;
};

/// A column with a position, found in the table.
struct FoundColumn {
  int axis;
  std::size_t place;
  double unit;  // [m]
};

double unit_of_head(const PressedTable& in, std::size_t place) {
  const std::string& head = in.table.columns[place];
  const std::string word = column_head(head).unit;
  const std::string pointer = fmt::format("column \"{}\"", head);
  if (word.empty())
    throw Error(in.file, pointer,
                fmt::format("has no unit: write it in the head, such as \"{} [mm]\", or give --pose \"{}=0.001 mm\"",
                            head, lower_case(column_head(head).name)));
  const std::optional<Quantity> unit = unit_named(word);
  if (!unit || !(unit->kind == kLength))
    throw Error(in.file, pointer, fmt::format("unit must be a length such as mm, is \"{}\"", word));
  return number_in(*unit, Quantity{1, 1, 0, kLength});
}

std::vector<FoundColumn> find_pose_columns(const PressedTable& in, const PressedOptions& options) {
  std::vector<FoundColumn> found;
  for (const PoseColumn& column : options.columns) {
    const std::size_t place = in.reader.column(column.column, "--pose");
    found.push_back({column.axis, place, column.unit != 0 ? column.unit : unit_of_head(in, place)});
  }
  if (options.columns.empty())
    for (std::size_t c = 0; c < in.table.columns.size(); ++c)
      for (int axis = 0; axis < 3; ++axis)
        if (lower_case(column_head(in.table.columns[c]).name) == kAxisNames[axis])
          found.push_back({axis, c, unit_of_head(in, c)});
  for (int axis = 0; axis < 3; ++axis)
    if (std::count_if(found.begin(), found.end(), [&](const FoundColumn& f) { return f.axis == axis; }) > 1)
      throw Error(in.file, fmt::format("several columns are the position along {}", kAxisNames[axis]));
  if (std::none_of(found.begin(), found.end(), [&](const FoundColumn& f) { return f.axis == options.axis; }))
    throw Error(in.file, fmt::format("has no column \"{0}\", along which the object presses: name it by --pose "
                                     "\"{0}=column*0.001 mm\", or the axis by --press-axis",
                                     kAxisNames[options.axis]));
  return found;
}

void read_displacements(const PressedTable& in, const std::vector<FoundColumn>& columns, PressedRecording& out) {
  out.displacements.resize(in.table.rows.size(), dvec3(0));
  for (const FoundColumn& column : columns) {
    for (std::size_t r = 0; r < in.table.rows.size(); ++r) {
      const CsvRow& row = in.table.rows[r];
      const double metres = times_unit(in.reader.at(row, column.place), std::abs(column.unit));
      if (std::isnan(metres)) in.reader.fail(row, column.place, "the position is missing");
      if (std::abs(metres) > kFarthest)
        in.reader.fail(row, column.place, fmt::format("must be at most {:g} m, is {}", kFarthest, metres));
      out.displacements[r][column.axis] = column.unit < 0 ? -metres : metres;
    }
  }
}

double range_along(const std::vector<dvec3>& points, int axis) {
  const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                               [&](const dvec3& a, const dvec3& b) { return a[axis] < b[axis]; });
  return (*high)[axis] - (*low)[axis];
}

/// The distance of the object from its rest along the pressing axis, for each row.
class Travel {
 public:
  Travel(const PressedTable& in, const std::vector<dvec3>& displacements, int axis)
      : points_(displacements), axis_(axis) {
    const auto [low, high] = std::minmax_element(points_.begin(), points_.end(),
                                                 [&](const dvec3& a, const dvec3& b) { return a[axis] < b[axis]; });
    range_ = (*high)[axis] - (*low)[axis];
    if (!(range_ > 0))
      throw Error(in.file, fmt::format("holds no press: the position along {} is {:g} m in all rows", kAxisNames[axis],
                                       points_.front()[axis] + 0.0));
    const double first = points_.front()[axis];
    rest_ = first - (*low)[axis] < (*high)[axis] - first ? (*low)[axis] : (*high)[axis];
  }
  [[nodiscard]] double at(std::size_t row) const { return std::abs(points_[row][axis_] - rest_); }
  [[nodiscard]] bool is_pressed(std::size_t row) const { return at(row) > kAtRest * range_; }

 private:
  const std::vector<dvec3>& points_;
  int axis_;
  double rest_ = 0, range_ = 0;
};

/// Returns the mean reading of a taxel over rows [first, end) without missing values; NaN if there are none.
double mean_over(const std::vector<double>& values, std::size_t first, std::size_t end) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t r = first; r < end; ++r)
    if (!std::isnan(values[r])) sum += values[r], ++count;
  return count > 0 ? sum / static_cast<double>(count) : std::numeric_limits<double>::quiet_NaN();
}

/// Cuts the rows into presses. A press without rest before it takes the rows of rest after it.
void cut_presses(const PressedTable& in, const Travel& travel, PressPart part, PressedRecording& out) {
  const std::size_t rows = out.displacements.size();
  std::size_t rest = 0;  // first row at rest since the last press
  for (std::size_t r = 0; r < rows;) {
    if (!travel.is_pressed(r)) {
      ++r;
      continue;
    }
    std::size_t end = r;
    while (end < rows && travel.is_pressed(end)) ++end;
    std::size_t low = std::max(rest, r > kBaselineRows ? r - kBaselineRows : 0), high = r;
    if (low == high)
      for (low = end, high = end; high < rows && high < low + kBaselineRows && !travel.is_pressed(high);) ++high;
    if (low == high)
      throw Error(in.file, fmt::format("line {}", in.table.rows[r].line),
                  "the recording has no row at rest before or after this press, so that its baseline is unknown");
    Press press{r, end, {}};
    for (const std::vector<double>& values : out.values) press.baseline.push_back(mean_over(values, low, high));
    if (part == PressPart::loading) {
      double deepest = 0;
      for (std::size_t i = r; i < end; ++i) deepest = std::max(deepest, travel.at(i));
      for (press.end = r; travel.at(press.end) < kDeepest * deepest;) ++press.end;
      ++press.end;
    }
    out.presses.push_back(std::move(press));
    rest = r = end;
  }
}

void check_pressed_rows(const std::string& text, const std::string& file) {
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  if (lines > kMostPressedRows)
    throw Error(file, fmt::format("has {} lines, more than {}: leave rows out, for example every second one", lines,
                                  kMostPressedRows));
}

}  // namespace

std::vector<PoseColumn> parse_pose_columns(const std::string& text) {
  std::vector<PoseColumn> columns;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    columns.push_back(parse_pose_column(trimmed(text.substr(begin, end - begin))));
    begin = end + 1;
  }
  return columns;
}

std::size_t PressedRecording::row_count() const {
  std::size_t count = 0;
  for (const Press& press : presses) count += press.end - press.first;
  return count;
}

PressedRecording parse_pressed_recording(const std::string& text, const PressedOptions& options,
                                         const std::string& file) {
  check_pressed_rows(text, file);
  if (options.mapping.taxels.empty())
    throw Error(file, "has no column for a taxel of the layout: name the columns in a mapping (--map)");
  const PressedTable in(text, options, file);
  PressedRecording out;
  out.file = file;
  out.notes = in.table.notes;
  const std::vector<FoundColumn> columns = find_pose_columns(in, options);
  read_displacements(in, columns, out);
  for (const TaxelColumn& taxel : options.mapping.taxels) {
    const std::size_t place = in.reader.column(taxel.column, fmt::format("taxel {}", taxel.taxel));
    out.taxel_ids.push_back(taxel.taxel);
    out.columns.push_back(taxel.column);
    std::vector<double>& values = out.values.emplace_back();
    values.reserve(in.table.rows.size());
    for (const CsvRow& row : in.table.rows)
      values.push_back(taxel.gain.value_or(options.mapping.gain) * in.reader.at(row, place) +
                       taxel.offset.value_or(options.mapping.offset));
  }
  cut_presses(in, Travel(in, out.displacements, options.axis), options.part, out);
  double widest = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const double range = axis == options.axis ? -1 : range_along(out.displacements, axis);
    if (range > widest) widest = range, out.lateral_axis = axis;
  }
  return out;
}

}  // namespace taxel
