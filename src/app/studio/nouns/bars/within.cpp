#include "app/studio/nouns/bars/within.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/studio/frame/sensors_shown.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "core/sensor/error_bars/sampling_error.h"
#include "core/sensor/readout/aggregate.h"

namespace taxel::ui {

namespace {

constexpr double kMostAtOnce = 16;             // largest factor of a density in one edit
constexpr double kPerSquareMillimetre = 1e-6;  // 1/m^2 in 1/mm^2

/// Returns the model that the run reads by, if it is the document's as it is edited now. Null otherwise.
SensorModelPtr measured_model(const Shown& shown) {
  const SimFramePtr& frame = shown.run.frame;
  const bool is_settled = shown.run.simulates_document && shown.document.editing.project && frame && frame->scene &&
                          shown.document.editing.compiled && !frame->scene->sensors.empty();
  if (!is_settled) return nullptr;
  const SensorModelPtr& model = frame->scene->sensors.front();
  return model == shown.document.model && model->quality == SampleQuality::polished ? model : nullptr;
}

/// Returns the largest bar of each taxel of a model, as a fraction of the largest reading of its sensor.
std::vector<double> largest_parts(const RunView& run, const SensorModel& model) {
  std::vector<double> parts(static_cast<std::size_t>(model.taxel_count()), 0.0);
  for (const SensorShown& sensor : sensors_shown(run)) {
    const auto index = static_cast<std::size_t>(sensor.index);
    const double peak = index < run.sensor_peaks.size() ? run.sensor_peaks[index] : 0;
    if (sensor.model.get() != &model || !(peak > 0)) continue;
    const std::span<const double> bars = run.error_bars(sensor.index);
    for (std::size_t k = 0; k < std::min(bars.size(), parts.size()); ++k) parts[k] = std::max(parts[k], bars[k] / peak);
  }
  return parts;
}

/// Rounds up to two digits.
double round_up(double density) {
  const double digit = std::pow(10.0, std::floor(std::log10(density)) - 1);
  return std::ceil(density / digit * (1 - 1e-12)) * digit;
}

/// Higher densities of the taxels whose bars are large.
struct MoreSamples {
  SetTaxels edit;
  bool is_not_enough = false;  ///< true if the largest number of samples does not even double one of them
};

MoreSamples more_samples(const SensorModel& model, const std::vector<double>& parts) {
  const Layout& layout = model.layout;
  std::vector<double> factors(parts.size(), 1.0);
  double wanted = 0, largest = 1;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (parts[k] <= kWithin) continue;
    factors[k] = std::clamp(std::pow(parts[k] / kWithin, 2), 1.5, kMostAtOnce);
    const double own = model.fields.first[k + 1] - model.fields.first[k];
    wanted += (factors[k] - 1) * std::max(1.0, own);
    largest = std::max(largest, factors[k]);
  }
  const double room = std::max(0.0, kMostSamples - static_cast<double>(model.samples.size()));
  const double share = wanted > room ? room / wanted : 1.0;
  MoreSamples more;
  more.is_not_enough = share < 1 && 1 + share * (largest - 1) < 2;
  more.edit.twins_follow = false;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (factors[k] == 1) continue;
    TaxelChange& change = more.edit.changes.emplace_back();
    change.id = layout.taxels[k].id;
    const double present = std::max(layout.taxels[k].density, layout.sampling.density);
    change.density = round_up((1 + share * (factors[k] - 1)) * present);
  }
  return more;
}

}  // namespace

LargestError largest_error(const RunView& run) {
  LargestError largest;
  for (const SensorShown& sensor : sensors_shown(run)) {
    const std::span<const double> bars = run.error_bars(sensor.index);
    const auto index = static_cast<std::size_t>(sensor.index);
    const double peak = index < run.sensor_peaks.size() ? run.sensor_peaks[index] : 0;
    if (!(peak > 0)) continue;
    for (std::size_t k = 0; k < std::min(bars.size(), sensor.taxels().size()); ++k)
      if (bars[k] / peak > largest.part) largest = {bars[k] / peak, sensor.taxels()[k].id};
  }
  return largest;
}

WithinStep next_within(const Shown& shown) {
  const SensorModelPtr model = measured_model(shown);
  if (model == nullptr)
    return {std::nullopt, shown.run.simulates_document ? "adds samples" : "needs a run of the layout"};
  const LargestError error = largest_error(shown.run);
  const Layout& layout = model->layout;
  if (error.taxel < 0) return {std::nullopt, "nothing is measured yet"};
  const std::string bar =
      fmt::format("largest bar {:.2g} % of the largest reading (taxel {})", 100 * error.part, error.taxel);
  if (error.part <= kWithin) return {std::nullopt, bar};
  if (!SamplingError::takes_samples(layout.readout)) return {std::nullopt, bar + ", which more samples do not change"};
  const MoreSamples more = more_samples(*model, largest_parts(shown.run, *model));
  if (more.is_not_enough) {
    Readout readout = layout.readout;
    readout.method = ReadingMethod::exact;
    if (aggregate_spec(readout.aggregate).integral != IntegralKind::none)
      return {Edit{SetReadout{readout}}, bar + ": exact readings"};
    return {std::nullopt, bar + fmt::format(", with the {:g} samples that are made at most", kMostSamples)};
  }
  const std::vector<TaxelChange>& changes = more.edit.changes;
  const std::string densities = changes.size() == 1 ? fmt::format("{:.3g} samples per mm\xc2\xb2",
                                                                  kPerSquareMillimetre * *changes.front().density)
                                                    : fmt::format("more samples for {} taxels", changes.size());
  return {Edit{more.edit}, bar + ": " + densities};
}

void keep_within(WindowUi& ui, const Shown& shown, ErrorBarsState& errors) {
  if (!errors.on || !errors.within) {
    errors.text.clear();
    return;
  }
  const WithinStep step = next_within(shown);
  if (step.edit || !step.text.empty()) errors.text = step.text;
  if (step.edit) ui.post(EditProject{*step.edit, {}});
}

}  // namespace taxel::ui
