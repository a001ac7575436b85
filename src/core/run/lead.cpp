#include "core/run/lead.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text/expression.h"
#include "core/base/text/words.h"
#include "core/run/real/table_text.h"
#include "core/run/recording/recording_files.h"
#include "core/run/rows_around.h"

namespace taxel {

double control_at(const ControlTrack& track, double time) {
  const RowsAround rows = rows_around(track.times, time);
  return (1 - rows.fraction) * track.values[rows.before] + rows.fraction * track.values[rows.after];
}

dvec3 position_at(const MocapTrack& track, double time) {
  const RowsAround rows = rows_around(track.times, time);
  return (1 - rows.fraction) * track.positions_W[rows.before] + rows.fraction * track.positions_W[rows.after];
}

dquat rotation_at(const MocapTrack& track, double time) {
  const RowsAround rows = rows_around(track.times, time);
  const dquat &before = track.rotations_WB[rows.before], &after = track.rotations_WB[rows.after];
  if (rows.fraction == 0) return before;
  if (rows.fraction == 1) return after;
  return glm::normalize(glm::slerp(before, after, rows.fraction));
}

double end_of(const SceneLead& lead) {
  double end = 0;
  for (const ControlTrack& track : lead.controls) end = std::max(end, track.times.back());
  for (const MocapTrack& track : lead.mocaps) end = std::max(end, track.times.back());
  return end;
}

long steps_of(const SceneLead& lead, double timestep) {
  constexpr double kRounding = 1e-6;  // of a step: times of files are rounded
  constexpr double kMost = 1e15;      // more than any run has
  return std::lround(std::min(kMost, std::ceil(end_of(lead) / timestep - kRounding))) + 1;
}

std::string quoted_list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += fmt::format("{}\"{}\"", text.empty() ? "" : ", ", name);
  return text;
}

std::string meant_name(const std::string& word, const std::vector<std::string>& names) {
  const std::vector<std::string_view> words(names.begin(), names.end());
  return meant_word(word, words);
}

namespace {

constexpr std::array<std::string_view, 7> kCoordinates{"x", "y", "z", "qw", "qx", "qy", "qz"};
constexpr double kMaxLengthError = 0.01;  // of a quaternion, relative

/// Returns the number with a unit in SI.
double number_in_si(double number, const Quantity& unit) {
  const double power = std::pow(10.0, std::abs(unit.decimal));
  return unit.decimal < 0 ? number * unit.number * unit.factor / power : number * unit.number * unit.factor * power;
}

/// A table with a column of times, all of whose other columns are numbers.
class LeadTable {
 public:
  /// `wanted` says which columns the table needs apart from the time.
  LeadTable(const std::string& text, const std::string& file, const std::string& wanted)
      : file_(file), table_(split(text, wanted)), reader_(table_, mapping_, file_) {
    reader_.check_widths();
    const auto is_exact = [](const std::string& column) {
      const std::string head = lower_case(column_head(column).name);
      return head == "time" || head == "t";
    };
    auto named = std::find_if(table_.columns.begin(), table_.columns.end(), is_exact);
    if (named == table_.columns.end()) named = std::find_if(table_.columns.begin(), table_.columns.end(), names_time);
    if (named == table_.columns.end())
      throw Error(file_, fmt::format("has no column of times: name one \"time\" or \"t\"; there are {}",
                                     reader_.names_without({})));
    time_ = static_cast<std::size_t>(named - table_.columns.begin());
    set_time_unit();
    notes = table_.notes;
    times = reader_.times(time_, notes);
    for (std::size_t i = 1; i < times.size(); ++i)
      if (!(times[i] > times[i - 1]))
        reader_.fail(
            table_.rows[i], time_,
            fmt::format("the row before has the same time, {:.9g} s: for a jump, add a little to this time", times[i]));
  }
  [[nodiscard]] std::size_t width() const { return table_.columns.size(); }
  [[nodiscard]] bool is_time(std::size_t column) const { return column == time_; }
  [[nodiscard]] const std::string& name(std::size_t column) const { return table_.columns[column]; }
  [[nodiscard]] int line(std::size_t row) const { return table_.rows[row].line; }
  [[noreturn]] void fail(std::size_t column, const std::string& why) const {
    throw Error(file_, fmt::format("column \"{}\"", name(column)), why);
  }
  [[noreturn]] void fail(std::size_t row, std::size_t column, const std::string& why) const {
    reader_.fail(table_.rows[row], column, why);
  }
  /// Returns the numbers of a column, in SI if its name ends in a unit and `has_unit`.
  [[nodiscard]] std::vector<double> numbers(std::size_t column, bool has_unit, std::optional<Kind> kind = {}) const {
    Quantity unit{1, 1, 0, kPlain};
    if (const std::string word = column_head(name(column)).unit; has_unit && !word.empty()) {
      const std::optional<Quantity> found = unit_named(word);
      if (!found) fail(column, fmt::format("the unit \"{}\" is not known", word));
      if (kind && !(found->kind == *kind)) fail(column, fmt::format("\"{}\" must be {}", word, name_of(*kind)));
      unit = *found;
    }
    std::vector<double> values;
    for (std::size_t r = 0; r < table_.rows.size(); ++r) {
      const double value = reader_.at(table_.rows[r], column);
      if (std::isnan(value)) fail(r, column, "the value is missing: every row needs all values");
      values.push_back(number_in_si(value, unit));
    }
    return values;
  }

