// The painted region as a tint on the skin; kept on the card.
#pragma once

#include "core/base/shared_value.h"
#include "core/mesh/tri_mesh.h"
#include "ui/scene/draw/paint.h"

namespace taxel::ui {

class RegionPaint {
 public:
  /// Made anew where mesh or region are others than last time. Faces that the mesh has not are left out.
  const PaintBuffer& take(const TriMeshPtr& mesh, const FaceSet& region);

 private:
  TriMeshPtr mesh_;
  FaceSet region_;
  PaintBuffer triangles_;
};

}  // namespace taxel::ui
