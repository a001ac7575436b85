// How many samples cure sampling noise: measured where it was read with so many, otherwise from the rate at which the
// error fell.
#pragma once

#include "core/sensor/explain/explanation.h"

namespace taxel {

/// Error of a change at each number of samples: sqrt(e_before^2 + e_now^2), e the reading less the exact one.
std::array<double, 3> noise_of_levels(const SampleLevels& levels, const Readings& exact);

/// The least number of samples of which the noise is at most `allowed`. Beyond those that were read: by the power law
/// n^-s through the errors, s by least squares, held between 1/4 (equal weights) and 5/4 (Voronoi weights, theory.md).
SamplesNeeded samples_needed(const SampleLevels& levels, const Readings& exact, double allowed);

}  // namespace taxel
