// Requests for the explanation of a reading, the pause at the first jump of an example, and the remedy for a jump.
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
  if (!open || viewer.mode != Mode::simulate || !active || shown.sensor(viewer) == nullptr) return std::nullopt;
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

/// Smallest jump that pauses the example, as a fraction of the taxel's largest reading. The contact itself changes a
/// reading by less than a third of it in one step of the sweep.
constexpr double kJump = 0.04;

}  // namespace

void begin_hunt(WindowUi& ui, HuntState& hunt) {
  Breakpoints breakpoints;
  breakpoints.at_equal_force = true;
  breakpoints.jump = kJump;
  ui.post(BreakpointsCommand{breakpoints});
  hunt.waits_for_jump = true;
}

void follow_hunt(Viewer& viewer, const Shown& shown, HuntState& hunt, ExplainState& explain, bool& panel_is_open) {
  if (!hunt.waits_for_jump || !shown.run.frame || !shown.run.frame->stop) return;
  const Jump* const jump = std::get_if<Jump>(&*shown.run.frame->stop);
  const SensorModelPtr model = shown.model(viewer);
  if (jump == nullptr || !model || jump->taxel >= static_cast<int>(model->layout.taxels.size())) return;
  hunt.waits_for_jump = false;
  viewer.selection.set(model->layout.taxels[static_cast<std::size_t>(jump->taxel)].id);
  explain_reading(viewer, shown, explain, panel_is_open);
}

namespace {

constexpr double kSamplesPerSquareMillimetre = 1e-6;  // 1/m^2 in 1/mm^2
/// Number of samples that a remedy takes, in multiples of the number that removes the explained jump: other steps and
/// other taxels may need more. Four times as many samples at least halve the noise.
constexpr double kForOtherSteps = 4;

/// Returns the model that the simulation reads by, if it simulates one sensor of the document. Null otherwise.
SensorModelPtr simulated_model(const Shown& shown) {
  const SimFramePtr& frame = shown.run.frame;
  if (!shown.run.simulates_document || shown.document.is_scene || !frame || !frame->simulated ||
      frame->simulated->sensors.empty())
    return nullptr;
  return frame->simulated->sensors.front();
}

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
    const bool is_affordable = !is_known && kForOtherSteps * v.needed->samples <= kMaxTriedSamples;
    const double factor = is_known        ? std::max(v.needed->factor, worst->factor)
                          : is_affordable ? kForOtherSteps * v.needed->factor
                                          : v.needed->factor;
    const auto index = static_cast<std::size_t>(explanation.taxel);
    const Taxel taxel = index < layout.taxels.size() ? layout.taxels[index] : Taxel();
    const double present = std::max(taxel.density, layout.sampling.density);
    return Remedy{fmt::format("{:.3g} times as many samples, {:.3g} instead of {:.3g} per mm\xc2\xb2{}", factor,
                              kSamplesPerSquareMillimetre * factor * present, kSamplesPerSquareMillimetre * present,
                              is_known        ? " (also enough for the largest step of the run)"
                              : is_affordable ? " (other steps may need more than this one)"
                                              : ""),
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

std::string remedy_blocked(const Shown& shown) {
  if (simulated_model(shown) == nullptr) return "The layout belongs to the scene: change it in its own file.";
  if (shown.document.editing.project == nullptr) return "The document cannot be edited.";
  return {};
}

void apply_remedy(WindowUi& ui, const Shown& shown, ExplainState& explain, const Remedy& remedy) {
  explain.rerun_without = simulated_model(shown);
  ui.post(EditProject{remedy.edit, {}});
}

void rerun_after_remedy(WindowUi& ui, const Shown& shown, ExplainState& explain) {
  if (!explain.rerun_without) return;
  if (!shown.document.editing.problem.empty()) return explain.rerun_without.reset();
  const SensorModelPtr model = simulated_model(shown);
  if (!model || model == explain.rerun_without || !shown.document.editing.compiled) return;
  explain.rerun_without.reset();
  ui.post(ResetSimulation{});
  ui.post(PlayOrPause{});
}

}  // namespace taxel::ui
