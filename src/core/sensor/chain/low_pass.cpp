// Low pass of first order: tau dy/dt = x - y, from y = 0. A reading holds until the next one.
#include <cmath>
#include <numbers>

#include "core/sensor/chain/stage.h"

namespace taxel {
namespace {

/// The state of a taxel is the previous x, then y.
class LowPassStage : public Stage {
 public:
  LowPassStage(double time, std::size_t taxels) : time_(time), taxels_(taxels) {}

  [[nodiscard]] std::size_t state_size() const override { return 2 * taxels_; }

  void apply(const Moment& now, std::span<double> state, std::span<double> values) const override {
    const double approached = -std::expm1(-now.step / time_);  // 1 - exp(-h / tau)
    for (std::size_t k = 0; k < values.size(); ++k) {
      double &before = state[2 * k], &y = state[2 * k + 1];
      // The solution for an input that is constant during the step h, which is exact (the equivalent with a zero-order
      // hold; Astrom, Wittenmark 1997, Computer-Controlled Systems): y(h) = y + (x(0) - y) (1 - exp(-h / tau)).
      y += (before - y) * approached;
      before = values[k];
      values[k] = y;
    }
  }

 private:
  double time_;
  std::size_t taxels_;
};

}  // namespace

StagePtr make_low_pass(const ChainSettings& settings) {
  if (!settings.calibration.low_pass) return nullptr;
  const LowPass& filter = *settings.calibration.low_pass;
  const double time = filter.time ? *filter.time : 0.5 * std::numbers::inv_pi / filter.cutoff.value();  // 1 / (2 pi f)
  return std::make_shared<LowPassStage>(time, settings.taxel_count());
}

}  // namespace taxel
