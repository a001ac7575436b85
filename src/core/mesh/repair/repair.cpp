#include "core/mesh/repair/repair.h"

#include <fmt/format.h>

#include "core/base/stopwatch.h"
#include "core/mesh/repair/repair_message.h"
#include "core/mesh/repair/repair_run.h"
#include "core/mesh/topology/mesh_check.h"

namespace taxel {
namespace {

double positive(const std::optional<double>& value, double default_value, const char* key) {
  if (!value) return default_value;
  if (!(*value > 0) || !std::isfinite(*value))
    throw Error("", fmt::format("/mesh/repair/{}", key), fmt::format("must be greater than 0, is {}", *value));
  return *value;
}

double not_negative(const std::optional<double>& value, double default_value, const char* key) {
  if (value && *value == 0) return 0;
  return positive(value, default_value, key);
}

RepairLimits make_limits(const TriMesh& loaded, const RepairRecipe& recipe, double thickness) {
  constexpr double kJoin = 3e-4, kFill = 0.1, kEdge = 1.0 / 128, kTolerance = 1.0 / 6, kSheet = 0.05;
  RepairLimits limits;
  const double d = limits.diagonal = loaded.bounds().diagonal();
  limits.join = not_negative(recipe.join, kJoin * d, "join");
  limits.fill = not_negative(recipe.fill, kFill * d, "fill");
  limits.edge = positive(recipe.edge, kEdge * d, "edge");
  limits.tolerance = positive(recipe.tolerance, kTolerance * limits.edge, "tolerance");
  positive(recipe.refine, kDefaultRefine, "refine");
  limits.thickness = thickness > 0 ? thickness : kSheet * d;
  limits.loaded_area = loaded.area();
  return limits;
}

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
    if (step.code == "repair_wrapped" || step.code == "repair_sheet") report.level = RepairLevel::wrap;
    if (step.code == "repair_joined") {
      report.vertices_moved = step.count;
      report.largest_move = step.length;
    }
    finish_step(step, report);
  }
}

}  // namespace

RepairedMeshPtr repair_mesh(const TriMeshPtr& loaded, const RepairRecipe& recipe, double thickness,
                            Progress* progress) {
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
    RepairRun repair(loaded, recipe, limits, progress);
    repair.run();
    *repaired = repair.finish();
  }
  finish_report(*loaded, *repaired, seconds);
  return repaired;
}

}  // namespace taxel
