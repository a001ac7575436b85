// Tare, then gain or curve, which convert to the unit of the reported values.
#include <map>
#include <utility>

#include "core/sensor/chain/piecewise_linear.h"
#include "core/sensor/chain/random.h"
#include "core/sensor/chain/stage.h"

namespace taxel {
namespace {

/// The parameters of one taxel.
struct Scale {
  double tare = 0;  ///< fixed tare [U]
  bool tare_first_reading = false;
  double gain = 1;  ///< gain [V/U]; after a curve only the deviation of the gain
  Curve curve;
};

/// The state of a taxel is the first value before the stage.
class ScalingStage : public Stage {
 public:
  explicit ScalingStage(std::vector<Scale> scales) : scales_(std::move(scales)) {}

  [[nodiscard]] std::size_t state_size() const override { return scales_.size(); }

  void apply(const Moment& now, std::span<double> state, std::span<double> values) const override {
    if (now.is_first()) std::copy(values.begin(), values.end(), state.begin());
    for (std::size_t k = 0; k < values.size(); ++k) {
      const Scale& scale = scales_[k];
      const double x = values[k] - scale.tare - (scale.tare_first_reading ? state[k] : 0.0);
      values[k] = scale.gain * (scale.curve.empty() ? x : piecewise_linear(scale.curve, x));
    }
  }

 private:
  std::vector<Scale> scales_;
};

Scale scale_of(const Calibration& settings, const TaxelCalibration& own, int id) {
  Scale scale;
  const auto random = [&](RandomPart part) { return normal_number(random_stream(settings.seed, part, id), 0); };
  // tare_k = tare + s n(id), s the deviation between taxels
  const Tare tare = settings.tare.value_or(Tare{});
  const double offset = settings.tare_deviation * random(RandomPart::tare);
  scale.tare = own.tare.value_or((tare.first_reading ? 0.0 : tare.value) + offset);
  scale.tare_first_reading = tare.first_reading && !own.tare;
  // gain_k = gain (1 + s n(id)), s the relative deviation between taxels
  const double spread = 1.0 + settings.gain_deviation * random(RandomPart::gain);
  const bool own_gain = own.gain || !own.curve.empty();
  scale.curve = own_gain ? own.curve : settings.curve;
  scale.gain = own_gain ? own.gain.value_or(1.0) : settings.gain.value_or(1.0) * spread;
  return scale;
}

}  // namespace

StagePtr make_scaling(const ChainSettings& settings) {
  std::map<int, const TaxelCalibration*> own;
  for (const TaxelCalibration& taxel : settings.calibration.taxels) own.emplace(taxel.id, &taxel);
  const TaxelCalibration nothing;
  std::vector<Scale> scales;
  for (const Taxel& taxel : settings.layout.taxels) {
    const auto found = own.find(taxel.id);
    scales.push_back(scale_of(settings.calibration, found == own.end() ? nothing : *found->second, taxel.id));
  }
  return std::make_shared<ScalingStage>(std::move(scales));
}

}  // namespace taxel
