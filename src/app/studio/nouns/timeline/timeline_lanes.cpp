// Tracks of the timeline: curves of the recorded steps above each other, with events, range and cursor.
#include "app/studio/nouns/timeline/timeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "app/studio/nouns/timeline/run_commands.h"
#include "core/base/page/curve.h"
#include "core/sensor/readout/reading.h"
#include "ui/scene/color_map.h"
#include "ui/theme.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

namespace {

/// Heights of the ruler and of the events, in lines of small text, and of the taxels' track, in heights of a track.
constexpr float kRuler = 1.05f, kEvents = 0.55f, kTaxelsLane = 2.0f;
/// Widths in lines of text: the names at the left, the values at the right.
constexpr float kNameWidth = 7.6f, kValueWidth = 7.2f;
constexpr float kLeastLane = 0.8f;    ///< smallest track with a label, in lines of small text
constexpr double kCurveColumn = 2.0;  ///< column width of curves [pixels]: see thin_curve()

struct Lane {
  const char* name;
  std::function<double(const SensorSummary&)> value;
  std::function<std::string(double)> text;
  bool least = false;  ///< draw the smallest value of each column, on a logarithmic scale
};

std::string area_text(double area) {
  if (area >= 1e-8) return in_mm2(area);
  const double um2 = 1e12 * area;
  return um2 >= 100 ? grouped(std::llround(um2)) + " \u00b5m\u00b2" : fmt::format("{:.3g} \u00b5m\u00b2", um2);
}

std::vector<Lane> lanes_of(const ReadingUnit& unit) {
  return {
      {"total force", [](const SensorSummary& s) { return s.force; },
       [](double v) { return fmt::format("{:.3f} N", v); }},
      {"contact area", [](const SensorSummary& s) { return s.area; }, area_text},
      {"polygons", [](const SensorSummary& s) { return static_cast<double>(s.polygons); },
       [](double v) { return fmt::format("{:.0f}", v); }},
      {"smallest polygon", [](const SensorSummary& s) { return s.smallest_polygon; }, area_text, true},
      {"largest jump", [](const SensorSummary& s) { return s.largest_jump; },
       [unit](double v) { return in_unit(v, unit); }},
  };
}

/// The shared data of all parts of the drawing.
struct Picture {
  const Selection& selection;
  const std::optional<StepRange>& loop;
  Timeline& timeline;
  ImDrawList& list;
  const Palette& colors;
  const HistoryLanes& lanes;
  std::size_t sensor = 0, first_reading = 0, readings = 0;
  ReadingUnit unit{};
  float x0 = 0, x1 = 0;  ///< left and right edge of the tracks
  std::size_t row = 0;   ///< row of the displayed step

  [[nodiscard]] std::size_t columns(float width) const {
    return std::max<std::size_t>(1, std::min(lanes.rows(), static_cast<std::size_t>((x1 - x0) / width)));
  }
  /// Returns the range of rows that belong to a column, if all rows are spread over `columns`.
  [[nodiscard]] std::pair<std::size_t, std::size_t> rows_of(std::size_t column, std::size_t columns) const {
    const std::size_t n = lanes.rows();
    return {column * n / columns, std::max(column * n / columns + 1, (column + 1) * n / columns)};
  }
  void text(ImVec2 at, const ImVec4& color, const std::string& words) const {
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize() * kSmallText, at, to_u32(color), words.c_str());
  }
  [[nodiscard]] float text_width(const std::string& words) const {
    return ImGui::CalcTextSize(words.c_str()).x * kSmallText;
  }
  /// Draws name and value of a track to its left and right.
  void label(float y0, float y1, const char* name, const std::string& value) const {
    const float line = kSmallText * ImGui::GetFontSize();
    if (y1 - y0 < kLeastLane * line) return;  // names would overlap
    const float y = std::round(0.5f * (y0 + y1 - line));
    text({x0 - text_width(name) - 8, y}, colors.dim, name);
    text({x1 + 8, y}, colors.text, value);
  }
};

