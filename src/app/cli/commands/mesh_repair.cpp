#include "app/cli/commands/mesh_repair.h"

#include <fmt/format.h>

#include "core/layout/words.h"
#include "core/mesh/repair/repair_message.h"

namespace taxel::cli {

void add_repair_options(OptionList& list, RepairOptions& options) {
  std::vector<std::string> names;
  for (const Word<RepairLevel>& word : words_of(RepairLevel{})) names.emplace_back(word.text);
  list.add("--repair", &options.level,
           "Repair the mesh into a solid: auto, exact (never wraps), wrap (always), keep (only check)",
           {.unit = "LEVEL", .check = one_of(names)});
  const auto add_length = [&](const char* name, std::optional<double>& value, const char* help, const char* text) {
    list.add(name, &value, help, {.text = text, .needs = {"--repair"}});
  };
  add_length("--edge", options.recipe.edge, "Edge length of a wrap in metres", "M=diagonal/128");
  add_length("--tolerance", options.recipe.tolerance, "Largest simplification error of a wrap in metres", "M=edge/6");
  add_length("--join", options.recipe.join, "Largest distance over which rims are joined in metres", "M=3e-4 diagonal");
  add_length("--fill", options.recipe.fill, "Widest hole that is filled without a warning in metres", "M=0.1 diagonal");
}

RepairedMeshPtr repair_if_requested(const LoadedMesh& loaded, const RepairOptions& options, const std::string& file) {
  if (options.level.empty()) return nullptr;
  RepairRecipe recipe = options.recipe;
  recipe.level = from_word<RepairLevel>(options.level).value_or(recipe.level);
  try {
    return repair_mesh(loaded.mesh, recipe, 0.0);
  } catch (const Error& error) {
    throw Error(file, error.where(), error.message());
  }
}

void visit_repair(ReportWriter& w, const RepairReport& report) {
  w("level", to_word(report.level));
  w("closed", report.closed);
  w("faces_before", report.faces_before);
  w("faces_after", report.faces_after);
  w("shells_before", report.shells_before);
  w("shells_after", report.shells_after);
  w("vertices_moved", report.vertices_moved);
  w("largest_move", report.largest_move);
  w("distance_max", report.distance_max);
  w("distance_rms", report.distance_rms);
  w("area_added", report.area_added);
  w("area_removed", report.area_removed);
  w("seconds", report.seconds);
  w.list("steps", report.steps, [](ReportWriter& step, const RepairStep& s) {
    step("code", s.code);
    step("count", s.count);
    step("faces", s.faces);
    step("area", s.area);
    step("length", s.length);
    step("place", s.place);
  });
}

std::string repair_text(const RepairedMesh& repaired) {
  const RepairReport& report = repaired.report;
  if (report.steps.empty()) return "repair: nothing to do\n";
  std::string text = repair_summary(report) + "\n";
  for (const RepairStep& step : report.steps)
    text += fmt::format("  {}: {}: {}\n", to_string(step.severity), step.code, step.message);
  const TriMesh& mesh = *repaired.mesh;
  text += fmt::format("repaired mesh: {} vertices, {} triangles, {}, {} shell{}, volume {} m^3\n", mesh.vertex_count(),
                      mesh.face_count(), mesh.closed() ? "closed" : "open", mesh.shell_count(),
                      mesh.shell_count() == 1 ? "" : "s", mesh.volume());
  return text;
}

}  // namespace taxel::cli
