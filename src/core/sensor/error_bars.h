// The errors of readings: their convergence with the number of samples (the same contact read with a quarter of the
// layout's samples, with all of them, and with four times as many), their difference from the integrals that they
// approach, and the error that a finer tessellation of the body shows.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/hydro/hydro_body.h"
#include "core/sensor/rays/sensor_ray.h"
#include "core/sensor/readout/reading.h"
#include "core/sensor/reference/pressure_integral.h"
#include "core/sensor/sensor_model.h"

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

/// Measures the error that the finite number of samples causes in each reading of a sensor. Belongs to one thread, and
/// reuses its memory from step to step.
///
///   bar = kWidening |reading - exact| + kAccuracy max(reading, exact) + kNoise s
///
/// `exact` is the integral for which the samples are taken (aggregate.h), and kAccuracy is the accuracy to which it is
/// computed here. s is the standard error of the reading if its samples were independent random points: a tenth of it
/// is left with a hundred times the samples, so that the bar contains readings of that many samples with their own
/// error. s is 0 for `nearest` and `max`, which are no sums. The bar does not contain the error of the contact surface
/// itself, see SensorErrors.
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

/// One taxel's reading by its samples and its exact reading (exact_reading()), in the unit of the reading.
struct SampleGap {
  int taxel = 0;  ///< index in layout order
  double sampled = 0, exact = 0;
  double gap = 0;  ///< distance of the two, less the error of the quadrature
};

/// Returns the distance of two readings, less the error of the exact one; at least 0.
double gap_of(double sampled, double exact, double error);

/// Returns the taxel whose gap is the largest fraction of its entry in `scales`, the first of equal ones. Taxels with
/// an infinite scale are excluded. Without scales, returns the taxel with the largest gap. Returns nothing if readings
/// do not come from samples (Aggregate::force) or no taxel has an exact reading. `readings` has one reading per taxel
/// on these surfaces (frame M, null ones are empty). The exact readings have an error of one hundredth. Runs on all
/// cores; the result depends on the arguments alone.
std::optional<SampleGap> largest_sample_gap(const SensorModel& model, std::span<const ContactSurface* const> surfaces,
                                            std::span<const double> readings, std::span<const double> scales = {});

/// Returns the shape with edges half as long. Faces of soft meshes are divided into four, and their numbers are left
/// out. Planes, boxes, tets, and meshes of rigid bodies are returned unchanged: planes, boxes and meshes are exact, and
/// tets are the user's own. Throws Error if a soft mesh is not a manifold or would have too many faces (remesh.h).
Shape finer_shape(Shape shape, const Material& material);

/// Returns a model of the same samples, fields and rays, whose body has edges half as long. A rigid model is returned
/// as it is. Throws Error as finer_shape() and make_body() do.
SensorModelPtr with_finer_body(const SensorModelPtr& model);

/// Returns a bar of the error of each coarse reading from readings with edges half as long. The pressure is linear on
/// each tet, so that errors fall with the square of the length of edges: coarse - limit = 4/3 (coarse - fine), the
/// extrapolation of Richardson (1911, "The Approximate Arithmetical Solution by Finite Differences").
std::vector<double> richardson_bars(std::span<const double> coarse, std::span<const double> fine);

}  // namespace taxel
