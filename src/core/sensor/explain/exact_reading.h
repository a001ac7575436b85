// The limit of a taxel's reading for ever more samples. The sums over samples become integrals over the skin, and from
// each point of the skin starts a ray, as one starts from each sample.
//
//   weighted_mean   int w p dA / int w dA       (if misses are omitted: both over the part that is hit)
//   weighted_sum    N/A int w p dA              N samples on the sampled area A
//   mean            int p dA / int dA           over the field
//   nearest         p at the skin's point nearest to the centre
//   max             the largest p of the field
//   force           the reading itself, which takes no samples (force_integral.h)
//
// p is the pressure where the ray first intersects a contact surface, and 0 if the ray misses. The integrals run over
// the sampled faces, which are those of layout.sampling.region if a region is painted.
#pragma once

#include <span>

#include "core/hydro/contact_surface.h"
#include "core/sensor/explain/exact_value.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// Computes the exact reading of one taxel. Surfaces are in frame M; null ones are empty. The quadrature is adaptive: a
/// rule of degree 5 is compared with one of degree 2 until the error is how.accuracy of the reading or kExactRays are
/// cast. The result depends on the arguments alone. Throws Error for an unknown taxel.
ExactReading exact_reading(const SensorModel& model, int taxel, std::span<const ContactSurface* const> surfaces,
                           const ExactOptions& how = {});

}  // namespace taxel
