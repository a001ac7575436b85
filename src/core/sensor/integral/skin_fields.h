// The receptive fields as functions on the skin, for the readings that are integrals over the contact polygons.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/layout/field/field_weights.h"
#include "core/mesh/query/nearest_guess.h"
#include "core/sensor/integral/face_fields.h"
#include "core/sensor/integral/ray_prisms.h"

namespace taxel {

/// The integral over the contact polygons that is the limit of an aggregate for ever more samples.
enum class IntegralKind {
  none,
  weighted_mean,  ///< pressure_integral.h
  mean,           ///< pressure_integral.h
  force           ///< force_integral.h
};

/// All that the integrals of one model need, computed once. Immutable.
struct SkinFields {
  std::shared_ptr<const FieldWeights> weights;
  FaceFields faces;
  std::optional<NearestGuess> nearest;  ///< for IntegralKind::force
  std::optional<RayPrisms> prisms;      ///< for the other integrals
  /// Integral of the weight over the sampled part of each taxel's field, for the other integrals.
  std::vector<double> whole;
};
using SkinFieldsPtr = std::shared_ptr<const SkinFields>;

}  // namespace taxel
