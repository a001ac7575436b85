#include "core/mesh/repair/repair.h"

#include <fmt/format.h>

#include "core/base/stopwatch.h"
#include "core/mesh/mesh_check.h"
#include "core/mesh/repair/shells.h"
#include "core/mesh/repair/step_message.h"
#include "core/mesh/repair/steps.h"

namespace taxel {
namespace {

double positive(const std::optional<double>& value, double default_value, const char* key) {
  if (!value) return default_value;
  if (!(*value > 0) || !std::isfinite(*value))
    throw Error("", fmt::format("/mesh/repair/{}", key), fmt::format("must be greater than 0, is {}", *value));
  return *value;
}

RepairLimits make_limits(const TriMesh& loaded, const RepairRecipe& recipe, double thickness) {
  constexpr double kJoin = 3e-4, kFill = 0.1, kEdge = 1.0 / 300, kMinEdge = 0.3e-3, kTolerance = 1.0 / 6;
  RepairLimits limits;
  const double d = limits.diagonal = loaded.bounds().diagonal();
  limits.join = positive(recipe.join, kJoin * d, "join");
  limits.fill = positive(recipe.fill, kFill * d, "fill");
  limits.edge = positive(recipe.edge, std::max(kMinEdge, kEdge * d), "edge");
  limits.tolerance = positive(recipe.tolerance, kTolerance * limits.edge, "tolerance");
  positive(recipe.refine, kDefaultRefine, "refine");
  limits.thickness = thickness;
  limits.loaded_area = loaded.area();
  return limits;
}

/// Runs the steps on a draft and lists those that did something.
class Repair {
 public:
  Repair(const TriMeshPtr& loaded, const RepairLimits& limits, const Progress* progress)
      : loaded_(loaded), limits_(limits), progress_(progress), draft_(make_draft(*loaded)) {}

  void run_exact_steps() {
    if (!loaded_->closed()) close_without_filling();
    note(part_touching(draft_, changes_));
    if (!is_closed()) fill();
    check_encloses();
    note(orient_shells(draft_));
    const RepairStep united = unite_shells(draft_, limits_);
    note(united);
    if (united.count > 0) {
      note(turn_flat_faces(draft_));
      note(part_touching(draft_, changes_));
      if (!is_closed()) fill();
    }
  }

  RepairedMesh finish() {
    drop_unused_points(draft_);
    RepairedMesh repaired;
    repaired.report.steps = std::move(steps_);
    const bool same = draft_.faces == loaded_->faces() && draft_.points == loaded_->vertices();
    repaired.mesh = same ? loaded_ : std::make_shared<const TriMesh>(std::move(draft_.points), draft_.faces);
    if (!same) {
      repaired.changes = std::move(changes_);
      list_changes(repaired);
      repaired.loaded_face_of = std::move(draft_.loaded);
    }
    return repaired;
  }

 private:
  void note(RepairStep step) {
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

  void close_without_filling() {
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
    note(wind_alike(draft_, unorientable_));
  }

  /// A filled hole may leave flat faces or faces that touch others: these are turned and parted in a further round.
  void fill() {
    constexpr int kMaxRounds = 4;
    for (int round = 0; round < kMaxRounds && !is_closed(); ++round) {
      note(fill_holes(draft_, limits_));
      note(turn_flat_faces(draft_));
      note(split_junctions(draft_, limits_));
      note(remove_folded(draft_));
      note(part_touching(draft_, changes_));
    }
    if (is_closed()) return;
    TriMesh open(draft_.points, draft_.faces);
    throw Error("", "/mesh/file", fmt::format("cannot be closed by exact steps: {}", openings(open)));
  }

  [[nodiscard]] bool is_closed() const {
    bool closed = !draft_.faces.empty();
    const std::vector<EdgeSide> sides = draft_.sides();
    for_each_edge(std::span(sides), [&](std::span<const EdgeSide> edge) {
      closed = closed && edge.size() == 2 && edge[0].forward != edge[1].forward;
    });
    return closed;
  }

  void check_encloses() const {
    double volume = 0;
    for (const std::vector<int>& shell : find_shells(draft_).faces) volume += std::abs(volume_of(draft_, shell));
    constexpr double kNothing = 1e-12;
    if (volume > kNothing * limits_.loaded_area * limits_.diagonal) return;
    throw Error("", "/mesh/file", "encloses nothing: its faces have no inside");
  }

  /// A loaded face of which nothing is left is removed; where less of it is left, the rest went inside a union.
  void list_changes(RepairedMesh& repaired) const {
    std::vector<double> left(loaded_->faces().size(), 0);
    const TriMesh& mesh = *repaired.mesh;
    for (int f = 0; f < mesh.face_count(); ++f) {
      const int from = draft_.loaded[at(f)];
      if (from >= 0) {
        left[at(from)] += mesh.face_areas()[at(f)];
        continue;
      }
      repaired.changes.filled_faces.push_back(f);
      repaired.report.area_added += mesh.face_areas()[at(f)];
    }
    for (int f = 0; f < loaded_->face_count(); ++f) {
      if (left[at(f)] == 0) repaired.changes.removed_faces.push_back(f);
      repaired.report.area_removed += std::max(0.0, loaded_->face_areas()[at(f)] - left[at(f)]);
    }
  }

  TriMeshPtr loaded_;
  const RepairLimits& limits_;
  const Progress* progress_;
  Draft draft_;
  RepairChanges changes_;
  std::vector<RepairStep> steps_;
  std::vector<char> unorientable_;
};

void finish_report(const TriMesh& loaded, RepairedMesh& repaired, double seconds) {
  RepairReport& report = repaired.report;
  report.closed = repaired.mesh->closed();
  report.faces_before = loaded.face_count();
  report.faces_after = repaired.mesh->face_count();
  report.shells_before = loaded.shell_count();
  report.shells_after = repaired.mesh->shell_count();
  report.area_before = loaded.area();
  report.seconds = seconds;
  for (RepairStep& step : report.steps) {
    if (report.level == RepairLevel::keep) report.level = RepairLevel::exact;
    if (step.code == "repair_joined") {
      report.vertices_moved = step.count;
      report.largest_move = step.length;
    }
    finish_step(step, report);
  }
}

}  // namespace

RepairedMeshPtr repair_mesh(const TriMeshPtr& loaded, const RepairRecipe& recipe, double thickness,
                            const Progress* progress) {
  if (progress != nullptr) progress->stop_if_cancelled();
  const RepairLimits limits = make_limits(*loaded, recipe, thickness);
  auto repaired = std::make_shared<RepairedMesh>();
  double seconds = 0;
  if (recipe.level == RepairLevel::keep) {
    if (!loaded->closed())
      throw Error("", "/mesh/file", fmt::format("must be a closed mesh to be soft: {}", openings(*loaded)));
    repaired->mesh = loaded;
  } else {
    const Stopwatch watch(seconds);
    Repair repair(loaded, limits, progress);
    repair.run_exact_steps();
    *repaired = repair.finish();
  }
  finish_report(*loaded, *repaired, seconds);
  return repaired;
}

}  // namespace taxel
