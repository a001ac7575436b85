// Sampling error: the difference between the readings of a sensor's samples and the exact readings.
#pragma once

#include <optional>
#include <span>

#include "core/hydro/contact_surface.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// One taxel's reading by its samples and its exact reading (exact_reading.h), in the unit of the reading.
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

}  // namespace taxel
