// The dependence of a reading on the number of samples: the same contact is read with a quarter of the layout's
// samples, with all of them, and with four times as many.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/sensor/readout/reading.h"

namespace taxel {

/// The readings of one contact with three numbers of samples.
struct Convergence {
  /// Multiples of the layout's density. Four times the samples have half the spacing.
  static constexpr std::array<double, 3> kFactors{0.25, 1.0, 4.0};
  static constexpr std::size_t kAsked = 1;  ///< index of the layout's own number

  Aggregate aggregate{};                      ///< aggregate of the layout
  std::array<int, 3> samples{};               ///< numbers of samples on the whole skin
  std::array<std::vector<double>, 3> values;  ///< SensorReading::values for each factor

  /// Returns the change of a taxel's reading by four times the samples.
  [[nodiscard]] double difference(std::size_t taxel) const { return values[2][taxel] - values[kAsked][taxel]; }
};

/// The models with fewer and with more samples, by factor. The model at kAsked is the layout's own.
using ConvergenceModels = std::array<SensorModelPtr, Convergence::kFactors.size()>;

/// Builds the model with a multiple of its samples. Builds only samples, receptive fields and rays; skin and body come
/// from the cache that `model` was built with. Throws Error for more than kMaxSamples, and Cancelled through
/// `progress`.
SensorModelPtr with_samples_times(double factor, const SensorModelPtr& model, SensorCache& cache,
                                  Progress* progress = nullptr);

/// Builds the models of all factors by with_samples_times(). Throws as it does.
ConvergenceModels make_convergence_models(const SensorModelPtr& model, SensorCache& cache,
                                          Progress* progress = nullptr);

/// Reads contact surfaces of the sensor's body (frame M) with each model.
Convergence read_convergence(const ConvergenceModels& models, std::span<const ContactSurface* const> surfaces);

}  // namespace taxel
