#include "app/studio/nouns/explain/remedy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "core/layout/field/dense_fields.h"
#include "core/sensor/explain/advice.h"

namespace taxel::ui {

namespace {

constexpr double kPerSquareMillimetre = 1e-6;  // 1/m^2 in 1/mm^2
/// Number of samples that a remedy takes, in multiples of the number that removes the explained jump: other steps and
/// other taxels may need more. Four times as many samples at least halve the noise.
constexpr double kForOtherSteps = 4;

/// Returns the model that the simulation reads by, if it simulates one sensor of the document. Null otherwise.
SensorModelPtr simulated_model(const Shown& shown) {
  const SimFramePtr& frame = shown.run.frame;
  if (!shown.run.simulates_document || !frame || !frame->simulated || frame->simulated->sensors.empty()) return nullptr;
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
                              kPerSquareMillimetre * factor * present, kPerSquareMillimetre * present,
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
