// The painted region as a tint on the skin; kept on the card.
#pragma once

#include "core/base/shared_value.h"
#include "core/mesh/repair/repair.h"
#include "ui/scene/paint/paint.h"

namespace taxel::ui {

class RegionPaint {
 public:
  /// Made again if mesh or region are others than last time. `region`: faces of the mesh as loaded; those that the mesh
  /// does not have are left out.
  const PaintBuffer& take(const RepairedMeshPtr& mesh, const FaceSet& region);

 private:
  RepairedMeshPtr mesh_;
  FaceSet region_;
  PaintBuffer triangles_;
};

}  // namespace taxel::ui
