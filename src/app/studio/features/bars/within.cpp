#include "app/studio/features/bars/within.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/studio/app/values/sensors_shown.h"
#include "core/sensor/error_bars/sampling_error.h"
#include "core/sensor/readout/aggregate.h"

namespace taxel::ui {

namespace {

constexpr double kMostAtOnce = 16;             // largest factor of the density in one edit
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
  const double most = kMostSamples / static_cast<double>(std::max<std::size_t>(1, model->samples.size()));
  const double wanted = std::pow(error.part / kWithin, 2);
  if (most < 1.2 || (wanted > most && most < 2)) {
    Readout readout = layout.readout;
    readout.method = ReadingMethod::exact;
    if (aggregate_spec(readout.aggregate).integral != IntegralKind::none)
      return {Edit{SetReadout{readout}}, bar + ": exact readings"};
    return {std::nullopt, bar + fmt::format(", with the {:g} samples that are made at most", kMostSamples)};
  }
  Sampling sampling = layout.sampling;
  const double factor = std::min({std::max(1.5, wanted), kMostAtOnce, most});
  sampling.density *= factor;
  return {Edit{SetSampling{sampling}},
          bar + fmt::format(": {:.3g} samples per mm\xc2\xb2", kPerSquareMillimetre * sampling.density)};
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