  std::vector<double> times;  // of the rows [s]
  std::vector<std::string> notes;

 private:
  TextTable split(const std::string& bytes, const std::string& wanted) {
    const std::string text = utf8_text(bytes);
    const TableForm form = guess_table_form(text);
    mapping_.separator = std::string(1, form.separator);
    mapping_.decimal = std::string(1, form.decimal);
    if (form.header_lines == 0)
      throw Error(file_, "line 1", "is not a header: the first line must name the columns, time and " + wanted);
    mapping_.header_lines = 1;
    TextTable table = split_table(text, mapping_, file_);
    if (form.header_lines == 1 || std::any_of(table.columns.begin(), table.columns.end(), names_time)) return table;
    mapping_.header_lines = form.header_lines;
    return split_table(text, mapping_, file_);
  }
  void set_time_unit() {
    const std::string unit = column_head(name(time_)).unit;
    const auto found = std::find(kTimeUnitWords.begin(), kTimeUnitWords.end(), unit);
    if (!unit.empty() && found == kTimeUnitWords.end())
      fail(time_, fmt::format("the unit must be s, ms, us or ns, is \"{}\"", unit));
    if (!unit.empty()) mapping_.time_unit = static_cast<TimeUnit>(found - kTimeUnitWords.begin());
  }

