// Changes of a mesh by its repair, drawn over its skin.
#include "ui/scene/marks/marks.h"

#include "core/base/math.h"

namespace taxel::ui {
namespace {

constexpr float kFilledAlpha = 0.75f, kDistanceAlpha = 0.9f;
constexpr float kRemovedWidth = 2.0f, kPartedWidth = 3.2f;  // [pixel]
constexpr float kRepairBeforeSkin = 0.006f;                 // in parts of the depth
constexpr float kHiddenRepairDim = 0.3f;

}  // namespace

void RepairMarks::make(const TriMesh& loaded) {
  const TriMesh& mesh = *repaired_->mesh;
  const RepairChanges& changes = repaired_->changes;
  std::vector<PaintVertex> triangles;
  const double largest = largest_distance(changes);
  const bool wrapped = changes.distance.size() == mesh.vertices().size() && largest > 0;
  for (int f = 0; wrapped && f < mesh.face_count(); ++f) {
    for (int c = 0; c < 3; ++c) {
      const double distance = static_cast<double>(changes.distance[at(mesh.faces()[at(f)][c])]);
      triangles.push_back(
          {glm::vec3(mesh.vertex(f, c)), pack(glm::vec4(distance_color(distance, largest), kDistanceAlpha))});
    }
  }
  const std::uint32_t filled = pack(glm::vec4(kFilledColor, kFilledAlpha));
  for (const int f : changes.filled_faces)
    append_piece({mesh.vertex(f, 0), mesh.vertex(f, 1), mesh.vertex(f, 2), f}, filled, triangles);
  faces_.upload(triangles);
  removed_.clear();
  for (const int f : changes.removed_faces)
    for (int c = 0; c < 3 && !wrapped; ++c)
      removed_.push_back(
          segment(loaded.vertex(f, c), loaded.vertex(f, (c + 1) % 3), kRemovedWidth, pack(kRemovedColor)));
  parted_.clear();
  for (const auto& [a, b] : changes.parted_edges) parted_.push_back(segment(a, b, kPartedWidth, pack(kPartedColor)));
}

void RepairMarks::draw(const RepairedMeshPtr& repaired, const TriMeshPtr& loaded, const PaintPass& paint,
                       SegmentPass& segments, const MarkState& state) {
  if (repaired != repaired_) {
    repaired_ = repaired;
    make(*loaded);
  }
  paint.draw(faces_, state);
  MarkState lines = state;
  lines.toward_eye = kRepairBeforeSkin;
  MarkState behind = lines;
  behind.hidden = true;
  behind.dim = kHiddenRepairDim;
  for (const Segments* some : {&removed_, &parted_}) {
    segments.draw_lines(*some, behind);
    segments.draw_lines(*some, lines);
  }
}

}  // namespace taxel::ui
