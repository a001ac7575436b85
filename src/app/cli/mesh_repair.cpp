#include "app/cli/mesh_repair.h"

#include <fmt/format.h>

#include "core/layout/words.h"

namespace taxel::cli {
void add_repair_options(CLI::App& app, RepairOptions& options) {
  std::vector<std::string> names;
  for (const Word<RepairLevel>& word : words_of(RepairLevel{})) names.emplace_back(word.text);
  CLI::Option* repair =
      app.add_option("--repair", options.level,
                     "Repair the mesh into a solid: auto, exact (never wraps), wrap (always), keep (only check)")
          ->check(CLI::IsMember(names))
          ->type_name("LEVEL");
  const auto add_length = [&](const char* name, std::optional<double>& value, const char* text, const char* standard) {
    app.add_option(name, value, text)->needs(repair)->option_text(standard);
  };
  add_length("--edge", options.recipe.edge, "Edge length of a wrap in metres", "M=max(3e-4, diagonal/300)");
  add_length("--tolerance", options.recipe.tolerance, "Largest simplification error of a wrap in metres", "M=edge/6");
  add_length("--join", options.recipe.join, "Largest distance over which rims are joined in metres", "M=3e-4 diagonal");
  add_length("--fill", options.recipe.fill, "Widest hole that is filled without a warning in metres", "M=0.1 diagonal");
}

RepairedMeshPtr repair_as_asked(const LoadedMesh& loaded, const RepairOptions& options, const std::string& file) {
  if (options.level.empty()) return nullptr;
  RepairRecipe recipe = options.recipe;
  recipe.level = from_word<RepairLevel>(options.level).value_or(recipe.level);
  try {
    return repair_mesh(loaded.mesh, recipe, 0.0);
  } catch (const Error& error) {
    throw Error(file, error.where(), error.message());
  }
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
