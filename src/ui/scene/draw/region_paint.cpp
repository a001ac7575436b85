#include "ui/scene/draw/region_paint.h"

#include "ui/scene/draw/segments.h"

namespace taxel::ui {

namespace {
constexpr glm::vec4 kTint{0.10f, 0.62f, 0.78f, 0.45f};
}

const PaintBuffer& RegionPaint::take(const TriMeshPtr& mesh, const FaceSet& region) {
  if (mesh == mesh_ && region.identity() == region_.identity()) return triangles_;
  std::vector<PaintVertex> vertices;
  for (const int face : *region) {
    if (face < 0 || face >= mesh->face_count()) continue;
    append_piece({mesh->vertex(face, 0), mesh->vertex(face, 1), mesh->vertex(face, 2), face}, pack(kTint), vertices);
  }
  triangles_.upload(vertices);
  mesh_ = mesh;
  region_ = region;
  return triangles_;
}

}  // namespace taxel::ui
