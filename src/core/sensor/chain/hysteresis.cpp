// Hysteresis of the skin by play operators (Prandtl-Ishlinskii model; Visintin 1994, Differential Models of
// Hysteresis): x' = x + sum_i f_i (w_i - x), with w_i = max(x - r_i, min(x + r_i, w_i)) from w_i = 0.
#include <algorithm>

#include "core/sensor/chain/stage.h"

namespace taxel {
namespace {

/// The state of a taxel is w of each play operator.
class HysteresisStage : public Stage {
 public:
  HysteresisStage(const Hysteresis& hysteresis, std::size_t taxels) : plays_(hysteresis.plays), taxels_(taxels) {
    plays_.insert(plays_.begin(), {hysteresis.width, hysteresis.fraction});
  }

  [[nodiscard]] std::size_t state_size() const override { return taxels_ * plays_.size(); }

  void apply(const Moment& /*now*/, std::span<double> state, std::span<double> values) const override {
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double x = values[k];
      for (std::size_t i = 0; i < plays_.size(); ++i) {
        double& w = state[k * plays_.size() + i];
        const double r = 0.5 * plays_[i].width;
        w = std::max(x - r, std::min(x + r, w));
        values[k] += plays_[i].fraction * (w - x);
      }
    }
  }

 private:
  std::vector<Play> plays_;
  std::size_t taxels_;
};

}  // namespace

StagePtr make_hysteresis(const ChainSettings& settings) {
  if (!settings.calibration.hysteresis) return nullptr;
  return std::make_shared<HysteresisStage>(*settings.calibration.hysteresis, settings.taxel_count());
}

}  // namespace taxel
