// One stage of the chain of a taxel: it changes the values of all taxels of a sensor, and may have a state.
//
// The state is a list of numbers that belongs to the caller, so that a simulator can save, copy and restore it with its
// own state. All zeros are the state before the first reading, when the skin was unloaded for a long time.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "core/layout/layout.h"

namespace taxel {

/// The time of one reading.
struct Moment {
  double step = 0;            ///< time since the previous reading [s]; 0 for the first reading
  std::uint64_t reading = 0;  ///< number of readings before this one since the last reset
  std::uint64_t value = 0;    ///< number of the reported value: a tick of the rate, or without a rate a reading
  bool is_due = true;         ///< false if the previous value is still held
  [[nodiscard]] bool is_first() const { return reading == 0; }
};

/// Immutable, so that copies of a chain share their stages.
class Stage {
 public:
  virtual ~Stage() = default;
  /// Returns the length of the state.
  [[nodiscard]] virtual std::size_t state_size() const { return 0; }
  /// Replaces the values, one per taxel in layout order, by those behind the stage, and advances the state.
  virtual void apply(const Moment& now, std::span<double> state, std::span<double> values) const = 0;
};
using StagePtr = std::shared_ptr<const Stage>;

/// The settings of which a stage is made.
struct ChainSettings {
  const Layout& layout;            ///< layout of the sensor
  const Calibration& calibration;  ///< calibration of the layout
  double timestep = 0;             ///< time between two readings [s], or 0 if unknown
  [[nodiscard]] std::size_t taxel_count() const { return layout.taxels.size(); }
};

// The stages, one file each. A function returns null if the calibration does not have the stage.
StagePtr make_response(const ChainSettings& settings);
StagePtr make_relaxation(const ChainSettings& settings);
StagePtr make_hysteresis(const ChainSettings& settings);
StagePtr make_low_pass(const ChainSettings& settings);
StagePtr make_crosstalk(const ChainSettings& settings);
StagePtr make_scaling(const ChainSettings& settings);
StagePtr make_noise(const ChainSettings& settings);
StagePtr make_range(const ChainSettings& settings);
StagePtr make_quantisation(const ChainSettings& settings);
StagePtr make_hold(const ChainSettings& settings);
/// Throws Error if the calibration has a latency and the time step is unknown.
StagePtr make_latency(const ChainSettings& settings);
StagePtr make_dead_taxels(const ChainSettings& settings);

}  // namespace taxel
