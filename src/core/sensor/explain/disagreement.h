// Where samples and surface disagree: what a sensor reads beside what its samples stand for.
#pragma once

#include <optional>
#include <span>

#include "core/sensor/explain/exact_reading.h"

namespace taxel {

/// One taxel's reading by its samples, and the exact one (exact_reading.h), in the unit of the reading.
struct SampleGap {
  int taxel = 0;  ///< in layout order
  double sampled = 0, exact = 0;
  double gap = 0;  ///< between them, less what the quadrature may leave
};

/// Distance of two readings, less the error that the quadrature of the exact one may leave; at least 0.
double gap_of(double sampled, double exact, double error);

/// The taxel whose gap is the largest fraction of its entry in `scales`, of equal ones the first; taxels with an
/// infinite scale are left out. Without scales the taxel with the largest gap. None where no reading comes from samples
/// (Aggregate::force) or no taxel has an exact one. `readings` by taxel, as read on these surfaces (frame M, null ones
/// hold nothing). Exact readings to a hundredth of themselves. A pure function of its arguments, on all cores.
std::optional<SampleGap> largest_sample_gap(const SensorModel& model, std::span<const ContactSurface* const> surfaces,
                                            std::span<const double> readings, std::span<const double> scales = {});

}  // namespace taxel
