#include "core/mesh/repair/repair_run.h"

#include <fmt/format.h>

#include "core/base/text/number_text.h"
#include "core/mesh/repair/steps/shells.h"
#include "core/mesh/repair/wrap/distances.h"
#include "core/mesh/repair/wrap/wrap.h"

namespace taxel {
namespace {

constexpr int kMaxFacesToWrap = 500000;

std::vector<int> all_faces(const Draft& draft) {
  std::vector<int> faces(draft.faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) faces[f] = static_cast<int>(f);
  return faces;
}

/// Some faces of a draft with all of its points.
Draft part_of(const Draft& draft, const std::vector<char>& chosen) {
  Draft part{draft.points, {}, {}};
  for (int f = 0; f < draft.face_count(); ++f)
    if (chosen[at(f)] != 0) part.add(draft.faces[at(f)], draft.loaded[at(f)]);
  drop_unused_points(part);
  return part;
}

double area_of(const Draft& draft, const std::vector<int>& faces) {
  double area = 0;
  for (const int f : faces) area += draft.area(f);
  return area;
}

/// A nonzero entry for each face at an edge that is not shared by two faces in opposite directions.
std::vector<char> faces_at_open_edges(const Draft& draft) {
  std::vector<char> open(draft.faces.size(), 0);
  const EdgeTopology edges = draft.edges();
  for (int h = 0; h < edges.half_edge_count(); ++h)
    if (edges.twin(h) < 0) open[at(h / 3)] = 1;
  return open;
}

/// Shells that holes were filled in and that still enclose almost nothing.
struct ThinShells {
  std::vector<std::vector<int>> shells;
  bool has_solid = false;  ///< there are other shells
  WindingNumber solid;     ///< winding number of the other shells
};

ThinShells find_thin_shells(const Draft& draft, const RepairLimits& limits) {
  constexpr double kThin = 0.05;     // thickness of a shell that is a sheet, of the thickness of its body
  constexpr double kNothing = 1e-9;  // smallest thickness as a fraction of the diagonal
  std::vector<std::vector<int>> thin;
  std::vector<ivec3> others;
  for (const std::vector<int>& shell : find_shells(draft).faces) {
    const double thickness = std::max(kThin * limits.thickness, kNothing * limits.diagonal);
    if (std::any_of(shell.begin(), shell.end(), [&](int f) { return draft.loaded[at(f)] == kFilledFace; }) &&
        std::abs(volume_of(draft, shell)) < thickness * area_of(draft, shell))
      thin.push_back(shell);
    else
      for (const int f : shell) others.push_back(draft.faces[at(f)]);
  }
  const bool has_solid = !others.empty();
  return {std::move(thin), has_solid, WindingNumber(draft.points, std::move(others))};
}

bool is_inside(const Draft& draft, const std::vector<int>& shell, const WindingNumber& solid) {
  return std::all_of(shell.begin(), shell.end(), [&](int f) { return std::abs(solid(draft.center(f))) > 0.5; });
}

}  // namespace

RepairRun::RepairRun(const TriMeshPtr& loaded, const RepairRecipe& recipe, const RepairLimits& limits,
                     const Progress* progress)
    : loaded_(loaded), recipe_(recipe), limits_(limits), progress_(progress), draft_(make_draft(*loaded)) {}

void RepairRun::run() {
  if (!loaded_->closed()) close_without_filling();
  note(part_touching(draft_, changes_));
  if (!is_closed()) {
    fill();
    take_open_shells();
    take_thin_shells();
  }
  check_encloses();
  if (!draft_.faces.empty()) note(orient_shells(draft_));
  if (recipe_.level == RepairLevel::wrap)
    take_all();
  else if (recipe_.level == RepairLevel::automatic)
    take_crossed_shells();
  if (!to_wrap_.empty()) wrap();
  unite();
  if (is_closed()) return;
  take_all();
  wrap();
}

void RepairRun::note(RepairStep step) {
  if (progress_ != nullptr) progress_->stop_if_cancelled();
  if (step.count == 0) return;
  for (RepairStep& earlier : steps_) {
    if (earlier.code != step.code) continue;
    earlier.count += step.count;
    earlier.faces += step.faces;
    earlier.area += step.area;
    earlier.length = std::max(earlier.length, step.length);
    earlier.severity = std::max(earlier.severity, step.severity);
    return;
  }
  steps_.push_back(std::move(step));
}

void RepairRun::take(const std::vector<char>& chosen, WrapKind kind) {
  if (std::none_of(chosen.begin(), chosen.end(), [](char c) { return c != 0; })) return;
  to_wrap_.push_back({part_of(draft_, chosen), kind});
  remove_faces(draft_, chosen);
}

void RepairRun::close_without_filling() {
  note(remove_repeated(draft_));
  note(remove_folded(draft_));
  note(remove_fins(draft_, limits_));
  const RepairStep joined = join_rims(draft_, limits_);
  note(joined);
  if (joined.count > 0) {
    note(remove_repeated(draft_));
    note(remove_folded(draft_));
  }
  note(turn_flat_faces(draft_));
  note(split_junctions(draft_, limits_));
  std::vector<char> unorientable;
  note(wind_alike(draft_, unorientable));
  take(unorientable, WrapKind::two_sided_sheet);
}

/// A filled hole may leave flat faces or faces that touch others: these are turned and parted in a further round.
void RepairRun::fill() {
  constexpr int kMaxRounds = 4;
  for (int round = 0; round < kMaxRounds && !is_closed() && !draft_.faces.empty(); ++round) {
    note(fill_holes(draft_, limits_));
    // The hole around a face that nothing is joined to is filled by the same face turned. Only if there is nothing else
    // it is a sheet.
    Draft unfolded = draft_;
    join_equal_points(unfolded);
    const RepairStep folded = remove_folded(unfolded);
    if (!unfolded.faces.empty() && folded.count > 0) {
      draft_ = std::move(unfolded);
      note(folded);
    }
    note(turn_flat_faces(draft_));
    note(split_junctions(draft_, limits_));
    note(part_touching(draft_, changes_));
  }
}

/// Shells that filling did not close are wrapped as solids.
void RepairRun::take_open_shells() {
  const std::vector<char> open = faces_at_open_edges(draft_);
  std::vector<char> chosen(draft_.faces.size(), 0);
  for (const std::vector<int>& shell : find_shells(draft_).faces) {
    if (std::none_of(shell.begin(), shell.end(), [&](int f) { return open[at(f)] != 0; })) continue;
    for (const int f : shell) chosen[at(f)] = 1;
  }
  take(chosen, WrapKind::solid);
}

/// Filled shells that enclose less than 0.05 area x thickness. Next to solid shells, small ones are debris, and those
/// inside of a solid are walls: both go. The others are sheets.
void RepairRun::take_thin_shells() {
  constexpr double kDebris = 0.02;  // largest area of all debris as a fraction of the loaded area
  const ThinShells thin = find_thin_shells(draft_, limits_);
  if (thin.shells.empty()) return;
  std::vector<char> gone(draft_.faces.size(), 0), sheet(draft_.faces.size(), 0);
  RepairStep removed = start_step("repair_fin");
  for (const std::vector<int>& shell : thin.shells) {
    const double area = area_of(draft_, shell);
    const bool is_debris = thin.has_solid && removed.area + area <= kDebris * limits_.loaded_area;
    const bool is_removed = is_debris || is_inside(draft_, shell, thin.solid);
    if (is_removed) {
      add_place(removed, draft_.center(shell.front()));
      removed.area += area;
    }
    for (const int f : shell) {
      gone[at(f)] = 1;
      if (draft_.loaded[at(f)] == kFilledFace) continue;
      removed.faces += is_removed ? 1 : 0;
      sheet[at(f)] = is_removed ? 0 : 1;
    }
  }
  Draft rest = draft_;
  remove_faces(rest, gone);
  take(sheet, WrapKind::sheet);
  draft_ = std::move(rest);
  recount_filled();
  note(removed);
}

/// Drops holes whose filled-in faces were removed from the report.
void RepairRun::recount_filled() {
  const auto step =
      std::find_if(steps_.begin(), steps_.end(), [](const RepairStep& s) { return s.code == "repair_filled"; });
  if (step == steps_.end()) return;
  step->faces = 0;
  step->area = 0;
  for (int f = 0; f < draft_.face_count(); ++f) {
    if (draft_.loaded[at(f)] != kFilledFace) continue;
    ++step->faces;
    step->area += draft_.area(f);
  }
  if (step->faces == 0) steps_.erase(step);
}

/// Shells that cut through each other are united, not wrapped. The whole is examined first, because it is fast.
void RepairRun::take_crossed_shells() {
  if (draft_.face_count() > kMaxFacesToWrap || draft_.faces.empty() || !is_crossed()) return;
  std::vector<char> chosen(draft_.faces.size(), 0);
  for (const std::vector<int>& shell : find_shells(draft_).faces) {
    std::vector<char> own(draft_.faces.size(), 0);
    for (const int f : shell) own[at(f)] = 1;
    if (!cuts_through_itself(part_of(draft_, own))) continue;
    for (const int f : shell) chosen[at(f)] = 1;
  }
  take(chosen, WrapKind::solid);
}

/// Returns true if the whole draft cuts through itself. Opening a layout reports the same faces, so a search in an
/// unchanged mesh is kept for that.
bool RepairRun::is_crossed() {
  if (!is_as_loaded()) return cuts_through_itself(draft_);
  loaded_crossings_ = find_self_intersections(*loaded_);
  return cuts_through_itself(*loaded_crossings_, loaded_->face_count());
}

void RepairRun::take_all() {
  take(std::vector<char>(draft_.faces.size(), 1), WrapKind::solid);
}

void RepairRun::check_encloses() const {
  constexpr double kNothing = 1e-12;
  double volume = 0;
  for (const std::vector<int>& shell : find_shells(draft_).faces) volume += std::abs(volume_of(draft_, shell));
  if (!to_wrap_.empty() || volume > kNothing * limits_.loaded_area * limits_.diagonal) return;
  throw Error("", "/mesh/file", "encloses nothing: its faces have no inside");
}

void RepairRun::refuse_wrap() const {
  const Draft& first = to_wrap_.front().faces;
  const std::string place = place_in_mm(first.center(0));
  if (recipe_.level == RepairLevel::exact)
    throw Error(
        "", "/mesh/repair/level",
        fmt::format("is \"exact\", but exact steps cannot close the surface at {}: set it to \"auto\" to allow a wrap",
                    place));
  if (loaded_->face_count() > kMaxFacesToWrap && !recipe_.edge)
    throw Error(
        "", "/mesh/repair/edge",
        fmt::format("must be set (in metres) to wrap a mesh of more than {} faces: it has {}, the first to wrap at {}",
                    kMaxFacesToWrap, loaded_->face_count(), place));
}

void RepairRun::wrap() {
  constexpr double kEdgesOfASheet = 3;  // across its thickness: fewer would lose it between the lattice's nodes
  refuse_wrap();
  RepairStep wrapped = start_step("repair_wrapped"), sheets = start_step("repair_sheet");
  for (const ToWrap& part : to_wrap_) {
    const int before = draft_.face_count();
    RepairLimits limits = limits_;
    if (part.kind != WrapKind::solid) limits.edge = std::min(limits.edge, limits.thickness / kEdgesOfASheet);
    wrap_faces(draft_, part.faces, all_faces(part.faces), part.kind, limits, progress_);
    RepairStep& step = part.kind == WrapKind::solid ? wrapped : sheets;
    const std::size_t shells = find_shells(part.faces).faces.size();
    for (std::size_t s = 0; s < shells; ++s) add_place(step, part.faces.center(0));
    step.faces += draft_.face_count() - before;
    step.area += area_of(part.faces, all_faces(part.faces));
    step.severity = Severity::warning;
  }
  to_wrap_.clear();
  has_wrapped_ = true;
  note(wrapped);
  note(sheets);
  if (!draft_.faces.empty()) return;
  throw Error("", "/mesh/file", "encloses nothing that an edge of the wrap can resolve");
}

/// A union may leave faces without area: these are turned.
void RepairRun::unite() {
  const RepairStep united = unite_shells(draft_, limits_);
  note(united);
  if (united.count == 0 && !has_wrapped_) return;
  note(turn_flat_faces(draft_));
  note(part_touching(draft_, changes_));
  if (!is_closed()) fill();
}

bool RepairRun::is_closed() const {
  const std::vector<char> open = faces_at_open_edges(draft_);
  return !draft_.faces.empty() && std::none_of(open.begin(), open.end(), [](char c) { return c != 0; });
}

bool RepairRun::is_as_loaded() const {
  return draft_.faces == loaded_->faces() && draft_.points == loaded_->vertices();
}

RepairedMesh RepairRun::finish() {
  drop_unused_points(draft_);
  RepairedMesh repaired;
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
  if (has_wrapped_) {
    find_nearest_faces(repaired);
    measure_distances(loaded_, limits_.edge, repaired);
  }
  return repaired;
}

void RepairRun::find_nearest_faces(RepairedMesh& repaired) const {
  const MeshIndex index(loaded_);
  for (int f = 0; f < repaired.mesh->face_count(); ++f) {
    int& from = repaired.loaded_face_of[at(f)];
    if (from != kWrappedFace) continue;
    const TriMesh& mesh = *repaired.mesh;
    from = index.closest_point((mesh.vertex(f, 0) + mesh.vertex(f, 1) + mesh.vertex(f, 2)) / 3.0).face;
  }
}

/// A loaded face without remaining area is removed. If a part remains, the rest is inside a union. Of a wrap only the
/// difference of areas is known.
void RepairRun::list_changes(RepairedMesh& repaired) const {
  const TriMesh& mesh = *repaired.mesh;
  RepairReport& report = repaired.report;
  if (has_wrapped_) {
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
