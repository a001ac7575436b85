// The end of a repair: its mesh, where each face comes from, and the list of changes.
#include "core/mesh/query/nearest_in_turn.h"
#include "core/mesh/repair/repair_run.h"
#include "core/mesh/repair/steps/shells.h"
#include "core/mesh/repair/wrap/distances.h"

namespace taxel {

RepairedMesh RepairRun::finish() {
  RepairedMesh repaired;
  repaired.report.has_sheets = !sheets_.faces.empty();
  append(draft_, sheets_);
  drop_unused_points(draft_);
  repaired.report.steps = std::move(steps_);
  if (is_as_loaded()) {
    repaired.mesh = loaded_;
    repaired.crossings = loaded_crossings_;
    return repaired;
  }
  repaired.mesh = std::make_shared<const TriMesh>(std::move(draft_.points), draft_.faces);
  repaired.changes = std::move(changes_);
  list_changes(repaired);
  repaired.loaded_face_of = std::move(draft_.loaded);
  if (has_wrapped()) {
    begin("Measuring the wrap", 0.9);
    find_nearest_faces(loaded_index(), repaired);
    measure_distances(loaded_index(), wrap_edge_, repaired);
    repaired.report.wrap_edge = wrap_edge_;
    repaired.report.is_coarser = wrap_edge_ > limits_.edge;
  }
  return repaired;
}

void RepairRun::find_nearest_faces(const MeshIndex& loaded, RepairedMesh& repaired) {
  NearestInTurn nearest(loaded);
  for (int f = 0; f < repaired.mesh->face_count(); ++f) {
    int& from = repaired.loaded_face_of[at(f)];
    if (from != kWrappedFace) continue;
    const TriMesh& mesh = *repaired.mesh;
    from = nearest.closest_point((mesh.vertex(f, 0) + mesh.vertex(f, 1) + mesh.vertex(f, 2)) / 3.0).face;
  }
}

/// A loaded face without remaining area is removed. If a part remains, the rest is inside a union. Of a wrap only the
/// difference of areas is known.
void RepairRun::list_changes(RepairedMesh& repaired) const {
  const TriMesh& mesh = *repaired.mesh;
  RepairReport& report = repaired.report;
  if (has_wrapped()) {
    report.area_added = std::max(0.0, mesh.area() - loaded_->area());
    report.area_removed = std::max(0.0, loaded_->area() - mesh.area());
    return;
  }
  std::vector<double> left(loaded_->faces().size(), 0);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const int from = draft_.loaded[at(f)];
    if (from >= 0) {
      left[at(from)] += mesh.face_areas()[at(f)];
      continue;
    }
    repaired.changes.filled_faces.push_back(f);
    report.area_added += mesh.face_areas()[at(f)];
  }
  for (int f = 0; f < loaded_->face_count(); ++f) {
    if (left[at(f)] == 0) repaired.changes.removed_faces.push_back(f);
    report.area_removed += std::max(0.0, loaded_->face_areas()[at(f)] - left[at(f)]);
  }
}

}  // namespace taxel
