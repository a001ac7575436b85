#include "core/sim/scene/declared_layouts.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/layout/file/layout_json.h"
#include "core/sim/plugin/plugin_config.h"
#include "core/sim/plugin/plugin_instances.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

/// Returns true for the element that holds the keys of an instance of a sensor.
bool is_instance(const MjcfSource& source, int element, const std::string& name) {
  if (source.value(element, "name").value_or("") != name) return false;
  const int parent = source.elements()[static_cast<std::size_t>(element)].parent;
  if (source.name(element) == "instance") return parent >= 0 && source.value(parent, "plugin") == kPluginName;
  return source.name(element) == "plugin" && source.value(element, "plugin") == kPluginName;
}

/// Returns true if an instance has a key.
bool has_key(const MjcfSource& source, int instance, std::string_view key) {
  for (int e = 0; e < static_cast<int>(source.elements().size()); ++e)
    if (source.elements()[static_cast<std::size_t>(e)].parent == instance && source.value(e, "key") == key) return true;
  return false;
}

}  // namespace

int declared_instance(const mjModel& m, const std::string& geom, const std::string& scene) {
  for (const int i : sensor_instances(m))
    if (read_sensor_config(m, i).geom_name == geom) return i;
  throw Error(scene, fmt::format("declares no sensor on geom \"{}\", whose layout was edited: load it again", geom));
}

int layout_element(const MjcfSource& source, const std::string& instance, const std::string& scene) {
  for (int e = 0; e < static_cast<int>(source.elements().size()); ++e) {
    const int parent = source.elements()[static_cast<std::size_t>(e)].parent;
    const bool is_layout = source.name(e) == "config" && source.value(e, "key") == "layout";
    if (is_layout && parent >= 0 && is_instance(source, parent, instance)) return e;
  }
  throw Error(scene, fmt::format("sensor \"{}\" has no key \"layout\" in the text of this scene", instance));
}

std::map<fs::path, std::string> texts_for_models(const MjcfSource& source,
                                                 const std::map<std::string, SensorModelPtr>& models,
                                                 const std::string& scene) {
  MjcfChanges changes(source);
  for (const auto& [instance, model] : models) {
    const int element = layout_element(source, instance, scene);
    changes.set(element, "key", "taxels");
    changes.set(element, "value", std::to_string(model->taxel_count()));
    const Material& material = model->layout.material;
    const int parent = source.elements()[static_cast<std::size_t>(element)].parent;
    if (material.tangential_stiffness > 0 && !has_key(source, parent, "tangential_stiffness"))
      changes.insert_before(element, fmt::format(R"(<config key="tangential_stiffness" value="{}"/>)"
                                                 R"(<config key="bristles" value="{}"/>)",
                                                 material.tangential_stiffness, material.bristles));
  }
  std::map<fs::path, std::string> texts;
  for (int f = 0; f < static_cast<int>(source.files().size()); ++f)
    if (changes.has_changes(f)) texts[source.files()[static_cast<std::size_t>(f)].path] = changes.text(f);
  return texts;
}

DeclaredLayout declared_layout(const mjModel& m, int instance, const SensorModel& model) {
  const SensorConfig config = read_sensor_config(m, instance);
  const FoundLayout found = find_layout(config.layout, layout_folders(m, config.geom));
  DeclaredLayout declared;
  declared.is_text = config.layout.find_first_not_of(" \t\r\n") == config.layout.find('{');
  declared.file = found.file;
  if (declared.is_text) declared.file.replace_filename(config.geom_name + ".taxels.json");
  std::error_code ignored;
  const auto with_path = [&](Layout layout) {
    layout.mesh.file = fs::weakly_canonical(mesh_path(layout, found.file), ignored).string();
    return layout;
  };
  declared.is_unchanged = with_path(found.layout) == with_path(model.layout);
  return declared;
}

}  // namespace taxel
