// How far a reading depends on the number of samples: the same contact read with a quarter of them, with as many as
// the layout asks for, and with four times as many.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/sensor/readout/reading.h"

namespace taxel {

struct Convergence {
  /// Of the layout's density; four times the samples halve their spacing.
  static constexpr std::array<double, 3> kFactors{0.25, 1.0, 4.0};
  static constexpr std::size_t kAsked = 1;  ///< the layout's own

  Aggregate aggregate{};                      ///< the layout's
  std::array<int, 3> samples{};               ///< on the whole skin
  std::array<std::vector<double>, 3> values;  ///< by factor, then by taxel in layout order: as SensorReading::values

  /// What four times the samples would change about a taxel's reading.
  [[nodiscard]] double difference(std::size_t taxel) const { return values[2][taxel] - values[kAsked][taxel]; }
};

/// The same sensor with fewer and with more samples, by factor; that of kAsked is `model` itself.
using ConvergenceModels = std::array<SensorModelPtr, Convergence::kFactors.size()>;

/// The model with a multiple of its samples: only samples, receptive fields and rays are made; skin and body come from
/// the cache that `model` was built with. Throws Error where there would be more than kMaxSamples, Cancelled through
/// `progress`.
SensorModelPtr with_samples_times(double factor, const SensorModelPtr& model, SensorCache& cache,
                                  Progress* progress = nullptr);

/// Only samples, receptive fields and rays are made; skin and body, and samples that are known already, come from the
/// cache that `model` was built with. Throws Error where there would be more than kMaxSamples, Cancelled through
/// `progress`.
ConvergenceModels make_convergence_models(const SensorModelPtr& model, SensorCache& cache,
                                          Progress* progress = nullptr);

/// Reads `surfaces` (frame M, of contacts with the sensor's body) with each of them.
Convergence read_convergence(const ConvergenceModels& models, std::span<const ContactSurface* const> surfaces);

}  // namespace taxel
