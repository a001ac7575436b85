// An exact reading as a value: the limit of a taxel's reading for ever more samples (field_integral.h).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/layout/layout.h"

namespace taxel {

/// The part of one contact polygon in an exact reading.
struct PolygonPart {
  int surface = 0, polygon = 0;
  double value = 0;  ///< part of the reading, in its unit; the parts add up to the reading
};

/// A value with its error, or the reason why there is none.
struct ExactReading {
  std::optional<double> value;     ///< in the unit of the reading
  double error = 0;                ///< estimated error of the quadrature, same unit
  std::vector<PolygonPart> parts;  ///< ascending; empty for nearest, max and force
  std::string missing;             ///< why there is no value
  long rays = 0;                   ///< number of rays that were cast
};

/// Approximate largest number of rays of one exact reading.
inline constexpr long kExactRays = 60000;
/// Default error of the quadrature as a fraction of the reading.
inline constexpr double kExactAccuracy = 5e-4;

/// How an exact reading is computed.
struct ExactOptions {
  double accuracy = kExactAccuracy;        ///< largest error of the quadrature, as a fraction of the reading
  FieldNormals rays = FieldNormals::face;  ///< normals of the skin against which the rays start
};

}  // namespace taxel
