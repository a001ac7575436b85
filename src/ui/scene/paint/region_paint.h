// The painted region as a tint on the skin, in GPU memory.
#pragma once

#include "core/base/shared_value.h"
#include "core/mesh/repair/repair.h"
#include "ui/scene/paint/paint.h"

namespace taxel::ui {

class RegionPaint {
 public:
  /// Returns the triangles of the region, and rebuilds them if the mesh or the region has changed since the last call.
  /// `region` has faces of the loaded mesh; faces that the mesh does not have are left out.
  const PaintBuffer& take(const RepairedMeshPtr& mesh, const FaceSet& region);

 private:
  RepairedMeshPtr mesh_;
  FaceSet region_;
  PaintBuffer triangles_;
};

}  // namespace taxel::ui
