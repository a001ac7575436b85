#include "ui/scene/paint/region_paint.h"

#include "core/mesh/loaded_faces.h"
#include "ui/scene/paint/segments.h"

namespace taxel::ui {

namespace {
constexpr glm::vec4 kTint{0.10f, 0.62f, 0.78f, 0.45f};
}

const PaintBuffer& RegionPaint::take(const RepairedMeshPtr& repaired, const FaceSet& region) {
  if (repaired == mesh_ && region.identity() == region_.identity()) return triangles_;
  std::vector<PaintVertex> vertices;
  const TriMesh& mesh = *repaired->mesh;
  for (const int face : repaired_faces(*repaired, *region)) {
    if (face < 0 || face >= mesh.face_count()) continue;
    append_piece({mesh.vertex(face, 0), mesh.vertex(face, 1), mesh.vertex(face, 2), face}, pack(kTint), vertices);
  }
  triangles_.upload(vertices);
  mesh_ = repaired;
  region_ = region;
  return triangles_;
}

}  // namespace taxel::ui