  std::string file_;
  ColumnMapping mapping_;
  TextTable table_;
  NumberReader reader_;
  std::size_t time_ = 0;
};

/// A column that names something of the scene.
struct NamedColumn {
  std::size_t index = 0;  // in the list of names
  bool has_unit = false;  // the column has the name followed by a unit
};

/// Finds the name of a column in a list, with or without a unit.
std::optional<NamedColumn> find_name(const std::string& column, const std::vector<std::string>& names) {
  for (const bool has_unit : {false, true}) {
    const auto found = std::find(names.begin(), names.end(), has_unit ? column_head(column).name : column);
    if (found != names.end()) return NamedColumn{static_cast<std::size_t>(found - names.begin()), has_unit};
  }
  return std::nullopt;
}

/// Adds a note if MuJoCo clamps values of a track to the range of the actuator.
void note_clamped(const LeadTable& table, const ControlTrack& track, const SceneActuator& actuator, SceneLead& lead) {
  if (!actuator.range) return;
  const auto [low, high] = *actuator.range;
  const auto is_outside = [&](double value) { return value < low || value > high; };
  const auto count = std::count_if(track.values.begin(), track.values.end(), is_outside);
  if (count == 0) return;
  const auto first = std::find_if(track.values.begin(), track.values.end(), is_outside);
  lead.notes.push_back(fmt::format(
      "actuator \"{}\": {} of {} values are outside of its range, {} to {}, and are clamped: the first is {} "
      "in line {}",
      actuator.name, count, track.values.size(), low, high, *first,
      table.line(static_cast<std::size_t>(first - track.values.begin()))));
}

/// The columns of one mocap body, in the order of kCoordinates.
using PoseColumns = std::array<std::optional<NamedColumn>, kCoordinates.size()>;

void need_columns(const PoseColumns& columns, std::size_t first, std::size_t last, const std::string& prefix,
                  const std::string& file) {
  for (std::size_t c = first; c < last; ++c)
    if (!columns[c])
      throw Error(file, fmt::format("column \"{}{}\"", prefix, kCoordinates[c]),
                  first == 0 ? "is missing: a led body needs x, y and z"
                             : "is missing: a led orientation needs qw, qx, qy and qz");
}

/// Returns the unit quaternions of four columns.
std::vector<dquat> rotations_of(const LeadTable& table, const PoseColumns& columns) {
  std::array<std::vector<double>, 4> parts;
  for (std::size_t c = 0; c < 4; ++c) parts[c] = table.numbers(columns[c + 3]->index, false);
  std::vector<dquat> rotations;
  for (std::size_t r = 0; r < table.times.size(); ++r) {
    const dquat q(parts[0][r], parts[1][r], parts[2][r], parts[3][r]);
    const double length = glm::length(q);
    if (!(std::abs(length - 1) <= kMaxLengthError))
      table.fail(r, columns[3]->index,
                 fmt::format("the quaternion qw, qx, qy, qz must have the length 1 within 1 %, has {:.6g}", length));
    rotations.push_back(q / length);
  }
  return rotations;
}

MocapTrack track_of(const LeadTable& table, const PoseColumns& columns, int mocap, const std::string& prefix,
                    const std::string& file) {
  need_columns(columns, 0, 3, prefix, file);
  MocapTrack track{mocap, table.times, std::vector<dvec3>(table.times.size()), {}};
  for (std::size_t c = 0; c < 3; ++c) {
    const std::vector<double> values = table.numbers(columns[c]->index, columns[c]->has_unit, kLength);
    for (std::size_t r = 0; r < values.size(); ++r) track.positions_W[r][static_cast<int>(c)] = values[r];
  }
  const bool turns = std::any_of(columns.begin() + 3, columns.end(), [](const auto& column) { return column; });
  if (!turns) return track;
  need_columns(columns, 3, columns.size(), prefix, file);
  track.rotations_WB = rotations_of(table, columns);
  return track;
}

}  // namespace

void add_controls(SceneLead& lead, const std::string& text, const SceneControls& scene, const std::string& file) {
  std::vector<std::string> names;
  for (const SceneActuator& actuator : scene.actuators) names.push_back(actuator.name);
  if (names.empty()) throw Error(file, "leads actuators, but the scene has none");
  const LeadTable table(text, file, "actuators: " + quoted_list(names));
  lead.notes.insert(lead.notes.end(), table.notes.begin(), table.notes.end());
  std::vector<bool> is_led(names.size());
  for (std::size_t c = 0; c < table.width(); ++c) {
    if (table.is_time(c)) continue;
    const std::optional<NamedColumn> found = find_name(table.name(c), names);
    if (!found)
      table.fail(c, fmt::format("names no actuator of the scene; there are {}{}", quoted_list(names),
                                meant_name(table.name(c), names)));
    if (is_led[found->index]) table.fail(c, "leads the same actuator as another column");
    is_led[found->index] = true;
    lead.controls.push_back({static_cast<int>(found->index), table.times, table.numbers(c, found->has_unit)});
    note_clamped(table, lead.controls.back(), scene.actuators[found->index], lead);
  }
  if (std::none_of(is_led.begin(), is_led.end(), [](bool led) { return led; }))
    throw Error(file, "has no column apart from the times: add a column for an actuator, " + quoted_list(names));
}

