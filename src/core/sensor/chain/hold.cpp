// Sample and hold: between two ticks of the rate the values of the earlier tick remain.
#include <algorithm>

#include "core/sensor/chain/stage.h"

namespace taxel {
namespace {

/// The state of a taxel is the held value.
class HoldStage : public Stage {
 public:
  explicit HoldStage(std::size_t taxels) : taxels_(taxels) {}

  [[nodiscard]] std::size_t state_size() const override { return taxels_; }

  void apply(const Moment& now, std::span<double> state, std::span<double> values) const override {
    if (now.is_due)
      std::copy(values.begin(), values.end(), state.begin());
    else
      std::copy(state.begin(), state.end(), values.begin());
  }

 private:
  std::size_t taxels_;
};

}  // namespace

StagePtr make_hold(const ChainSettings& settings) {
  if (!settings.calibration.rate) return nullptr;
  return std::make_shared<HoldStage>(settings.taxel_count());
}

}  // namespace taxel