void draw_lane(const Picture& p, const Lane& lane, float y0, float y1) {
  double lo = 0, hi = 0, least = 0;
  for (std::size_t r = 0; r < p.lanes.rows(); ++r) {
    const double v = lane.value(p.lanes.sensor(r, p.sensor));
    hi = std::max(hi, v);
    if (v > 0 && (least == 0 || v < least)) least = v;
  }
  if (lane.least && least > 0) lo = std::log10(least) - 0.3, hi = std::log10(hi) + 0.01;
  const auto height = [&](double v) {
    if (!(v > 0) || !(hi > lo)) return 0.0f;
    return static_cast<float>(((lane.least ? std::log10(v) : v) - lo) / (hi - lo)) * (y1 - y0 - 2);
  };
  const std::size_t columns = p.columns(1);
  const float width = (p.x1 - p.x0) / static_cast<float>(columns);
  const ImU32 color = to_u32(p.colors.accent, 0.75f);
  float begin = p.x0, drawn = 0;  // adjacent columns of equal height form one rectangle
  const auto fill = [&](float end) {
    if (drawn > 0) p.list.AddRectFilled({begin, y1 - drawn}, {end, y1}, color);
  };
  for (std::size_t c = 0; c < columns; ++c) {
    const auto [from, to] = p.rows_of(c, columns);
    double v = lane.value(p.lanes.sensor(from, p.sensor));
    for (std::size_t r = from + 1; r < to; ++r) {
      const double other = lane.value(p.lanes.sensor(r, p.sensor));
      v = lane.least ? (v > 0 && other > 0 ? std::min(v, other) : std::max(v, other)) : std::max(v, other);
    }
    const float x = p.x0 + static_cast<float>(c) * width, exact = height(v);
    const float h = exact > 0 ? std::max(1.0f, 0.25f * std::round(4 * exact)) : 0.0f;
    if (h == drawn) continue;
    fill(x);
    begin = x, drawn = h;
  }
  fill(p.x1);
  p.label(y0, y1, lane.name, lane.text(lane.value(p.lanes.sensor(p.row, p.sensor))));
}

void draw_taxels(const Picture& p, const SensorModel& model, float y0, float y1) {
  double largest = 0;
  std::vector<double> peaks(p.readings, 0.0);
  for (std::size_t r = 0; r < p.lanes.rows(); ++r) {
    for (std::size_t k = 0; k < p.readings; ++k)
      peaks[k] = std::max(peaks[k], p.lanes.readings_of(r)[p.first_reading + k]);
  }
  for (const double peak : peaks) largest = std::max(largest, peak);
  const double width = (p.x1 - p.x0) / static_cast<double>(p.lanes.rows());
  std::vector<double> x(p.lanes.rows()), y(p.lanes.rows());
  for (std::size_t r = 0; r < x.size(); ++r) x[r] = p.x0 + (static_cast<double>(r) + 0.5) * width;
  CurvePoints curve;
  std::vector<ImVec2> points;
  for (std::size_t k = 0; k < p.readings && largest > 0; ++k) {
    if (!(peaks[k] > kTaxelResponds * largest)) continue;
    for (std::size_t r = 0; r < y.size(); ++r)
      y[r] = y1 - 1 - p.lanes.readings_of(r)[p.first_reading + k] / largest * (y1 - y0 - 3);
    thin_curve(x, y, kCurveColumn, kCurveTolerance, curve);
    points.clear();
    for (std::size_t i = 0; i < curve.x.size(); ++i)
      points.emplace_back(static_cast<float>(curve.x[i]), static_cast<float>(curve.y[i]));
    const glm::vec3 c = taxel_color(model.color(static_cast<int>(k)));
    const bool selected = k < model.layout.taxels.size() && p.selection.contains(model.layout.taxels[k].id);
    p.list.AddPolyline(points.data(), static_cast<int>(points.size()), to_u32({c.x, c.y, c.z, 1}),
                       selected ? 2.4f : 1.3f);
  }
  const std::span<const double> now = p.lanes.readings_of(p.row).subspan(p.first_reading, p.readings);
  const double most = now.empty() ? 0.0 : *std::max_element(now.begin(), now.end());
  p.label(y0, y1, "taxels", in_unit(most, p.unit));
}