void add_mocaps(SceneLead& lead, const std::string& text, const SceneControls& scene, const std::string& file) {
  if (scene.mocaps.empty())
    throw Error(file, "leads mocap bodies, but the scene has none (a body with mocap=\"true\")");
  const std::string wanted =
      fmt::format("BODY_x, BODY_y, BODY_z, and BODY_qw, _qx, _qy, _qz for an orientation; the {} {}",
                  scene.mocaps.size() > 1 ? "mocap bodies are" : "mocap body is", quoted_list(scene.mocaps));
  const LeadTable table(text, file, wanted);
  lead.notes.insert(lead.notes.end(), table.notes.begin(), table.notes.end());
  std::vector<std::string> names;  // seven for each mocap body; those of a single body without prefix, too
  for (const std::string& body : scene.mocaps)
    for (const std::string_view coordinate : kCoordinates) names.push_back(fmt::format("{}_{}", body, coordinate));
  if (scene.mocaps.size() == 1) names.insert(names.end(), kCoordinates.begin(), kCoordinates.end());
  std::vector<PoseColumns> columns(scene.mocaps.size());
  std::string prefix;  // of a missing column, as in the other columns
  for (std::size_t c = 0; c < table.width(); ++c) {
    if (table.is_time(c)) continue;
    const std::optional<NamedColumn> found = find_name(table.name(c), names);
    if (!found)
      table.fail(c, fmt::format("names no coordinate of a mocap body; columns are {}{}", wanted,
                                meant_name(table.name(c), names)));
    const std::size_t body = found->index / kCoordinates.size() % scene.mocaps.size();
    std::optional<NamedColumn>& place = columns[body][found->index % kCoordinates.size()];
    if (place) table.fail(c, "leads the same coordinate as another column");
    place = NamedColumn{c, found->has_unit};
    prefix = found->index < scene.mocaps.size() * kCoordinates.size() ? "_" : "";
  }
  for (std::size_t b = 0; b < columns.size(); ++b) {
    const bool is_led = std::any_of(columns[b].begin(), columns[b].end(), [](const auto& column) { return column; });
    if (is_led)
      lead.mocaps.push_back(
          track_of(table, columns[b], static_cast<int>(b), prefix.empty() ? prefix : scene.mocaps[b] + prefix, file));
  }
  if (lead.mocaps.empty()) throw Error(file, "has no column apart from the times: add " + wanted);
}

void add_run(SceneLead& lead, const std::filesystem::path& run, const SceneControls& scene) {
  const Recording recording = read_moved_recording(run);
  if (scene.mocaps.empty())
    throw Error(recording_file(run).string(), "has poses of a mocap body, but the scene has none (mocap=\"true\")");
  MocapTrack track;
  // Recordings have the poses of the first mocap body in the order of the bodies.
  const auto first =
      std::find_if(scene.bodies.begin(), scene.bodies.end(), [](const SceneBody& b) { return b.mocap >= 0; });
  if (first != scene.bodies.end()) track.mocap = first->mocap;
  for (std::size_t step = 0; step < recording.mocap.size(); ++step) {
    track.times.push_back(static_cast<double>(step) * recording.timestep);
    track.positions_W.push_back(recording.mocap[step].p);
    track.rotations_WB.push_back(recording.mocap[step].q);
  }
  lead.mocaps.push_back(std::move(track));
}

SceneLeadPtr read_lead(const LeadFiles& files, const SceneControls& scene) {
  auto lead = std::make_shared<SceneLead>();
  if (!files.controls.empty()) add_controls(*lead, read_file(files.controls), scene, files.controls);
  if (!files.mocaps.empty()) add_mocaps(*lead, read_file(files.mocaps), scene, files.mocaps);
  if (!files.run.empty()) add_run(*lead, files.run, scene);
  return lead;
}

int keyframe_named(const std::string& name, const SceneControls& scene, const std::string& file) {
  std::vector<std::string> names;
  for (const SceneKeyframe& keyframe : scene.keyframes) names.push_back(keyframe.name);
  if (names.empty()) throw Error(file, "has no keyframe");
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  std::size_t number = 0;
  const auto [end, code] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (code == std::errc() && end == name.data() + name.size() && number < names.size()) return static_cast<int>(number);
  throw Error(file, fmt::format("has no keyframe \"{}\"; there are {} (numbers 0 to {}){}", name, quoted_list(names),
                                names.size() - 1, meant_name(name, names)));
}

}  // namespace taxel
