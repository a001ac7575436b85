#include "app/studio/host/examples.h"

#include <array>
#include <span>
#include <string_view>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/layout/file/layout_json.h"
#include "core/layout/sensor_presets.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/mesh_io.h"

namespace taxel::studio {
namespace {

constexpr std::string_view kPresetPrefix = "built-in: preset ", kScenePrefix = "built-in: scene ";

/// A known sensor, with the title of its layout, which would take too long to build for a menu.
struct PresetTitle {
  const char *name, *title;
};
constexpr std::array kPresets = {PresetTitle{"biotac", "BioTac, 19 electrodes"},
                                 PresetTitle{"icub", "iCub fingertip, 12 taxels"},
                                 PresetTitle{"xela-4x4", "XELA uSPa 44, 4 x 4 taxels"},
                                 PresetTitle{"xela-4x6", "XELA uSPa 46, 4 x 6 taxels"},
                                 PresetTitle{"xela-curved", "XELA curved fingertip, 30 taxels"},
                                 PresetTitle{"myrmex", "Myrmex, 16 x 16 taxels"},
                                 PresetTitle{"barometers", "Strip of barometers, 4 taxels"},
                                 PresetTitle{"dense", "Dense grid, 26 x 27 taxels"}};

std::vector<Example> all_examples() {
  std::vector<Example> all = {
      {"Fingertip sweep", "", "A finger slides over an edge, as in the paper: contact, rays and readings",
       "assets/pictures/example_sweep.png"},
      {"The jumping taxel", std::string(kJumpingTaxel),
       "The paper's artifact: a reading jumps while the force is steady. It is found, explained and mended",
       "assets/pictures/example_jump.png"},
      {"Hand grasps a ball", std::string(kScenePrefix) + "hand_grasps_ball.xml",
       "A robot hand lifts a ball from its stand; sixty taxels on five fingertips feel it",
       "assets/pictures/example_hand.png"},
  };
  for (const PresetTitle& preset : kPresets)
    all.push_back({preset.title, std::string(kPresetPrefix) + preset.name,
                   std::string("A known sensor: ") + preset.title +
                       ". Messages name its source and the numbers that we estimated",
                   std::string_view(preset.name) == "biotac" ? "assets/pictures/example_biotac.png" : ""});
  return all;
}

LoadedDocument load_preset(std::string_view name, const SensorBuild& how) {
  SensorPreset preset = make_sensor_preset(name);
  LoadedMesh mesh = read_mesh(write_obj(*preset.mesh), preset.layout.mesh.file);
  LoadedDocument document = document_in_memory(std::move(preset.layout), std::move(mesh), how);
  document.remarks = {"Source: " + preset.source, "Our own estimate: " + preset.unverified};
  return document;
}

}  // namespace

const std::vector<Example>& examples() {
  static const std::vector<Example> all = all_examples();
  return all;
}

bool is_built_in(std::string_view name) {
  return name.empty() || name == kJumpingTaxel || name == kNewLayout || name.starts_with(kPresetPrefix);
}

LoadedDocument load_built_in(std::string_view name, const SensorBuild& how) {
  if (name.starts_with(kPresetPrefix)) return load_preset(name.substr(kPresetPrefix.size()), how);
  if (name == kNewLayout) return new_layout(how);
  if (!is_built_in(name)) throw Error(std::string(name), "is not built into this program");
  return built_in_fingertip(how, name == kJumpingTaxel);
}

bool is_scene_example(std::string_view name) {
  return name.starts_with(kScenePrefix);
}

std::filesystem::path scene_of_example(std::string_view name) {
  return std::filesystem::path("scenes") / name.substr(kScenePrefix.size());
}

std::string_view embedded_file(std::string_view name);

LoadedDocument new_layout(const SensorBuild& how) {
  const BuiltInMesh mesh = built_in_mesh();
  Layout layout = parse_layout(std::string(embedded_file("assets/layouts/fingertip.taxels.json")), "new layout");
  layout.name = "Untitled";
  layout.mesh.file = mesh.name;
  layout.readout.method = ReadingMethod::exact;
  layout.taxels.clear();
  layout.calibration.reset();
  LoadedDocument document = document_in_memory(std::move(layout), read_mesh(mesh.bytes, mesh.name), how);
  document.name = "Untitled";
  return document;
}

std::span<const std::string_view> embedded_names();

void write_examples(const std::filesystem::path& folder) {
  constexpr std::string_view kAssets = "assets/";
  for (const std::string_view name : embedded_names()) {
    const std::filesystem::path file = folder / name.substr(kAssets.size());
    const std::string kind = file.parent_path().filename().string();
    std::error_code ignored;
    const bool is_example = kind == "layouts" || kind == "meshes" || kind == "scenes";
    if (!is_example || std::filesystem::exists(file, ignored)) continue;
    make_folder(file.parent_path());
    write_file_atomically(file, embedded_file(name));
  }
}

}  // namespace taxel::studio
