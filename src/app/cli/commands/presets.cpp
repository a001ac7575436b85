// taxel presets: lists the layouts of known sensors or writes one with its mesh.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/cli/command_line.h"
#include "app/cli/report_writer.h"
#include "core/base/error.h"
#include "core/layout/file/layout_json.h"
#include "core/layout/sensor_presets.h"
#include "core/mesh/mesh_io.h"

namespace taxel::cli {
namespace {

struct PresetsOptions {
  std::string name;
  std::string out;
};

struct PresetsReport {
  std::vector<SensorPreset> presets;

  void visit(ReportWriter& w) const {
    w.list("presets", presets, [](ReportWriter& one, const SensorPreset& preset) {
      one("name", preset.name);
      one("title", preset.layout.name);
      one("taxels", preset.layout.taxels.size());
      one("source", preset.source);
      one("unverified", preset.unverified);
    });
  }
  [[nodiscard]] std::string text() const {
    std::string text;
    for (const SensorPreset& preset : presets)
      text += fmt::format("{:<12} {} taxels: {}\n  source: {}\n  unverified: {}\n", preset.name,
                          preset.layout.taxels.size(), preset.layout.name, preset.source, preset.unverified);
    return text;
  }
};

/// Writes the layout to `out` and its mesh next to it as NAME.obj. Throws Error if both files have the same name.
void write(const SensorPreset& preset, const std::filesystem::path& out) {
  const std::filesystem::path mesh = mesh_path(preset.layout, out);
  if (mesh.lexically_normal() == out.lexically_normal())
    throw Error("presets", "--out", fmt::format("{} is the name of the mesh: end it with .taxels.json", out.string()));
  save_mesh(mesh, *preset.mesh);
  write_layout(out, preset.layout);
}

int run_presets_command(const PresetsOptions& options, Console& console) {
  if (options.name.empty() && !options.out.empty()) throw Error("presets", "--out", "needs the NAME of a preset");
  PresetsReport report;
  for (const std::string& name : options.name.empty() ? sensor_preset_names() : std::vector{options.name})
    report.presets.push_back(make_sensor_preset(name));
  if (!options.out.empty()) write(report.presets.front(), options.out);
  print_report(console, report);
  return kDone;
}

}  // namespace

Run add_presets(OptionList& list) {
  const auto options = std::make_shared<PresetsOptions>();
  list.add("NAME", &options->name, "Name of a preset (default: list all)", {.text = "NAME"});
  list.add("--out", &options->out, "Write its layout to this file, and its mesh next to it as NAME.obj",
           {.unit = "FILE"});
  return [options](Console& console) { return run_presets_command(*options, console); };
}

}  // namespace taxel::cli
