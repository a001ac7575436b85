// What a taxel's reading becomes with ever more samples: its sums as integrals over the skin, from which rays start as
// they do from samples.
//
//   weighted_mean   int w p dA / int w dA       (misses omit: both over what is hit)
//   weighted_sum    N/A int w p dA              N samples on the sampled area A
//   mean            int p dA / int dA           over the field
//   nearest         p at the skin's point nearest to the centre
//   max             the largest p of the field
//   force           takes no samples: as force_integral.h
//
// p is the pressure where the ray from that point of the skin first meets a contact surface, 0 where it meets none;
// the integrals run over the faces that are sampled, those of layout.sampling.region where one is painted.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/sensor/rays/cast_rays.h"

namespace taxel {

/// What one polygon brings into an integral.
struct PolygonPart {
  int surface = 0, polygon = 0;
  double value = 0;  ///< of the reading, in its unit; all of them make the reading
};

struct ExactReading {
  std::optional<double> value;     ///< in the unit of the reading; none: `missing` says why
  double error = 0;                ///< what the quadrature may leave, estimated, same unit
  std::vector<PolygonPart> parts;  ///< by surface and polygon, ascending; empty for nearest, max and force
  std::string missing;
  long rays = 0;  ///< cast: what it cost
};

/// So many rays one exact reading takes at most, about.
inline constexpr long kExactRays = 60000;
/// What the quadrature may leave, as part of the reading.
inline constexpr double kExactAccuracy = 5e-4;

/// The exact reading of one taxel. Surfaces in frame M, null ones hold nothing. Adaptive quadrature by a rule of degree
/// 5 against one of degree 2, until the error is `accuracy` of the reading or kExactRays are cast; a pure function of
/// its arguments. Throws Error for an unknown taxel.
ExactReading exact_reading(const SensorModel& model, int taxel, std::span<const ContactSurface* const> surfaces,
                           double accuracy = kExactAccuracy);

}  // namespace taxel
