// Clips values to a range.
#include <algorithm>

#include "core/sensor/chain/stage.h"

namespace taxel {
namespace {

class RangeStage : public Stage {
 public:
  explicit RangeStage(const ValueRange& range) : range_(range) {}

  void apply(const Moment& /*now*/, std::span<double> /*state*/, std::span<double> values) const override {
    for (double& v : values) v = std::clamp(v, range_.low, range_.high);
  }

 private:
  ValueRange range_;
};

}  // namespace

StagePtr make_range(const ChainSettings& settings) {
  if (!settings.calibration.range) return nullptr;
  return std::make_shared<RangeStage>(*settings.calibration.range);
}

}  // namespace taxel