/// Returns a line for each taxel that jumps in a row: "taxel 5 jumps by 12 % at constant force", as a fraction of the
/// reading that Explain measures the step by.
std::string jump_names(const SimFrame& frame, const HistoryLanes& lanes, std::size_t row) {
  std::string names;
  const bool at_equal_force = lanes.steps[row].has(StepEvent::jump_at_equal_force);
  std::size_t first = 0;
  for (std::size_t s = 0; s < lanes.sensor_count && row > 0; ++s) {
    const SensorSummary& sensor = lanes.sensor(row, s);
    const SensorModelPtr& model = frame.scene->sensors[s];
    const auto k = static_cast<std::size_t>(std::max(0, sensor.jumped_taxel));
    if (sensor.is_jump && model && k < model->layout.taxels.size()) {
      const double change = std::abs(lanes.readings_of(row)[first + k] - lanes.readings_of(row - 1)[first + k]);
      const bool of_sensor = frame.breakpoints.of_sensor;
      const double whole =
          of_sensor ? lanes.sensor(lanes.rows() - 1, s).largest_reading : largest_reading(lanes, first + k);
      names += fmt::format("\ntaxel {} jumps by {:.3g} % of {} largest reading{}", model->layout.taxels[k].id,
                           whole > 0 ? 100 * change / whole : 0.0, of_sensor ? "the sensor's" : "its",
                           at_equal_force ? " at constant force" : "");
    }
    if (model) first += model->layout.taxels.size();
  }
  return names;
}

std::string event_names(const SimFrame& frame, const HistoryLanes& lanes, std::size_t row) {
  const StepMark& mark = lanes.steps[row];
  std::string names;
  const auto add = [&](StepEvent event, const char* name) {
    if (mark.has(event)) names += std::string("\n") + name;
  };
  add(StepEvent::contact_begins, "contact begins");
  add(StepEvent::contact_ends, "contact ends");
  names += jump_names(frame, lanes, row);
  add(StepEvent::disagreement, "samples and surface disagree");
  add(StepEvent::other_layout, "read by another layout from here");
  return names;
}

void draw_events(const Picture& p, float y0, float y1) {
  p.timeline.marks = 0;
  p.timeline.events_y0 = y0, p.timeline.events_y1 = y1;
  float drawn_to = p.x0 - 10;
  for (const StepMark& mark : p.lanes.steps) {
    if (mark.events == 0) continue;
    ++p.timeline.marks;
    const float x = x_of(p.timeline, static_cast<double>(mark.step));
    if (x < drawn_to + 1) continue;  // one marker per pixel
    drawn_to = x;
    const float r = 0.5f * (y1 - y0);
    p.list.AddTriangleFilled({x - r, y0}, {x + r, y0}, {x, y1}, to_u32(event_color(mark, p.colors)));
  }
}

/// Draws the ruler with times at round values.
void draw_ruler(const Picture& p, float y, float bottom) {
  const double from = p.lanes.steps.front().time, to = p.lanes.steps.back().time;
  if (!(to > from)) return;
  const double pixels = static_cast<double>(p.x1 - p.x0);
  const double label = std::max(80.0, 5.5 * static_cast<double>(ImGui::GetFontSize()));  // a time with a gap
  const double wanted = (to - from) * label / pixels;
  const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
  const double every = wanted <= 2 * decade ? 2 * decade : wanted <= 5 * decade ? 5 * decade : 10 * decade;
  for (double t = std::ceil(from / every) * every; t <= to + 1e-9 * every; t += every) {
    const float x = std::round(p.x0 + static_cast<float>((t - from) / (to - from) * pixels));
    p.list.AddLineV(x, y, bottom, to_u32(p.colors.line, 0.5f));
    const std::string words = fmt::format("{:.6g} s", std::abs(t) < 1e-6 * every ? 0.0 : t);
    if (x + 3 + p.text_width(words) < p.x1) p.text({x + 3, y - 1}, p.colors.dim, words);
  }
}

