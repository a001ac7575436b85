// Geometry of the receptive fields in the latest model of one sensor. After an edit only changed fields are computed.
#pragma once

#include <array>

#include "ui/scene/geometry/coverage.h"
#include "ui/scene/geometry/field_patch.h"
#include "ui/scene/geometry/per_taxel.h"

namespace taxel::ui {

class FieldGeometry {
 public:
  /// Returns the boundaries of the fields by the metric of the layout, one list for each taxel.
  const std::vector<std::vector<RingPiece>>& rings(const SensorModel& model);
  const std::vector<FieldPatch>& patches(const SensorModel& model, FieldPart part);
  Coverage coverage(const SensorModel& model) { return make_coverage(model, coverage_); }

 private:
  const std::shared_ptr<const UnfoldedMesh>& unfolded(const SensorModel& model);

  PerTaxel<std::vector<RingPiece>> rings_;
  std::array<PerTaxel<FieldPatch>, 3> patches_;  // indexed by FieldPart
  std::shared_ptr<const UnfoldedMesh> unfolded_;
  CoverageMemory coverage_;
};

}  // namespace taxel::ui
