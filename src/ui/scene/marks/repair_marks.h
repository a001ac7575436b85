// Changes of a mesh by its repair, drawn over its skin: filled faces, removed faces, separated edges, distances of a
// wrap.
#pragma once

#include "core/mesh/repair/repair.h"
#include "ui/scene/paint/paint.h"
#include "ui/scene/paint/segments.h"

namespace taxel::ui {

class RepairMarks {
 public:
  /// Draws the changes from the loaded to the repaired mesh, in the frame of `state`.
  void draw(const RepairedMeshPtr& repaired, const TriMeshPtr& loaded, const PaintPass& paint, SegmentPass& segments,
            const MarkState& state);

 private:
  void make(const TriMesh& loaded);

  RepairedMeshPtr repaired_;
  PaintBuffer faces_;
  Segments removed_, parted_;
};

}  // namespace taxel::ui
