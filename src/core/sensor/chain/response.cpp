// The curve of the sensing element. It has no state.
#include <algorithm>

#include "core/sensor/chain/piecewise_linear.h"
#include "core/sensor/chain/stage.h"

namespace taxel {
namespace {

class ResponseStage : public Stage {
 public:
  explicit ResponseStage(const Response& response) : response_(response) {}

  void apply(const Moment& /*now*/, std::span<double> /*state*/, std::span<double> values) const override {
    for (double& x : values) x = response_.points.empty() ? polynomial(x) : piecewise_linear(response_.points, x);
  }

 private:
  /// Returns c_1 x + c_2 x^2 + ... for 0 <= x <= up_to. Tangents continue the curve on both sides.
  [[nodiscard]] double polynomial(double x) const {
    const double inside = std::clamp(x, 0.0, response_.up_to);
    double value = 0, slope = 0;
    for (std::size_t power = response_.polynomial.size(); power > 0; --power) {  // Horner's rule
      slope = slope * inside + value;
      value = value * inside + response_.polynomial[power - 1];
    }
    slope = slope * inside + value;
    return value * inside + slope * (x - inside);
  }

  Response response_;
};

}  // namespace

StagePtr make_response(const ChainSettings& settings) {
  if (!settings.calibration.response) return nullptr;
  return std::make_shared<ResponseStage>(*settings.calibration.response);
}

}  // namespace taxel
