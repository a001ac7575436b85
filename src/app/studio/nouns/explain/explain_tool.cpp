// Requests for the explanation of a reading, and the remedy for a jump.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/host/run/host_event.h"
#include "app/studio/nouns/explain/explain_state.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "core/layout/field/receptive_field.h"
#include "core/sensor/explain/counterfactual.h"

namespace taxel::ui {
namespace {

/// Returns the taxel whose reading changed most; in the first step, the taxel with the largest reading.
int taxel_to_explain(const Viewer& viewer, const Shown& shown) {
  const SensorStep& state = *shown.sensor(viewer);
  const HistoryLanes* lanes = shown.run.frame->history.lanes.get();
  if (lanes != nullptr && lanes->rows() > 0) {
    const std::size_t row = lanes->row_of(shown.run.frame->step);
    const int jumped = lanes->sensor(row, static_cast<std::size_t>(viewer.selection.sensor)).jumped_taxel;
    if (jumped >= 0) return jumped;
  }
  return static_cast<int>(std::max_element(state.readings.begin(), state.readings.end()) - state.readings.begin());
}

}  // namespace

void explain_reading(Viewer& viewer, const Shown& shown, ExplainState& explain, bool& open) {
  open = explain.wants_focus = true;
  const SensorModelPtr model = shown.model(viewer);
  const SensorStep* state = shown.sensor(viewer);
  if (!viewer.selection.empty() || !model || state == nullptr || state->readings.empty()) return;
  const auto taxel = static_cast<std::size_t>(taxel_to_explain(viewer, shown));
  if (taxel < model->layout.taxels.size()) viewer.selection.set(model->layout.taxels[taxel].id);
}

std::optional<ExplainRequest> explain_request(const Viewer& viewer, const Shown& shown, bool open) {
  const std::optional<int> active = viewer.selection.active();
  if (!open || !shows_run(viewer.mode) || !active || shown.sensor(viewer) == nullptr) return std::nullopt;
  return ExplainRequest{viewer.selection.sensor, *active};
}

const Explanation* shown_explanation(const Viewer& viewer, const Shown& shown, const ExplainState& explain, bool open) {
  const std::optional<ExplainRequest> request = explain_request(viewer, shown, open);
  const ExplainedPtr& found = explain.explained;
  if (!request || !found || !found->problem.empty() || found->request != *request ||
      found->step != shown.run.frame->step)
    return nullptr;
  return &found->explanation;
}

void inspect_polygon(const RunView& run, ExplainState& explain, bool& open, PolygonNumber polygon) {
  explain.polygon = polygon;
  explain.step = run.frame->step;
  open = explain.wants_focus = true;
}

void carry_out(const ExplainReading&, App& app) {
  explain_reading(*app.viewer, *app.shown, app.get<ExplainState>(), app.get<PanelsShown>()[kExplain]);
}

namespace {

constexpr double kSamplesPerSquareMillimetre = 1e-6;  // 1/m^2 in 1/mm^2

/// Returns the setting that removes a jump at mesh edges as an edit, or nothing if none of those tried does.
std::optional<Remedy> remedy_for_edges(const Explanation& explanation, const Layout& layout) {
  const Verdict& v = explanation.change->verdict;
  const SettingTried* best = best_setting(v.tried, std::abs(v.change));
  if (best == nullptr || !best->cures) return std::nullopt;
  if (best->radius != 1) {
    const auto index = static_cast<std::size_t>(explanation.taxel);
    if (index >= layout.taxels.size()) return std::nullopt;
    TaxelChange change;
    change.id = explanation.id;
    change.radius = best->radius * layout.taxels[index].radius;
    return Remedy{best->text, SetTaxels{{change}}};
  }
  if (!(best->readout == layout.readout)) return Remedy{best->text, SetReadout{best->readout}};
  return Remedy{best->text, SetReceptiveField{best->field}};
}

/// Returns the edit that multiplies the density of a taxel: its own if it has one, otherwise that of the layout.
Edit more_samples(const Layout& layout, const Taxel& taxel, double factor) {
  if (is_dense(taxel, layout.sampling)) {
    TaxelChange change;
    change.id = taxel.id;
    change.density = factor * taxel.density;
    return SetTaxels{{change}, false};
  }
  Sampling sampling = layout.sampling;
  sampling.density *= factor;
  return SetSampling{sampling};
}

}  // namespace

std::optional<Remedy> remedy_of(const Explanation& explanation, const Layout& layout) {
  if (!explanation.change) return std::nullopt;
  const Verdict& v = explanation.change->verdict;
  if (v.cause == Cause::sampling_noise && v.needed && v.needed->cures) {
    const std::optional<SamplesNeeded> worst = v.worst ? v.worst->needed : std::nullopt;
    const bool is_known = worst && worst->cures;
    const double factor = is_known ? std::max(v.needed->factor, worst->factor) : v.needed->factor;
    const auto index = static_cast<std::size_t>(explanation.taxel);
    const Taxel taxel = index < layout.taxels.size() ? layout.taxels[index] : Taxel();
    const double present = std::max(taxel.density, layout.sampling.density);
    return Remedy{fmt::format("{:.3g} times as many samples, {:.3g} instead of {:.3g} per mm\xc2\xb2{}", factor,
                              kSamplesPerSquareMillimetre * factor * present, kSamplesPerSquareMillimetre * present,
                              is_known ? " (also enough for the largest step of the run)" : ""),
                  more_samples(layout, taxel, factor)};
  }
  const bool is_field = v.cause == Cause::star_field || v.cause == Cause::inverted_tets;
  if (is_field && layout.material.field == FieldKind::star && std::abs(v.change - v.field) < kCureMargin * v.limit) {
    Material material = layout.material;
    material.field = FieldKind::pad;
    return Remedy{"a pad instead of a star field", SetMaterial{material}};
  }
  if (v.cause == Cause::cone && v.wider && v.wider->cures) {
    ReceptiveFieldRule rule = layout.receptive_field;
    rule.max_angle_deg = v.wider->angle_deg;
    if (v.worst && v.worst->wider) rule.max_angle_deg = std::max(rule.max_angle_deg, v.worst->wider->angle_deg);
    return Remedy{fmt::format("fields up to {:g}\xc2\xb0 from the normal of the taxel, instead of {:g}\xc2\xb0",
                              rule.max_angle_deg, layout.receptive_field.max_angle_deg),
                  SetReceptiveField{rule}};
  }
  if (v.cause == Cause::mesh_edges) return remedy_for_edges(explanation, layout);
  return std::nullopt;
}

}  // namespace taxel::ui
