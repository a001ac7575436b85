// Uniform mid-tread quantiser (Widrow and Kollar 2008).
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/sensor/chain/stage.h"

namespace taxel {
namespace {

class QuantisationStage : public Stage {
 public:
  explicit QuantisationStage(const Calibration& settings) {
    const double infinity = std::numeric_limits<double>::infinity();
    range_ = settings.range.value_or(ValueRange{0.0, infinity});
    if (settings.quantisation->bits) {
      top_ = std::ldexp(1.0, *settings.quantisation->bits) - 1.0;
      q_ = (range_.high - range_.low) / top_;
    } else {
      const double rounding = 1e-12;  // rounding error of a range that is a multiple of the step
      q_ = *settings.quantisation->step;
      top_ = std::floor((range_.high - range_.low) / q_ * (1.0 + rounding));
    }
  }

  void apply(const Moment& /*now*/, std::span<double> /*state*/, std::span<double> values) const override {
    for (double& v : values) v = quantised(v);
  }

 private:
  /// Returns the nearest level low + q min(round((v - low) / q), top), with the low end of the range or 0 without a
  /// range, and the highest level `top` inside the range. Halfway values are rounded away from `low`.
  [[nodiscard]] double quantised(double value) const {
    const double level = std::round((value - range_.low) / q_);
    if (!(std::abs(level) < 0x1p52)) return value;  // levels closer than numbers are
    return std::min(range_.low + q_ * std::min(level, top_), range_.high);
  }

  ValueRange range_;
  double q_ = 0;    ///< distance of levels [V]
  double top_ = 0;  ///< number of the highest level
};

}  // namespace

StagePtr make_quantisation(const ChainSettings& settings) {
  if (!settings.calibration.quantisation) return nullptr;
  return std::make_shared<QuantisationStage>(settings.calibration);
}

}  // namespace taxel
