// Error bars of readings that are made of samples: their difference from the integral that they approach.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/sensor/integral/pressure_integral.h"
#include "core/sensor/rays/ray_hits.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// Measures the error that the finite number of samples causes in each reading of a sensor. Belongs to one thread, and
/// reuses its memory from step to step.
///
///   bar = kWidening |reading - exact| + kAccuracy max(reading, exact) + kNoise s
///
/// `exact` is the integral for which the samples are taken (aggregate.h), and kAccuracy is the accuracy to which it is
/// computed here. s is the standard error of the reading if its samples were independent random points: a tenth of it
/// is left with a hundred times the samples, so that the bar contains readings of that many samples with their own
/// error. s is 0 for `nearest` and `max`, which are no sums. The bar does not contain the error of the contact surface
/// itself, see TessellationError.
class SamplingError {
 public:
  static constexpr double kWidening = 1.1;
  static constexpr double kAccuracy = 5e-4;
  static constexpr double kNoise = 0.04;

  /// Returns false if readings are integrals.
  [[nodiscard]] static bool takes_samples(const Readout& readout);
  /// Returns why readings of a layout have no such bars, or an empty text.
  [[nodiscard]] static std::string why_none(const Readout& readout);

  /// Computes the integrals' fields. Throws Error with why_none() if it is not empty.
  explicit SamplingError(SensorModelPtr model);

  [[nodiscard]] const SensorModelPtr& model() const { return model_; }

  /// Measures the bars of `readings`, which the model read from `surfaces` (frame M; null ones are empty) by `hits`,
  /// one per ray of the model. Throws Error unless there is one reading per taxel.
  void measure(std::span<const ContactSurface* const> surfaces, std::span<const RayHit> hits,
               std::span<const double> readings);

  /// Returns the bar of each taxel, in layout order and in the unit of the readings.
  [[nodiscard]] const std::vector<double>& bars() const { return bars_; }
  /// Returns the exact reading of each taxel. Where misses are left out and all rays miss, it is 0, as the reading is.
  [[nodiscard]] const std::vector<double>& exact() const { return exact_; }

 private:
  /// Sums over the samples of one taxel, with the coefficient c of each: its weight, or its share in `mean`.
  struct Sums {
    double c = 0, c2 = 0, c2p = 0, c2p2 = 0;  ///< sums of c, c^2, c^2 p and c^2 p^2
    int samples = 0;
  };
  void add_uses(std::int32_t ray, double pressure, std::vector<Sums>& sums) const;
  void integrate(std::span<const ContactSurface* const> surfaces);
  void read_each(std::span<const ContactSurface* const> surfaces, std::span<const double> readings);
  void measure_noise(std::span<const RayHit> hits, std::span<const double> readings);

  SensorModelPtr model_;
  SkinFieldsPtr fields_;  // null for aggregates without an integral over the contact polygons
  bool weighted_ = true, divided_ = true;
  std::vector<Sums> whole_, of_hits_;  // of all samples, and of those that hit; by taxel
  PressureIntegral integral_;
  PressureSums sums_;
  std::vector<double> exact_, noise_, bars_;
};

}  // namespace taxel
