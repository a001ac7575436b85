// The limits of a recipe, one run of all steps, and its report in words.

#include "core/mesh/repair/repair.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

#include "core/base/stopwatch.h"
#include "core/base/text/message.h"
#include "core/mesh/repair/draft.h"
#include "core/mesh/repair/repair_run.h"
#include "core/mesh/topology/mesh_check.h"

namespace taxel {
namespace {

/// A step in words: "{} {}" of its count and its noun, then its verb.
struct Words {
  std::string_view code, singular, plural, verb;
  bool changes_area;
};

constexpr std::array<Words, 14> kWords{{
    {"repair_repeated", "repeated face", "repeated faces", "removed", true},
    {"repair_folded", "folded face", "folded faces", "removed", true},
    {"repair_fin", "fin", "fins", "removed", true},
    {"repair_joined", "rim vertex", "rim vertices", "joined", false},
    {"repair_turned", "face without area", "faces without area", "turned", false},
    {"repair_split", "edge", "edges", "split at a T-junction", false},
    {"repair_oriented", "face", "faces", "turned outward", false},
    {"repair_parted", "place", "places", "parted where surfaces touch", false},
    {"repair_filled", "hole", "holes", "filled", true},
    {"repair_cut", "place", "places", "with crossing faces cut out and filled", true},
    {"repair_united", "overlapping shell", "overlapping shells", "united", true},
    {"repair_wrapped", "shell", "shells", "wrapped", false},
    {"repair_two_sided", "surface without an inside", "surfaces without an inside", "made two-sided", false},
    {"repair_sheet", "surface without an inside", "surfaces without an inside", "thickened", true},
}};

const Words& words_of(std::string_view code) {
  return *std::find_if(kWords.begin(), kWords.end(), [&](const Words& words) { return words.code == code; });
}

/// "2 fins".
std::string counted(const RepairStep& step) {
  const Words& words = words_of(step.code);
  return fmt::format("{} {}", step.count, step.count == 1 ? words.singular : words.plural);
}

std::string area_text(double area, const RepairReport& report) {
  const double percent = 100 * area / report.area_before;
  // Two digits, but never as a power of ten for a large part.
  const std::string part = percent < 99.5 ? fmt::format("{:.2g}", percent) : fmt::format("{:.0f}", percent);
  return fmt::format("{}, {} % of the area", in_mm2(area), part);
}

/// Returns a text such as "2 folded faces and 1 fin removed (2.63 mm\u00b2, 0.16 % of the area), 1 hole filled (...)".
/// The area in brackets belongs to the steps with the verb before it, so removed area is not added to area inside a
/// union.
std::string all_clauses(const RepairReport& report) {
  const std::vector<RepairStep>& steps = report.steps;
  std::string text;
  double area = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Words& words = words_of(steps[i].code);
    const bool verb_follows = i + 1 < steps.size() && words_of(steps[i + 1].code).verb == words.verb;
    const bool verb_before = i > 0 && words_of(steps[i - 1].code).verb == words.verb;
    if (i > 0) text += verb_before && !verb_follows ? " and " : ", ";
    text += counted(steps[i]);
    if (words.changes_area) area += steps[i].area;
    if (verb_follows) continue;
    text += fmt::format(" {}", words.verb);
    if (area > 0) text += fmt::format(" ({})", area_text(area, report));
    area = 0;
  }
  return text;
}

/// Lengths and areas of a step, in brackets.
std::string measures(const RepairStep& step, const RepairReport& report) {
  std::string text;
  if (step.code == "repair_joined") text = fmt::format("moved by at most {}", in_mm(step.length));
  if (step.code == "repair_filled") text = fmt::format("up to {} wide, ", in_mm(step.length));
  if (step.area > 0) text += area_text(step.area, report);
  if (step.code == "repair_wrapped")
    text = fmt::format("edge {}{}, distance up to {}, rms {}", in_mm(report.wrap_edge),
                       report.is_coarser ? ", larger than the default, which would take too long" : "",
                       in_mm(report.distance_max), in_mm(report.distance_rms));
  return text.empty() ? text : " (" + text + ")";
}

}  // namespace

void finish_step(RepairStep& step, const RepairReport& report) {
  constexpr double kMuch = 0.01;  // fraction of the area
  if (words_of(step.code).changes_area && step.area > kMuch * report.area_before) step.severity = Severity::warning;
  step.message = fmt::format("{} {}{}; first at {}", counted(step), words_of(step.code).verb, measures(step, report),
                             place_in_mm(step.place));
}

Problems repair_problems(const RepairReport& report, const std::string& file) {
  Problems problems;
  for (const RepairStep& step : report.steps)
    problems.push_back({file, "/mesh/file", step.severity, step.code, "repaired: " + step.message, ""});
  return problems;
}

std::string repair_summary(const RepairReport& report) {
  constexpr double kRounding = 1e-9;
  if (report.steps.empty()) return "";
  std::string text = "repaired: " + all_clauses(report);
  if (report.distance_max > 0) {
    text += fmt::format(", surface within {}", in_mm(report.distance_max));
  } else if (report.largest_move > kRounding * std::sqrt(report.area_before)) {
    text += fmt::format(", {} {} moved by at most {}", report.vertices_moved,
                        report.vertices_moved == 1 ? "vertex" : "vertices", in_mm(report.largest_move));
  } else {
    text += report.vertices_moved > 0 ? ", vertices moved within rounding" : ", no vertex moved";
  }
  return text;
}

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
