// The order of the steps of a repair with the decisions between them, and its end: the mesh, where each face comes
// from, and the list of changes.
//
// Exact steps come first, since they keep the faces: repeated and folded faces, fins, rims, junctions, winding, holes.
// Then each shell is looked at alone. One that stays open, or whose crossings cannot be cut out, is wrapped as a solid;
// one that encloses almost nothing is a sheet, and gets a thickness or, of a rigid body, a second side. Shells that
// share space are united last. A step that finds nothing leaves the draft as it is, and a sound mesh is returned as the
// same object.
//
// Pitfalls: a filled hole may leave flat faces or faces that touch, so these steps run again; crossings are searched in
// the whole mesh first, which is fast, and by shell only if there are any. A wrap's edge grows with the mesh so that
// its time is bounded. Theory: docs/theory/mesh.md, "Mesh repair".
#include "core/mesh/repair/repair_run.h"

#include <fmt/format.h>

#include "core/base/text/message.h"
#include "core/mesh/query/nearest.h"
#include "core/mesh/repair/steps.h"
#include "core/mesh/repair/wrap/wrap.h"

namespace taxel {
namespace {

constexpr int kMaxFacesToWrap = 500000;

// Fractions of a repair after which its steps begin, about as their times.
constexpr double kFill = 0.15, kOrient = 0.25, kCross = 0.3, kWrap = 0.45, kUnite = 0.8;

std::vector<int> all_faces(const Draft& draft) {
  std::vector<int> faces(draft.faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) faces[f] = static_cast<int>(f);
  return faces;
}

/// Some faces of a draft with their points.
Draft part_of(const Draft& draft, const std::vector<char>& chosen) {
  std::vector<int> faces;
  for (int f = 0; f < draft.face_count(); ++f)
    if (chosen[at(f)] != 0) faces.push_back(f);
  return extract_faces(draft, faces);
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
  bool has_solid = false;                ///< there are other shells
  std::unique_ptr<WindingNumber> solid;  ///< winding number of the other shells, or null without a thin one
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
  if (thin.empty()) return {{}, has_solid, nullptr};
  return {std::move(thin), has_solid, std::make_unique<WindingNumber>(draft.points, std::move(others))};
}

bool is_inside(const Draft& draft, const std::vector<int>& shell, const WindingNumber& solid) {
  return std::all_of(shell.begin(), shell.end(), [&](int f) { return std::abs(solid(draft.center(f))) > 0.5; });
}

const MeshIndex& source_index(RepairSource& source) {
  if (source.index == nullptr) source.index = std::make_unique<MeshIndex>(source.mesh, Bvh::Effort::few_queries);
  return *source.index;
}

const SelfIntersections& source_crossings(RepairSource& source) {
  if (!source.crossings) source.crossings = find_self_intersections(*source.mesh, source_index(source).tree());
  return *source.crossings;
}

/// Sets the nearest loaded face of each face of a wrap.
void find_nearest_faces(const MeshIndex& loaded, RepairedMesh& repaired) {
  NearestInTurn nearest(loaded);
  for (int f = 0; f < repaired.mesh->face_count(); ++f) {
    int& from = repaired.loaded_face_of[at(f)];
    if (from != kWrappedFace) continue;
    const TriMesh& mesh = *repaired.mesh;
    from = nearest.closest_point((mesh.vertex(f, 0) + mesh.vertex(f, 1) + mesh.vertex(f, 2)) / 3.0).face;
  }
}

}  // namespace

RepairRun::RepairRun(const TriMeshPtr& loaded, const RepairRecipe& recipe, const RepairLimits& limits,
                     Progress* progress)
    : loaded_{loaded, nullptr, std::nullopt},
      recipe_(recipe),
      limits_(limits),
      progress_(progress),
      draft_(make_draft(*loaded)) {}

void RepairRun::run() {
  begin("Joining rims", 0);
  if (!loaded_.mesh->closed()) close_without_filling();
  note(part_touching(draft_, changes_));
  if (!is_closed()) {
    begin("Filling holes", kFill);
    fill();
    take_open_shells();
    take_thin_shells();
  }
  if (recipe_.has_two_sided_sheets)
    set_sheets_aside();
  else
    check_encloses();
  begin("Orienting shells", kOrient);
  if (!draft_.faces.empty()) note(orient_shells(draft_));
  if (recipe_.level == RepairLevel::wrap)
    take_all();
  else if (recipe_.level == RepairLevel::automatic)
    cure_crossed_shells(Crossed::cut_or_wrap);
  if (!to_wrap_.empty()) wrap();
  if (draft_.faces.empty()) return;  // only sheets
  begin("Uniting shells", kUnite);
  const bool has_united = unite();
  if (!is_closed() && recipe_.has_two_sided_sheets) {
    take_open_shells();
    set_sheets_aside();
  } else if (!is_closed()) {
    take_all();
    wrap();
  }
  const bool may_cross = has_united || has_wrapped();
  if (recipe_.level == RepairLevel::automatic && may_cross) cure_crossed_shells(Crossed::cut);
}

void RepairRun::begin(const char* step, double fraction) {
  if (progress_ == nullptr) return;
  progress_->set_step(step);
  progress_->check(std::max(fraction, progress_->reached()));
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
  note(join_short_edges(draft_, limits_));
  note(remove_repeated(draft_));
  remove_folds();
  note(remove_fins(draft_, limits_));
  const RepairStep joined = join_rims(draft_, limits_);
  note(joined);
  if (joined.count > 0) {
    note(remove_repeated(draft_));
    remove_folds();
  }
  note(turn_flat_faces(draft_));
  note(split_junctions(draft_, limits_));
  std::vector<char> unorientable;
  note(wind_alike(draft_, unorientable));
  take(unorientable, WrapKind::two_sided_sheet);
}

/// If every face is folded, the file has both sides of one surface: a sheet keeps one of them.
void RepairRun::remove_folds() {
  Draft unfolded = draft_;
  const RepairStep folded = remove_folded(unfolded);
  if (unfolded.faces.empty() && recipe_.has_two_sided_sheets) {
    note(remove_back_faces(draft_));
  } else {
    draft_ = std::move(unfolded);
    note(folded);
  }
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
  std::vector<char> to_remove(draft_.faces.size(), 0), sheet(draft_.faces.size(), 0);
  RepairStep removed = start_step("repair_fin");
  for (const std::vector<int>& shell : thin.shells) {
    const double area = area_of(draft_, shell);
    const bool is_debris = thin.has_solid && removed.area + area <= kDebris * limits_.loaded_area;
    const bool is_removed = is_debris || is_inside(draft_, shell, *thin.solid);
    if (is_removed) {
      add_place(removed, draft_.center(shell.front()));
      removed.area += area;
    }
    for (const int f : shell) {
      to_remove[at(f)] = 1;
      if (draft_.loaded[at(f)] == kFilledFace) continue;
      removed.faces += is_removed ? 1 : 0;
      sheet[at(f)] = is_removed ? 0 : 1;
    }
  }
  Draft rest = draft_;
  remove_faces(rest, to_remove);
  take(sheet, WrapKind::sheet);
  draft_ = std::move(rest);
  recount_filled();
  note(removed);
}

/// Gives surfaces that no exact step closes a second side, and keeps them apart from the solids.
void RepairRun::set_sheets_aside() {
  RepairStep step = start_step("repair_two_sided");
  for (const ToWrap& part : to_wrap_) {
    Draft back = part.faces;
    for (ivec3& face : back.faces) std::swap(face.y, face.z);
    append(sheets_, part.faces);
    append(sheets_, back);
    add_place(step, part.faces.center(0));
    step.faces += part.faces.face_count();
    step.area += area_of(part.faces, all_faces(part.faces));
  }
  to_wrap_.clear();
  note(std::move(step));
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

/// Faces that cross each other are cut out of a shell where that is possible, otherwise this shell alone is wrapped.
/// Shells that cut through each other are united instead. A shell with few crossings is treated only if the repair has
/// made more of them than were loaded. The whole is examined first, because that is fast. Larger meshes than a wrap may
/// have stay as they are.
void RepairRun::cure_crossed_shells(Crossed treatment) {
  if (draft_.faces.empty() || draft_.face_count() > kMaxFacesToWrap) return;
  begin("Finding faces that cross", kCross);
  if (!is_crossed()) return;
  const FaceShells shells = find_shells(draft_);
  OwnCrossings own = find_own_crossings(draft_, shells);
  std::optional<bool> has_more;  // than were loaded: searched only for shells with few crossings
  const auto is_treated = [&](std::size_t count, bool is_severe) {
    if (is_severe || count == 0) return is_severe;
    if (!has_more) has_more = !is_as_loaded() && own.count_all(draft_) > source_crossings(loaded_).pairs;
    return *has_more;
  };
  std::vector<char> to_remove(draft_.faces.size(), 0);
  Draft cured;
  RepairStep step = start_step("repair_cut");
  for (std::size_t s = 0; s < own.pairs.size(); ++s) {
    const std::vector<int>& faces = shells.faces[s];
    std::vector<std::pair<int, int>>& pairs = own.pairs[s];
    const auto few = at(few_pairs(static_cast<int>(faces.size())));
    const bool is_severe = own.is_hopeless[s] != 0 || pairs.size() > few;
    if (!is_treated(pairs.size(), is_severe)) continue;
    Draft shell = extract_faces(draft_, faces);
    const auto number = [&](int f) {
      return static_cast<int>(std::lower_bound(faces.begin(), faces.end(), f) - faces.begin());
    };
    for (auto& [f, g] : pairs) {
      f = number(f);
      g = number(g);
    }
    const bool is_cut =
        own.is_hopeless[s] == 0 && cut_crossings(shell, pairs, std::min(few, pairs.size() - 1), limits_, step);
    const bool may_wrap = treatment == Crossed::cut_or_wrap && is_severe;
    if (!is_cut && !may_wrap) continue;
    for (const int f : faces) to_remove[at(f)] = 1;
    if (is_cut)
      append(cured, shell);
    else
      to_wrap_.push_back({std::move(shell), WrapKind::solid});
  }
  remove_faces(draft_, to_remove);
  append(cured, draft_);
  draft_ = std::move(cured);
  note(std::move(step));
}

/// Returns true if faces of the draft cross: for the loaded mesh more than a few, otherwise any. Opening a layout
/// reports the same faces of an unchanged mesh, so their search is kept for that.
bool RepairRun::is_crossed() {
  if (is_as_loaded()) return source_crossings(loaded_).pairs > few_pairs(loaded_.mesh->face_count());
  return true;
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
  if (loaded_.mesh->face_count() > kMaxFacesToWrap && !recipe_.edge)
    throw Error(
        "", "/mesh/repair/edge",
        fmt::format("must be set (in metres) to wrap a mesh of more than {} faces: it has {}, the first to wrap at {}",
                    kMaxFacesToWrap, loaded_.mesh->face_count(), place));
}

/// Chooses the edge of all wraps: larger than the default if that would take too long. The other steps of a large mesh
/// take as long as its wrap, so less is left for that.
double RepairRun::choose_edge() const {
  constexpr double kMaxSquares = 10000;  // squares of one edge on all surfaces: two seconds of one core
  constexpr double kManyFaces = 20000;   // loaded faces of which each further one leaves less for the wrap
  if (recipe_.edge) return limits_.edge;
  double area = 0;
  for (const ToWrap& part : to_wrap_) {
    const int sides = part.kind == WrapKind::solid ? 1 : 2;
    area += sides * area_of(part.faces, all_faces(part.faces));
  }
  const double squares = kMaxSquares * std::sqrt(std::min(1.0, kManyFaces / loaded_.mesh->face_count()));
  return std::max(limits_.edge, std::sqrt(area / squares));
}

void RepairRun::wrap() {
  // Edges across the thickness of a sheet. Fewer would lose it between the nodes of the grid.
  constexpr double kEdgesOfASheet = 3, kLeastEdgesOfASheet = 2;
  refuse_wrap();
  RepairStep wrapped = start_step("repair_wrapped"), sheets = start_step("repair_sheet");
  const double edge = choose_edge();
  double wrapped_faces = 0, faces_to_wrap = 0;
  for (const ToWrap& part : to_wrap_) faces_to_wrap += part.faces.face_count();
  for (const ToWrap& part : to_wrap_) {
    begin("Wrapping", kWrap + (kUnite - kWrap) * wrapped_faces / faces_to_wrap);
    wrapped_faces += part.faces.face_count();
    const int before = draft_.face_count();
    RepairLimits limits = limits_;
    limits.edge = edge;
    limits.tolerance *= edge / limits_.edge;
    if (part.kind != WrapKind::solid)
      limits.edge = std::min(edge, limits.thickness / (edge > limits_.edge ? kLeastEdgesOfASheet : kEdgesOfASheet));
    wrap_faces(draft_, part.faces, part.kind, limits, progress_);
    RepairStep& step = part.kind == WrapKind::solid ? wrapped : sheets;
    const std::size_t shells = find_shells(part.faces).faces.size();
    for (std::size_t s = 0; s < shells; ++s) add_place(step, part.faces.center(0));
    step.faces += draft_.face_count() - before;
    step.area += area_of(part.faces, all_faces(part.faces));
    step.severity = Severity::warning;
  }
  to_wrap_.clear();
  wrap_edge_ = std::max(wrap_edge_, edge);
  note(wrapped);
  note(sheets);
  if (!draft_.faces.empty()) return;
  throw Error("", "/mesh/file", "encloses nothing that an edge of the wrap can resolve");
}

/// A union may leave faces without area: these are turned. Returns true if shells were united.
bool RepairRun::unite() {
  const RepairStep united = unite_shells(draft_, limits_);
  note(united);
  if (united.count == 0 && !has_wrapped()) return false;
  note(turn_flat_faces(draft_));
  note(part_touching(draft_, changes_));
  if (!is_closed()) fill();
  return united.count > 0;
}

bool RepairRun::is_closed() const {
  const std::vector<char> open = faces_at_open_edges(draft_);
  return !draft_.faces.empty() && std::none_of(open.begin(), open.end(), [](char c) { return c != 0; });
}

bool RepairRun::is_as_loaded() const {
  return draft_.faces == loaded_.mesh->faces() && draft_.points == loaded_.mesh->vertices();
}

RepairedMesh RepairRun::finish() {
  RepairedMesh repaired;
  repaired.report.has_sheets = !sheets_.faces.empty();
  append(draft_, sheets_);
  drop_unused_points(draft_);
  repaired.report.steps = std::move(steps_);
  if (is_as_loaded()) {
    repaired.mesh = loaded_.mesh;
    repaired.crossings = loaded_.crossings;
    return repaired;
  }
  repaired.mesh = std::make_shared<const TriMesh>(std::move(draft_.points), draft_.faces);
  repaired.changes = std::move(changes_);
  list_changes(repaired);
  repaired.loaded_face_of = std::move(draft_.loaded);
  if (has_wrapped()) {
    begin("Measuring the wrap", 0.9);
    find_nearest_faces(source_index(loaded_), repaired);
    measure_distances(source_index(loaded_), wrap_edge_, repaired);
    repaired.report.wrap_edge = wrap_edge_;
    repaired.report.is_coarser = wrap_edge_ > limits_.edge;
  }
  return repaired;
}

/// A loaded face without remaining area is removed. If a part remains, the rest is inside a union. Of a wrap only the
/// difference of areas is known.
void RepairRun::list_changes(RepairedMesh& repaired) const {
  const TriMesh& mesh = *repaired.mesh;
  RepairReport& report = repaired.report;
  if (has_wrapped()) {
    report.area_added = std::max(0.0, mesh.area() - loaded_.mesh->area());
    report.area_removed = std::max(0.0, loaded_.mesh->area() - mesh.area());
    return;
  }
  std::vector<double> left(loaded_.mesh->faces().size(), 0);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const int from = draft_.loaded[at(f)];
    if (from >= 0) {
      left[at(from)] += mesh.face_areas()[at(f)];
      continue;
    }
    repaired.changes.filled_faces.push_back(f);
    report.area_added += mesh.face_areas()[at(f)];
  }
  for (int f = 0; f < loaded_.mesh->face_count(); ++f) {
    if (left[at(f)] == 0) repaired.changes.removed_faces.push_back(f);
    report.area_removed += std::max(0.0, loaded_.mesh->face_areas()[at(f)] - left[at(f)]);
  }
}

}  // namespace taxel