void draw_range_and_cursor(const Picture& p, float top, float bottom) {
  const Timeline& timeline = p.timeline;
  if (p.loop) {
    const float half = 0.5f * (p.x1 - p.x0) / static_cast<float>(p.lanes.rows());
    const float from = std::max(p.x0, x_of(timeline, static_cast<double>(p.loop->first)) - half);
    const float to = std::min(p.x1, x_of(timeline, static_cast<double>(p.loop->last)) + half);
    p.list.AddRectFilled({from, top}, {to, bottom}, to_u32(p.colors.accent, 0.14f));
    for (const float x : {from, to}) p.list.AddLineV(x, top, bottom, to_u32(p.colors.accent), 1.5f);
  }
  const float x = std::round(x_of(timeline, static_cast<double>(p.lanes.steps[p.row].step)));
  p.list.AddLineV(x, top, bottom, to_u32(p.colors.path), 1.5f);
  p.list.AddTriangleFilled({x - 5, top}, {x + 5, top}, {x, top + 7}, to_u32(p.colors.path));
}

/// Returns the step of the event whose marker is under the pointer, the nearest one. Empty if there is none.
std::optional<std::uint64_t> marked_step(const Timeline& timeline, const HistoryLanes& lanes) {
  const ImVec2 at = ImGui::GetIO().MousePos;
  if (at.y < timeline.events_y0 || at.y > timeline.events_y1) return std::nullopt;
  float nearest = 0.5f * (timeline.events_y1 - timeline.events_y0) + 1;
  std::optional<std::uint64_t> step;
  for (const StepMark& mark : lanes.steps) {
    if (mark.events == 0) continue;
    const float away = std::abs(x_of(timeline, static_cast<double>(mark.step)) - at.x);
    if (away < nearest) nearest = away, step = mark.step;
  }
  return step;
}

/// Handles the pointer. A click on a marker goes to its event. A drag moves the cursor; with Shift, a drag sets the
/// range of a loop.
void take_pointer(WindowUi& ui, const RunView& run, Timeline& timeline, const HistoryLanes& lanes) {
  const std::uint64_t under = step_at(timeline, ImGui::GetIO().MousePos.x);
  timeline.tip.clear();
  if (ImGui::IsItemActivated()) {
    const std::optional<std::uint64_t> marked = marked_step(timeline, lanes);
    timeline.scrubs = !ImGui::GetIO().KeyShift && !marked;
    if (marked && !ImGui::GetIO().KeyShift) return ui.post(ShowEvent{*marked});
    timeline.loops_from = timeline.scrubs ? std::nullopt : std::optional(under);
    if (!timeline.scrubs) ui.post(SetLoop{});
  }
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left) && !timeline.loops_from)
    timeline.scrubs = true;  // a drag that begins on a marker moves the cursor too
  if (ImGui::IsItemActive() && timeline.scrubs && (under != run.frame->step || run.playing)) ui.post(ScrubTo{under});
  if (ImGui::IsItemActive() && timeline.loops_from && under != *timeline.loops_from)
    ui.post(SetLoop{StepRange{std::min(under, *timeline.loops_from), std::max(under, *timeline.loops_from)}});
  if (ImGui::IsItemDeactivated()) timeline.scrubs = false, timeline.loops_from.reset();
  if (!ImGui::IsItemHovered() || ImGui::IsItemActive()) return;
  const std::size_t row = lanes.row_of(marked_step(timeline, lanes).value_or(under));
  timeline.tip = event_names(*run.frame, lanes, row);
  ImGui::SetTooltip("step %llu, %.6g s%s", static_cast<unsigned long long>(lanes.steps[row].step),
                    lanes.steps[row].time, timeline.tip.c_str());
}

}  // namespace

ImVec4 event_color(const StepMark& mark, const Palette& colors) {
  if (mark.has(StepEvent::jump_at_equal_force)) return colors.error;
  if (mark.has(StepEvent::jump) || mark.has(StepEvent::disagreement)) return colors.warning;
  if (mark.has(StepEvent::other_layout)) return colors.layout_mode;
  return mark.has(StepEvent::contact_begins) ? colors.run : colors.dim;
}

std::uint64_t step_at(const Timeline& timeline, float x) {
  const double count = static_cast<double>(timeline.steps.last - timeline.steps.first + 1);
  const double part = static_cast<double>((x - timeline.lanes.x0) / std::max(1.0f, timeline.lanes.width()));
  const double step = std::clamp(std::floor(part * count), 0.0, count - 1);
  return timeline.steps.first + static_cast<std::uint64_t>(step);
}

