// taxel attach: writes a scene with layouts attached to its geoms.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>

#include "app/cli/command_line.h"
#include "app/cli/report_writer.h"
#include "core/layout/formats/layout_format.h"
#include "core/sim/model/geometry.h"
#include "core/sim/plugin/plugin_folder.h"
#include "core/sim/plugin/plugin_instances.h"
#include "core/sim/plugin/plugin_table.h"
#include "core/sim/scene/added_sensors.h"
#include "core/sim/scene/scene_patch.h"

namespace taxel::cli {
namespace {

namespace fs = std::filesystem;

struct AttachOptions {
  std::string scene, out, plugins, sensor, others, sisters = "replace";
  std::vector<std::string> layouts, geoms, bodies, meshes;
};

struct AttachReport {
  std::string scene;  ///< written file
  std::vector<PatchedSensor> sensors;
  std::vector<std::string> files;  ///< other written files
  std::vector<std::string> notes;

  void visit(ReportWriter& w) const {
    w("scene", scene);
    w.list("sensors", sensors, [](ReportWriter& one, const PatchedSensor& sensor) {
      one("name", sensor.sensor);
      one("geom", sensor.geom);
      one("body", sensor.body);
      one("layout", sensor.layout);
      one("taxels", sensor.taxels);
    });
    w("files", files);
    w("notes", notes);
  }
  [[nodiscard]] std::string text() const;
};

std::string AttachReport::text() const {
  std::string text = fmt::format("{} has {} new sensor{}:\n", scene, sensors.size(), sensors.size() == 1 ? "" : "s");
  for (const PatchedSensor& one : sensors)
    text += fmt::format("  \"{}\": {} taxels of {} on geom \"{}\" of body \"{}\"\n", one.sensor, one.taxels, one.layout,
                        one.geom, one.body);
  for (const std::string& file : files) text += fmt::format("written next to it: {}\n", file);
  return text;
}

/// Returns the places to attach to: geoms, bodies, and all geoms of meshes.
std::vector<SceneAttachment> places_of(const AttachOptions& options) {
  std::vector<SceneAttachment> places;
  for (const std::string& geom : options.geoms) places.push_back({.geom = geom, .layout = ""});
  for (const std::string& body : options.bodies) places.push_back({.geom = "", .layout = "", .body = body});
  if (options.meshes.empty()) return places;
  const CompiledScene scene = taxel::load_scene(options.scene, {});
  for (const std::string& mesh : options.meshes)
    for (const int geom : geoms_of_mesh(*scene.model, mesh, options.scene))
      places.push_back({.geom = geom_name(*scene.model, geom), .layout = ""});
  return places;
}

/// Returns the pairs of layout and place. One layout goes to all places; several need as many places of one kind.
std::vector<SceneAttachment> attachments_to(const AttachOptions& options) {
  std::vector<SceneAttachment> attachments = places_of(options);
  const std::size_t count = options.layouts.size();
  const int kinds = int(!options.geoms.empty()) + int(!options.bodies.empty()) + int(!options.meshes.empty());
  const bool are_geoms_named = attachments.empty() && std::ranges::all_of(options.layouts, [](const std::string& file) {
                                 return is_foreign_layout(file);
                               });
  if (are_geoms_named) attachments.resize(count);
  if (attachments.empty()) throw Error("attach", "needs a place: --geom, --body or --mesh");
  if (count > 1 && (kinds > 1 || !options.meshes.empty() || count != attachments.size()))
    throw Error("attach", fmt::format("{} layouts need as many --geom or as many --body, in the same order; one layout "
                                      "goes to all places",
                                      count));
  for (std::size_t i = 0; i < attachments.size(); ++i) {
    SceneAttachment& one = attachments[i];
    one.layout = options.layouts[count == 1 ? 0 : i];
    if (!options.sensor.empty() && !is_foreign_layout(one.layout))
      throw Error(one.layout, "is one layout: --sensor is only for files with several");
    one.skin.sensor = options.sensor;
    one.others = options.others;
    one.keeps_sisters = options.sisters == "keep";
  }
  return attachments;
}

/// Throws Error for the first layout that does not belong on its geom.
void expect_layouts_on_geoms(const CompiledScene& scene, const std::vector<SceneAttachment>& attachments) {
  std::size_t next = 0;
  for (const int i : sensor_instances(*scene.model)) {
    const auto model = scene.handed.find(instance_name(*scene.model, i));
    if (model == scene.handed.end() || next == attachments.size()) continue;
    expect_layout_on_geom(*scene.model, GeomNames(*scene.model, i).sensor_geom(), *model->second,
                          attachments[next++].layout);
  }
}

int run_attach_command(const AttachOptions& options, Console& console) {
  if (!register_sensor_plugin()) throw Error("the taxel.sensor plugin module is loaded in this process already");
  if (!options.plugins.empty()) load_plugin_folder(options.plugins);
  const std::vector<SceneAttachment> attachments = attachments_to(options);
  const CompiledScene scene = taxel::load_scene(options.scene, attachments);
  expect_layouts_on_geoms(scene, attachments);
  for (const std::string& note : scene.notes) console.note(note);
  const PatchedScene patched = patched_scene(options.scene, attachments, scene, options.out);
  for (const std::string& note : patched.notes) console.note(note);
  write_scene(options.out, patched.scene);
  AttachReport report{options.out, patched.sensors, {}, scene.notes};
  report.notes.insert(report.notes.end(), patched.notes.begin(), patched.notes.end());
  for (const SceneFile& file : patched.scene.files) report.files.push_back(file.name);
  print_report(console, report, JsonStyle::short_arrays);
  return kDone;
}

}  // namespace

Run add_attach(OptionList& list) {
  const auto options = std::make_shared<AttachOptions>();
  list.add("SCENE", &options->scene, "MuJoCo scene (.xml), or a URDF, which becomes MJCF", required());
  list.add("--layout", &options->layouts,
           "Layout (*.taxels.json, .yaml, .csv). One goes to all places; several go in pairs with --geom or --body",
           {.unit = "FILE", .text = "FILE (required)", .is_required = true});
  list.add("--geom", &options->geoms,
           "Attach to the geom of this name, or with this label if it has none: \"rh_ffdistal, plastic_visual\"",
           {.unit = "NAME"});
  list.add("--body", &options->bodies,
           "Attach to the mesh of this body: of a body with several meshes to the only one that is only drawn",
           {.unit = "NAME"});
  list.add("--mesh", &options->meshes, "Attach to every geom with this mesh, such as all fingertips", {.unit = "NAME"});
  list.add("--out", &options->out,
           "Write the scene to this file: a patch of SCENE with additions for the sensors alone; layouts are copied "
           "next to it",
           {.unit = "FILE", .text = "FILE (required)", .is_required = true});
  list.add("--others", &options->others,
           "Geoms that the skins touch, separated by commas (default: all that MuJoCo lets collide with a geom of the "
           "skin's body)",
           {.unit = "NAMES"});
  list.add("--sisters", &options->sisters,
           "Collision geoms of the body that lie within an attached skin: \"replace\" their contacts by those of the "
           "skin, or \"keep\" them",
           {.unit = "WORD", .check = one_of({"replace", "keep"}), .default_text = "replace"});
  list.add("--sensor", &options->sensor, "Sensor of a layout file that has several", {.unit = "NAME"});
  list.add("--plugins", &options->plugins, "Load the plugin libraries of this folder first, as `taxel run` does",
           {.unit = "DIR"});
  return [options](Console& console) { return run_attach_command(*options, console); };
}

}  // namespace taxel::cli
