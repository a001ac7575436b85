// The rows of a comparison of two layouts, its requests, the results that may be shown, and the chosen curves.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/compare/compare_state.h"
#include "core/layout/words.h"
#include "core/sensor/readout/reading.h"

namespace taxel::ui {
namespace {

double place_of(const ComparedStep& row, bool by_travel) {
  return by_travel ? row.travel : row.time;
}

void include_row(SideSummary& summary, const ComparedStep& row, const std::vector<double>* before, std::size_t which,
                 bool by_travel) {
  const std::vector<double>& readings = side_readings(row, which);
  summary.peaks.resize(readings.size(), 0.0);
  for (std::size_t k = 0; k < readings.size(); ++k) {
    const auto taxel = static_cast<int>(k);
    summary.peaks[k] = std::max(summary.peaks[k], readings[k]);
    if (readings[k] > summary.peak.value) summary.peak = {readings[k], taxel, place_of(row, by_travel)};
    if (before == nullptr || k >= before->size()) continue;
    const double change = std::abs(readings[k] - (*before)[k]);
    if (change > summary.jump.value) summary.jump = {change, taxel, place_of(row, by_travel)};
  }
}

}  // namespace

void extend_side(CompareSide& side, std::span<const ComparedStepPtr> rows, std::size_t which, bool by_travel) {
  for (std::size_t i = side.trace.rows.size(); i < rows.size(); ++i) {
    const ComparedStep& row = *rows[i];
    const bool follows = i > 0 && !row.after_gap;
    include_row(side.summary, row, follows ? &side_readings(*rows[i - 1], which) : nullptr, which, by_travel);
    side.trace.rows.push_back({row.time, row.travel, side_readings(row, which)});
  }
  side.summary.responding =
      static_cast<int>(std::count_if(side.summary.peaks.begin(), side.summary.peaks.end(),
                                     [&](double peak) { return peak > kTaxelResponds * side.summary.peak.value; }));
  update_curves(side.curves, side.trace, by_travel);
}

double row_distance(std::span<const ComparedStepPtr> rows, bool by_travel) {
  if (rows.size() < 2) return 0;
  return (place_of(*rows.back(), by_travel) - place_of(*rows.front(), by_travel)) /
         static_cast<double>(rows.size() - 1);
}

namespace {

/// Returns the pressure field in words: "star, 50 kPa".
std::string field_words(const Material& material) {
  if (!material.compliant()) return "rigid";
  const std::string word(to_word(material.field));
  const std::string text = fmt::format("{}, {}", word, in_kpa(material.modulus));
  return material.field == FieldKind::pad && material.thickness > 0 ? text + ", " + in_mm(material.thickness) : text;
}

std::string place_words(double place, bool by_travel) {
  return by_travel ? in_mm(place) : fmt::format("{:.4g} s", place);
}

void restart(CompareState& state) {
  state.stopped = false;
  state.isolated.clear();
  state.hovered.reset();
}

}  // namespace

void begin_comparison(CompareState& state, const std::string& file) {
  state.request = CompareRequest{++state.number, file, file.empty() ? SecondContact::own : SecondContact::recorded};
  restart(state);
}

void end_comparison(CompareState& state) {
  state.request.reset();
  restart(state);
  state.sides = {};
  state.taken.clear();
}

void reread_second(CompareState& state) {
  if (state.request) state.request->number = ++state.number;
}

std::optional<CompareRequest> compare_request(const Viewer& viewer, const Shown& shown, const CompareState& state,
                                              bool open) {
  if (!open || !shows_run(viewer.mode) || shown.sensor(viewer) == nullptr) return std::nullopt;
  return state.request;
}

const ComparedLayouts* displayed_comparison(const Viewer& viewer, const Shown& shown, const CompareState& state,
                                            bool open) {
  const std::optional<CompareRequest> request = compare_request(viewer, shown, state, open);
  const ComparedLayoutsPtr& found = state.compared;
  if (!request || !found || found->request != *request || found->sensor != viewer.selection.sensor ||
      found->model != shown.model(viewer))
    return nullptr;
  return found.get();
}

void take_rows(CompareState& state, const ComparedLayouts& compared, bool by_travel) {
  const std::vector<ComparedStepPtr>& rows = compared.steps;
  const std::size_t taken_rows = state.taken.size();
  const bool is_extended = taken_rows <= rows.size() &&
                           (taken_rows == 0 || state.taken.back() == rows[taken_rows - 1]) &&
                           state.sides[0].curves.by_travel == by_travel;
  if (!is_extended || taken_rows == 0) {
    state.sides = {};
    state.taken.clear();
    for (CompareSide& side : state.sides) side.curves.by_travel = by_travel;
  }
  if (state.taken.size() == rows.size()) return;
  for (std::size_t s = 0; s < state.sides.size(); ++s) extend_side(state.sides[s], rows, s, by_travel);
  state.taken = rows;
}

const char* side_letter(std::size_t side) {
  return side == 0 ? "A" : "B";
}

std::string side_name(const ComparedLayouts& compared, std::size_t side) {
  const SensorModelPtr& model = compared.of(side);
  if (side == 1 && !compared.request.is_paper())
    return compared.request.file.substr(compared.request.file.find_last_of('/') + 1);
  if (!model || model->layout.name.empty()) return side == 0 ? "the layout of the run" : "the second layout";
  return model->layout.name;
}

std::string side_taxel(const ComparedLayouts& compared, const TaxelKey& key) {
  const auto side = static_cast<std::size_t>(key.sensor);
  return fmt::format("{} ({}), taxel {}", side_letter(side), side_name(compared, side), key.id);
}

std::string held_equal(const ComparedLayouts& compared) {
  if (!compared.reads_recorded)
    return fmt::format(
        "Held equal: mesh and motion (the recorded poses of A). Not equal: the pressure field, {} in A and {} in B. "
        "The contact is computed again for B; forces on the object, and a motion that they change, stay those of A.",
        field_words(compared.model->layout.material), field_words(compared.b->layout.material));
  if (compared.equal_contact) return "Held equal: mesh, motion, pressure field and contact surfaces.";
  return fmt::format(
      "Held equal: mesh, motion and the contact surfaces of A ({}). The pressure field and the repair of B are not "
      "used.",
      field_words(compared.model->layout.material));
}

std::string missing_rows(const ComparedLayouts& compared, const Trace& trace, bool by_travel) {
  if (compared.steps.empty() || trace.rows.empty()) return "";
  const auto place = [&](const ComparedStep& row) { return place_words(by_travel ? row.travel : row.time, by_travel); };
  std::string text;
  if (trace.rows.front().time < compared.steps.front()->time)
    text = fmt::format("Both curves begin at {}: the history has no earlier steps of this layout any more.",
                       place(*compared.steps.front()));
  const auto gap = std::find_if(compared.steps.begin(), compared.steps.end(),
                                [](const ComparedStepPtr& row) { return row->after_gap; });
  if (gap != compared.steps.end())
    text += fmt::format("{}Steps before {} left the history before they were read: a straight line is drawn there.",
                        text.empty() ? "" : " ", place(**gap));
  return text;
}

std::string comparison_csv(const ComparedLayouts& compared) {
  return readings_to_csv(compared.steps,
                         std::array{columns_of(ReadingModel::reading, "A/taxel_", compared.model->layout),
                                    columns_of(ReadingModel::second, "B/taxel_", compared.b->layout)});
}

std::vector<ChosenCurve> choose_side(const ComparedLayouts& compared, std::size_t side, const SideSummary& summary,
                                     const Selection& selection, bool responding_only) {
  std::vector<ChosenCurve> curves;
  const SensorModelPtr& model = compared.of(side);
  if (!model) return curves;
  for (std::size_t k = 0; k < model->layout.taxels.size() && k < summary.peaks.size(); ++k) {
    ChosenCurve curve;
    curve.key = {static_cast<int>(side), model->layout.taxels[k].id};
    curve.reading = k;
    curve.selected = (side == 0 || !compared.taxels_of_b) && selection.contains(curve.key.id);
    if (responding_only && !curve.selected && !(summary.peaks[k] > kTaxelResponds * summary.peak.value)) continue;
    curve.label = fmt::format("{} {}", side_letter(side), curve.key.id);
    curve.color = model->color(static_cast<int>(k));
    curve.dashed = side == 1;
    curves.push_back(std::move(curve));
  }
  return curves;
}

bool is_relative(const ComparedLayouts& compared, const CompareState& state) {
  return state.relative || !same_unit(shown_unit(compared.model->layout.readout.aggregate),
                                      shown_unit(compared.b->layout.readout.aggregate));
}

double side_scale(const ComparedLayouts& compared, std::size_t side, const SideSummary& summary, bool relative) {
  const SensorModelPtr& model = compared.of(side);
  if (!relative) return shown_unit(model->layout.readout.aggregate).scale;
  return summary.peak.value > 0 ? 1 / summary.peak.value : 1.0;
}

std::optional<TaxelKey> nearest_curve(const CompareState& state, const ComparedLayouts& compared, const PlotPoint& at) {
  std::optional<TaxelKey> nearest;
  double least = at.reach;
  const bool relative = is_relative(compared, state);
  for (std::size_t s = 0; s < state.sides.size(); ++s) {
    const PlotCurves& curves = state.sides[s].curves;
    if (!state.drawn[s] || curves.x.size() < 2 || at.x < curves.x.front() || at.x > curves.x.back()) continue;
    const auto next = std::upper_bound(curves.x.begin() + 1, curves.x.end() - 1, at.x);
    const auto j = static_cast<std::size_t>(next - curves.x.begin());
    const double width = curves.x[j] - curves.x[j - 1];
    const double part = width > 0 ? std::clamp((at.x - curves.x[j - 1]) / width, 0.0, 1.0) : 0.0;
    const double scale = side_scale(compared, s, state.sides[s].summary, relative);
    for (const ChosenCurve& curve : state.shown.curves[s]) {
      const std::vector<double>& y = curves.readings[curve.reading];
      const double distance = std::abs(scale * ((1 - part) * y[j - 1] + part * y[j]) - at.y);
      if (distance > least) continue;
      least = distance;
      nearest = curve.key;
    }
  }
  return nearest;
}

}  // namespace taxel::ui