float x_of(const Timeline& timeline, double step) {
  const double count = static_cast<double>(timeline.steps.last - timeline.steps.first + 1);
  const double part = (step - static_cast<double>(timeline.steps.first) + 0.5) / count;
  return timeline.lanes.x0 + static_cast<float>(part) * timeline.lanes.width();
}

void draw_timeline_slider(WindowUi& ui, const Selection& selection, const RunView& run, Timeline& timeline,
                          const ImVec2& size) {
  const HistoryLanes& lanes = *run.frame->history.lanes;
  const ImVec2 lo = ImGui::GetCursorScreenPos();
  const float x1 = lo.x + size.x, y1 = lo.y + size.y, middle = std::round(lo.y + 0.5f * size.y);
  timeline.lanes = {lo.x, lo.y, x1, y1};
  timeline.steps = {lanes.steps.front().step, lanes.steps.back().step};
  ImGui::InvisibleButton("##line", size);
  ui.widgets.note_item("Timeline lanes");
  take_pointer(ui, run, timeline, lanes);

  Picture p{selection, run.loop, timeline, *ImGui::GetWindowDrawList(), palette(ui.dark), lanes};
  p.x0 = lo.x;
  p.x1 = x1;
  p.row = lanes.row_of(run.frame->step);
  const float now = x_of(timeline, static_cast<double>(lanes.steps[p.row].step));
  p.list.AddRectFilled({lo.x, middle - 2}, {x1, middle + 3}, to_u32(p.colors.field), 2);
  p.list.AddRectFilled({lo.x, middle - 2}, {now, middle + 3}, to_u32(p.colors.accent, 0.55f), 2);
  draw_events(p, lo.y + 1, middle - 3);
  draw_range_and_cursor(p, lo.y, y1);
}

void draw_timeline_lanes(WindowUi& ui, const Selection& selection, const RunView& run, Timeline& timeline,
                         const ImVec2& size) {
  const SimFrame& frame = *run.frame;
  const HistoryLanes& lanes = *frame.history.lanes;
  const auto sensor = static_cast<std::size_t>(selection.sensor);
  const SensorModel& model = *frame.scene->sensors[sensor];
  const float line = ImGui::GetFontSize(), small = kSmallText * line;
  const ImVec2 lo = ImGui::GetCursorScreenPos();
  const float x0 = lo.x + kNameWidth * line, x1 = lo.x + size.x - kValueWidth * line, y1 = lo.y + size.y;
  if (x1 - x0 < 4 * line || size.y < 4 * line) return;
  timeline.lanes = {x0, lo.y, x1, y1};
  timeline.steps = {lanes.steps.front().step, lanes.steps.back().step};
  ImGui::SetCursorScreenPos({x0, lo.y});
  ImGui::InvisibleButton("##lanes", {x1 - x0, size.y});
  ui.widgets.note_item("Timeline lanes");
  take_pointer(ui, run, timeline, lanes);

  Picture p{selection, run.loop, timeline, *ImGui::GetWindowDrawList(), palette(ui.dark), lanes};
  p.sensor = sensor;
  p.first_reading = frame.first_reading(sensor);
  p.readings = std::min(frame.sensors[sensor].readings.size(), lanes.reading_count - p.first_reading);
  p.unit = shown_unit(model.layout.readout.aggregate);
  p.x0 = x0;
  p.x1 = x1;
  p.row = lanes.row_of(frame.step);
  const std::vector<Lane> scalars = lanes_of(p.unit);
  const float top = lo.y + kRuler * small, below = top + kEvents * small;
  const float height = (y1 - below) / (static_cast<float>(scalars.size()) + kTaxelsLane);
  draw_ruler(p, lo.y, y1);
  draw_events(p, top, below - 1);
  draw_taxels(p, model, below, below + kTaxelsLane * height);
  for (std::size_t i = 0; i < scalars.size(); ++i) {
    const float y = below + (kTaxelsLane + static_cast<float>(i)) * height;
    p.list.AddLineH(x0, x1, std::round(y), to_u32(p.colors.line, 0.7f));
    draw_lane(p, scalars[i], y + 1, y + height);
  }
  draw_range_and_cursor(p, lo.y, y1);
}

}  // namespace taxel::ui
