// Relaxation of the readings of a constant load, by exponentials: the reduced relaxation function of quasi-linear
// viscoelasticity (Fung 1993, Biomechanics, section 7.6), G(t) = 1 - sum_i a_i (1 - exp(-t / tau_i)). It acts on
// readings, not on forces.
//
// y = x - sum_i z_i, and each arm follows dz_i/dt = (a_i x - z_i) / tau_i from z_i = 0.
#include <cmath>

#include "core/sensor/chain/stage.h"

namespace taxel {
namespace {

/// The state of a taxel is the previous x, then z of each arm.
class RelaxationStage : public Stage {
 public:
  RelaxationStage(const std::vector<RelaxationArm>& arms, std::size_t taxels) : arms_(arms), taxels_(taxels) {}

  [[nodiscard]] std::size_t state_size() const override { return taxels_ * (1 + arms_.size()); }

  void apply(const Moment& now, std::span<double> state, std::span<double> values) const override {
    const std::size_t size = 1 + arms_.size();
    for (std::size_t i = 0; i < arms_.size(); ++i) {
      const double q = now.step / arms_[i].time, a = arms_[i].amplitude;
      const double lost = -std::expm1(-q);                 // 1 - exp(-h / tau)
      const double ramp = q > 0.0 ? 1.0 - lost / q : 0.0;  // 0 for two readings at the same time: a step
      for (std::size_t k = 0; k < values.size(); ++k) {
        const double before = state[k * size], change = values[k] - before;
        double& z = state[k * size + 1 + i];
        // The solution for x that grows at a constant rate during the step h, which is exact (Taylor, Pister, Goudreau
        // 1970): z(h) = z exp(-q) + a [x(0) (1 - exp(-q)) + (x(h) - x(0)) (1 - (1 - exp(-q)) / q)], q = h / tau.
        z += (a * before - z) * lost + a * change * ramp;
      }
    }
    for (std::size_t k = 0; k < values.size(); ++k) {
      state[k * size] = values[k];
      for (std::size_t i = 0; i < arms_.size(); ++i) values[k] -= state[k * size + 1 + i];
    }
  }

 private:
  std::vector<RelaxationArm> arms_;
  std::size_t taxels_;
};

}  // namespace

StagePtr make_relaxation(const ChainSettings& settings) {
  if (settings.calibration.relaxation.empty()) return nullptr;
  return std::make_shared<RelaxationStage>(settings.calibration.relaxation, settings.taxel_count());
}

}  // namespace taxel
