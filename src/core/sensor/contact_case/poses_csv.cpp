#include <fmt/format.h>

#include <array>
#include <iterator>

#include "core/base/error.h"
#include "core/base/limits.h"
#include "core/base/text/expression.h"
#include "core/base/text/table.h"
#include "core/sensor/contact_case/contact_case.h"
#include "core/sensor/contact_case/pose_readings.h"

namespace taxel {
namespace {

constexpr std::array<const char*, 7> kPoseColumns{"x", "y", "z", "qw", "qx", "qy", "qz"};
constexpr std::size_t kLengths = 3;

/// A table of poses: the places of its columns, the units of its lengths, and its rows.
class PoseTable {
 public:
  PoseTable(const std::string& text, const std::string& file)
      : file_(file), form_(guess_table_form(text)), rows_(split_rows(text, file, form_.separator)) {
    if (rows_.empty()) throw Error(file_, "holds no pose: the table is empty");
    places_.fill(-1);
    units_.fill(1.0);
    const std::vector<std::string>& heads = rows_.front().fields;
    for (std::size_t i = 0; i < heads.size(); ++i) read_head(heads[i], static_cast<int>(i));
    for (std::size_t c = 0; c < kPoseColumns.size(); ++c)
      if (places_[c] < 0) fail(rows_.front(), c, missing_text(c));
    if (rows_.size() < 2) throw Error(file_, "holds no pose: the table has no row below its heads");
  }

  [[nodiscard]] std::vector<Pose> poses() const {
    std::vector<Pose> poses;
    poses.reserve(rows_.size() - 1);
    for (std::size_t i = 1; i < rows_.size(); ++i) poses.push_back(pose(rows_[i]));
    return poses;
  }
  [[nodiscard]] const std::vector<std::string>& unread() const { return unread_; }

 private:
  [[noreturn]] void fail(const CsvRow& row, std::size_t column, const std::string& why) const {
    throw Error(file_, fmt::format("line {}, column {}", row.line, kPoseColumns[column]), why);
  }
  static std::string missing_text(std::size_t column) {
    if (column < kLengths) return "is missing: a pose has x, y and z";
    return "is missing: a pose has the quaternion qw, qx, qy, qz, which is 1, 0, 0, 0 without rotation";
  }

  void read_head(const std::string& text, int place) {
    const ColumnHead head = column_head(text);
    const std::string name = lower_case(head.name);
    for (std::size_t c = 0; c < kPoseColumns.size(); ++c) {
      if (name != kPoseColumns[c]) continue;
      if (places_[c] >= 0) fail(rows_.front(), c, "is in the table twice");
      places_[c] = place;
      if (!head.unit.empty()) units_[c] = unit_of(c, head.unit);
      return;
    }
    unread_.push_back(text);
  }
  /// Returns the factor of the unit of a column to metres.
  [[nodiscard]] double unit_of(std::size_t column, const std::string& word) const {
    if (column >= kLengths) fail(rows_.front(), column, fmt::format("a quaternion has no unit, is in \"{}\"", word));
    const std::optional<Quantity> unit = unit_named(word);
    if (!unit || !(unit->kind == kLength))
      fail(rows_.front(), column, fmt::format("unit must be a length such as mm, is \"{}\"", word));
    return number_in(*unit, Quantity{1, 1, 0, kLength});
  }

  [[nodiscard]] double number(const CsvRow& row, std::size_t column) const {
    const auto place = at(places_[column]);
    if (place >= row.fields.size() || is_missing(row.fields[place])) {
      fail(row, column,
           place < row.fields.size() && !row.fields[place].empty()
               ? fmt::format("must be a finite number, is \"{}\"", row.fields[place])
               : "is missing");
    }
    const std::optional<double> value = number_of(row.fields[place], form_.decimal);
    if (!value) fail(row, column, fmt::format("must be a finite number, is \"{}\"", row.fields[place]));
    return *value;
  }
  [[nodiscard]] double length(const CsvRow& row, std::size_t column) const {
    const double metres = times_unit(number(row, column), units_[column]);
    if (std::abs(metres) > kFarthest)
      fail(row, column, fmt::format("must be at most {:g} m, is {}", kFarthest, metres));
    return metres;
  }
  [[nodiscard]] Pose pose(const CsvRow& row) const {
    const std::array<double, 7> n{length(row, 0), length(row, 1), length(row, 2), number(row, 3),
                                  number(row, 4), number(row, 5), number(row, 6)};
    try {
      return poses_from_rows(n).front();
    } catch (const Error& e) {
      fail(row, kLengths, e.message());
    }
  }

  const std::string& file_;
  TableForm form_;
  std::vector<CsvRow> rows_;
  std::array<int, 7> places_{};
  std::array<double, 7> units_{};
  std::vector<std::string> unread_;
};

}  // namespace

std::vector<Pose> parse_poses_csv(const std::string& text, const std::string& file, std::vector<std::string>* unread) {
  const PoseTable table(utf8_text(text), file);
  if (unread != nullptr) *unread = table.unread();
  return table.poses();
}

std::string pose_readings_to_csv(const Layout& layout, std::span<const Pose> poses, const PoseReadings& readings) {
  std::string text = "x,y,z,qw,qx,qy,qz,force_x,force_y,force_z,torque_x,torque_y,torque_z,area";
  auto out = std::back_inserter(text);
  for (const Taxel& taxel : layout.taxels) fmt::format_to(out, ",taxel_{}", taxel.id);
  text += '\n';
  const std::size_t taxels = at(readings.taxels);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Pose& X = poses[i];
    fmt::format_to(out, "{},{},{},{},{},{},{}", X.p.x, X.p.y, X.p.z, X.q.w, X.q.x, X.q.y, X.q.z);
    for (std::size_t k = 0; k < 6; ++k) fmt::format_to(out, ",{}", readings.wrenches[6 * i + k]);
    fmt::format_to(out, ",{}", readings.areas[i]);
    for (std::size_t k = 0; k < taxels; ++k) fmt::format_to(out, ",{}", readings.readings[taxels * i + k]);
    text += '\n';
  }
  return text;
}

}  // namespace taxel
