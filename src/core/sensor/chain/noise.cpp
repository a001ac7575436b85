// White noise: v + s n(id, number of the value), n normal with mean 0 and variance 1.
#include "core/sensor/chain/random.h"
#include "core/sensor/chain/stage.h"

namespace taxel {
namespace {

class NoiseStage : public Stage {
 public:
  explicit NoiseStage(const ChainSettings& settings) : deviation_(settings.calibration.noise) {
    for (const Taxel& taxel : settings.layout.taxels)
      streams_.push_back(random_stream(settings.calibration.seed, RandomPart::noise, taxel.id));
  }

  void apply(const Moment& now, std::span<double> /*state*/, std::span<double> values) const override {
    if (!now.is_due) return;  // the held value has its noise
    for (std::size_t k = 0; k < values.size(); ++k) values[k] += deviation_ * normal_number(streams_[k], now.value);
  }

 private:
  double deviation_;
  std::vector<CounterRng> streams_;
};

}  // namespace

StagePtr make_noise(const ChainSettings& settings) {
  if (!(settings.calibration.noise > 0.0)) return nullptr;
  return std::make_shared<NoiseStage>(settings);
}

}  // namespace taxel
