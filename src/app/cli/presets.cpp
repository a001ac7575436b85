// taxel presets: layouts of known sensors, listed, or written with their mesh.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/presets_report.h"
#include "core/layout/file/layout_json.h"
#include "core/mesh/mesh_io.h"

namespace taxel::cli {

std::string presets_text(const std::vector<SensorPreset>& presets) {
  std::string text;
  for (const SensorPreset& preset : presets) {
    text += fmt::format("{:<12} {} taxels: {}\n  source: {}\n  unverified: {}\n", preset.name,
                        preset.layout.taxels.size(), preset.layout.name, preset.source, preset.unverified);
  }
  return text;
}

namespace {

struct Options {
  std::string name;
  std::string out;
};

/// The layout at `out`, its mesh beside it as NAME.obj.
void write(const SensorPreset& preset, const std::filesystem::path& out) {
  const std::filesystem::path mesh = mesh_path(preset.layout, out);
  if (mesh.lexically_normal() == out.lexically_normal())
    throw Error("presets", "--out", fmt::format("{} is the name of the mesh: end it with .taxels.json", out.string()));
  save_mesh(mesh, *preset.mesh);
  write_layout(out, preset.layout);
}

int run(const Options& options, Console& console) {
  if (options.name.empty() && !options.out.empty()) throw Error("presets", "--out", "needs the NAME of a preset");
  std::vector<SensorPreset> presets;
  for (const std::string& name : sensor_preset_names())
    if (options.name.empty()) presets.push_back(make_sensor_preset(name));
  if (!options.name.empty()) presets.push_back(make_sensor_preset(options.name));
  if (!options.out.empty()) write(presets.front(), options.out);
  console.result(console.json() ? presets_json(presets) : presets_text(presets));
  return kDone;
}

}  // namespace

Command add_presets(CLI::App& parent, CommonOptions& common) {
  const auto options = std::make_shared<Options>();
  CLI::App* app = add_command(parent, common, "presets", "Layouts of known sensors, and where their numbers come from",
                              "taxel presets biotac --out biotac.taxels.json");
  app->add_option("NAME", options->name, "One of them (default: all are listed)")->option_text("NAME");
  app->add_option("--out", options->out, "Write its layout to this file, and its mesh beside it as NAME.obj")
      ->type_name("FILE");
  return {app, [options](Console& console) { return run(*options, console); }};
}

}  // namespace taxel::cli
