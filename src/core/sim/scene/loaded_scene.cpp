#include "core/sim/scene/loaded_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <map>
#include <set>
#include <utility>

#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/sim/model/geometry.h"
#include "core/sim/plugin/plugin_config.h"
#include "core/sim/plugin/plugin_instances.h"
#include "core/sim/scene/added_sensors.h"
#include "core/sim/scene/current_mjcf.h"
#include "core/sim/scene/declared_layouts.h"
#include "core/sim/scene/mjcf_text.h"
#include "core/sim/scene/old_fields.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

/// Returns MuJoCo's message on one line. MuJoCo repeats a plugin's reason, and line breaks would spoil our own
/// messages.
std::string one_line(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    if (!line.empty() && std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
    at = end + 1;
  }
  std::string joined;
  for (const std::string& line : lines) joined += (joined.empty() ? "" : "; ") + line;
  return joined;
}

/// Returns the plugin's own reason, which names the instance and the key, without the text that MuJoCo puts before it.
/// MuJoCo also repeats the reason, cut to a limit.
std::string reason_of(const std::string& text) {
  for (const char* plugin : {kPluginName, kContactPluginName}) {
    const std::string begin = std::string(plugin) + " \"";
    const std::size_t own = text.find(begin);
    if (own == std::string::npos) continue;
    const std::size_t again = text.find("; " + begin, own);
    return text.substr(own, again == std::string::npos ? again : again - own);
  }
  return text;
}

void compile(CompiledScene& scene, const mjVFS* vfs, const std::string& name) {
  scene.model.reset(mj_compile(scene.spec.get(), vfs));
  if (scene.model == nullptr) throw Error(name, reason_of(one_line(mjs_getError(scene.spec.get()))));
  const double timestep = scene.model->opt.timestep;
  if (!std::isfinite(timestep) || timestep <= 0)
    throw Error(name, "option timestep", fmt::format("must be greater than 0, is {}", timestep));
}

CompiledScene parsed(const std::string& file, const mjVFS* vfs, const std::string& name) {
  CompiledScene scene;
  std::array<char, 2048> reason{};
  scene.spec.reset(mj_parseXML(file.c_str(), vfs, reason.data(), static_cast<int>(reason.size())));
  if (scene.spec == nullptr) {
    const std::string why = one_line(reason.data());
    const bool plugin = why.find("plugin") != std::string::npos && why.find("not found") != std::string::npos;
    throw Error(name, why + (plugin ? "; plugin libraries are loaded with --plugins FOLDER" : ""));
  }
  scene.spec->compiler.discardvisual = 0;  // a skin may be on a geom that is only drawn
  return scene;
}

std::string spec_body_name(mjSpec* spec, int body) {
  for (mjsElement* e = mjs_firstElement(spec, mjOBJ_BODY); e != nullptr; e = mjs_nextElement(spec, e)) {
    if (mjs_getId(e) != body) continue;
    if (*mjs_getString(mjs_getName(e)) == '\0') mjs_setName(e, fmt::format("taxel body {}", body).c_str());
    return mjs_getString(mjs_getName(e));
  }
  return "";
}

using IntPair = std::pair<int, int>;

IntPair ordered(int a, int b) {
  return a < b ? IntPair{a, b} : IntPair{b, a};
}

/// Excludes MuJoCo's own contact between two bodies if all colliding geoms of the two bodies are in `pairs`.
void exclude_contacts(CompiledScene& scene, const std::set<IntPair>& pairs) {
  const mjModel& m = *scene.model;
  std::set<IntPair> bodies;
  for (const auto& [a, b] : pairs)
    if (would_collide(m, a, b)) bodies.insert(ordered(m.geom_bodyid[a], m.geom_bodyid[b]));
  const auto geoms_of = [&](int body) {
    return std::pair{m.body_geomadr[body], m.body_geomadr[body] + m.body_geomnum[body]};
  };
  for (const auto& [body_a, body_b] : bodies) {
    bool all = true;
    const auto [first_a, end_a] = geoms_of(body_a);
    const auto [first_b, end_b] = geoms_of(body_b);
    for (int a = first_a; a < end_a; ++a)
      for (int b = first_b; b < end_b; ++b) all = all && (!would_collide(m, a, b) || pairs.contains(ordered(a, b)));
    if (!all) continue;
    mjsExclude* exclude = mjs_addExclude(scene.spec.get());
    mjs_setString(exclude->bodyname1, spec_body_name(scene.spec.get(), body_a).c_str());
    mjs_setString(exclude->bodyname2, spec_body_name(scene.spec.get(), body_b).c_str());
  }
}

/// Name of the `taxel.contact` that replaces the `cs::` fields of a scene of the predecessor.
constexpr const char* kOldContact = "contacts of the scene";

std::string instance_on(const std::string& geom) {
  return "taxels of " + geom;
}

/// Returns the name in the compiled scene of the geom that a text names. Throws Error if the text is the name of a
/// body.
std::string name_for_sensor(const std::string& text, const std::string& scene, SceneNames& names) {
  if (names.find(text) >= 0 || !names.bodies.contains(text)) return names.name_for_sensor(text);
  std::string geoms;
  for (std::size_t g = 0; g < names.geoms.size(); ++g)
    if (names.geoms[g].body == text) geoms += fmt::format("{}\"{}\"", geoms.empty() ? "" : ", ", names.labels[g]);
  throw Error(scene, fmt::format("no geom is named \"{}\", but a body: its geoms are {}", text,
                                 geoms.empty() ? "none" : geoms));
}

/// Compiles the layouts of this program's own format that have no model yet side by side, each once. Returns all models
/// by the names of their layouts. Throws the Error of the first attachment whose layout cannot be compiled.
std::map<std::string, SensorModelPtr> compile_own_layouts(const std::vector<SceneAttachment>& attachments) {
  std::map<std::string, SensorModelPtr> models;
  std::vector<std::string> names;
  for (const SceneAttachment& one : attachments)
    if (one.model != nullptr) models.emplace(one.layout, one.model);
  for (const SceneAttachment& one : attachments)
    if (!is_foreign_layout(one.layout) && models.emplace(one.layout, nullptr).second) names.push_back(one.layout);
  std::vector<SensorModelPtr> compiled(names.size());
  std::vector<std::exception_ptr> failures(names.size());
  parallel_chunks(static_cast<int>(names.size()), 1, [&](int i, int) {
    try {
      std::error_code ignored;
      compiled[at(i)] = load_sensor_model(fs::absolute(names[at(i)], ignored));
    } catch (...) {
      failures[at(i)] = std::current_exception();
    }
  });
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
  for (std::size_t i = 0; i < names.size(); ++i) models[names[i]] = compiled[i];
  return models;
}

/// Returns the sensors of the attachments, and gives names to their geoms. A layout that is attached to several geoms
/// is read and compiled once.
std::vector<AddedSensor> attached_sensors(const std::string& scene, const std::vector<SceneAttachment>& attachments,
                                          SceneNames& names) {
  std::vector<AddedSensor> added;
  const auto is_taken = [&](const std::string& geom) {
    return std::any_of(added.begin(), added.end(), [&](const AddedSensor& other) { return other.geom == geom; });
  };
  for (const SceneAttachment& one : attachments) {
    const bool foreign = one.model == nullptr && is_foreign_layout(one.layout);
    if (one.layout.empty() || (one.geom.empty() && !foreign))
      throw Error(scene, "a layout and the geom to attach it to go together");
    ImportedLayout imported = foreign ? read_attached_layout(one) : ImportedLayout();
    const std::string geom = name_for_sensor(one.geom.empty() ? imported.geom : one.geom, scene, names);
    const std::string keys =
        one.others.empty() ? "" : fmt::format(R"(<config key="others" value="{}"/>)", xml_escaped(one.others));
    if (is_taken(geom))
      throw Error(scene, fmt::format("two layouts are attached to geom \"{}\": a geom takes one", geom));
    if (foreign) {
      added.push_back({instance_on(geom), geom, keys, nullptr, &one, std::move(imported), one.keeps_sisters});
      continue;
    }
    added.push_back({instance_on(geom), geom, keys, nullptr, nullptr, {}, one.keeps_sisters});
  }
  const std::map<std::string, SensorModelPtr> models = compile_own_layouts(attachments);
  for (std::size_t i = 0; i < added.size(); ++i) {  // one of each attachment
    if (added[i].foreign != nullptr) continue;
    const SensorModelPtr& own = attachments[i].model;
    added[i].model = own != nullptr ? own : models.at(attachments[i].layout);
    if (added[i].model->taxel_count() == 0)
      throw Error(attachments[i].layout, "/taxels", "has none: there is nothing to read");
  }
  return added;
}

bool any_foreign(const std::vector<AddedSensor>& added) {
  return std::any_of(added.begin(), added.end(), [](const AddedSensor& one) { return one.foreign != nullptr; });
}

/// Compiles the layouts of other programs, whose mesh and material come from the compiled scene.
void compile_foreign(std::vector<AddedSensor>& added, CompiledScene& scene) {
  for (AddedSensor& one : added)
    if (one.foreign != nullptr)
      one.model = compile_attached_layout(*one.foreign, std::move(one.imported), one.geom, *scene.model, scene.notes);
}

/// Returns the scene with the sensors, and with a contact of these keys unless they are empty. Relative names in the
/// text are those of the scene's folder. Sensors have no instances if the scene has replicates (has_replicates()).
std::string overlay_xml(const fs::path& file, const std::vector<AddedSensor>& added, const std::string& contact,
                        bool without_instances) {
  std::string instances, sensors;
  for (const AddedSensor& one : added) {
    const std::string name = xml_escaped(one.instance);
    const std::string keys =
        fmt::format(R"({}<config key="geom" value="{}"/>{})", hosted_keys(*one.model), xml_escaped(one.geom), one.keys);
    if (without_instances) {
      sensors += fmt::format(R"(<plugin name="{}" plugin="{}" objtype="geom" objname="{}">{}</plugin>)", name,
                             kPluginName, xml_escaped(one.geom), keys);
      continue;
    }
    instances += fmt::format(R"(<instance name="{}">{}</instance>)", name, keys);
    sensors += fmt::format(R"(<plugin name="{0}" plugin="{1}" instance="{0}"/>)", name, kPluginName);
  }
  std::string plugins;
  if (!sensors.empty()) plugins += fmt::format(R"(<plugin plugin="{}">{}</plugin>)", kPluginName, instances);
  if (!contact.empty())
    plugins += fmt::format(R"(<plugin plugin="{}"><instance name="{}">{}</instance></plugin>)", kContactPluginName,
                           kOldContact, contact);
  return fmt::format(R"(<mujoco><include file="{}"/><extension>{}</extension><sensor>{}</sensor></mujoco>)",
                     xml_escaped(file.filename().string()), plugins, sensors);
}

/// Throws Error if a geom has two sensors: both would push it, and they would have the same name in recordings.
void check_one_sensor_per_geom(const mjModel& m, const std::vector<AddedSensor>& added, const std::string& name) {
  std::map<std::string, std::string> sensor_on;  // sensor on a geom, by the geom's name
  for (const int i : sensor_instances(m)) {
    const SensorConfig config = read_sensor_config(m, i);
    const auto [first, only] = sensor_on.emplace(config.geom_name, config.name);
    if (only) continue;
    const auto is_added = [&](const AddedSensor& one) { return one.instance == config.name; };
    if (std::any_of(added.begin(), added.end(), is_added))
      throw Error(name, fmt::format("geom \"{}\" has a sensor already, \"{}\": a geom takes one layout", first->first,
                                    first->second));
    throw Error(name, fmt::format("geom \"{}\" has two sensors, \"{}\" and \"{}\": a geom takes one layout",
                                  first->first, first->second, config.name));
  }
}

/// Adds the sensors that the `cs::` fields of a scene request, and adds the values of the fields to the sensors added
/// before. Returns the keys of a `taxel.contact` for all other soft geoms; empty if there are none.
std::string add_old_sensors(const mjModel& m, std::vector<AddedSensor>& added, CompiledScene& scene) {
  const OldFields fields = old_fields(m);
  scene.notes.insert(scene.notes.end(), fields.notes.begin(), fields.notes.end());
  std::vector<std::string> sensing;
  for (const int i : sensor_instances(m)) sensing.push_back(read_sensor_config(m, i).geom_name);
  for (AddedSensor& one : added) {
    one.keys = old_keys(m, fields, one.geom);
    sensing.push_back(one.geom);
  }
  for (const auto& [name, field] : fields.geoms) {
    if (!(field.modulus > 0) || std::find(sensing.begin(), sensing.end(), name) != sensing.end()) continue;
    SensorModelPtr model = old_sensor(m, mj_name2id(&m, mjOBJ_GEOM, name.c_str()), field);
    if (model == nullptr) continue;
    added.push_back({instance_on(name), name, old_keys(m, fields, name), std::move(model)});
    sensing.push_back(name);
  }
  if (!contact_instances(m).empty()) return "";  // a scene that this program wrote already declares the contacts
  std::string contact = old_contact_keys(m, fields, sensing);
  for (const auto& [name, field] : fields.geoms)
    if (contact.empty() && sensing.empty() && field.modulus > 0)
      scene.notes.push_back(fmt::format(
          "geom \"{0}\" is soft by its field \"cs::{0}\", but MuJoCo lets no geom with such a field collide with it",
          name));
  return contact;
}

/// Removes the sisters from MuJoCo's own collisions.
void remove_contacts(mjSpec* spec, const std::map<int, int>& sisters) {
  const std::vector<mjsElement*> geoms = geoms_of_spec(spec);
  for (const auto& [sister, geom] : sisters)
    if (mjsGeom* one = mjs_asGeom(geoms.at(static_cast<std::size_t>(sister)))) one->contype = one->conaffinity = 0;
}

/// Hands the added sensors over and excludes MuJoCo's own contact of the added pairs.
void finish_added(CompiledScene& scene, const std::vector<AddedSensor>& added) {
  const mjModel& m = *scene.model;
  std::set<IntPair> pairs;
  for (const int i : sensor_instances(m)) {
    const SensorConfig config = read_sensor_config(m, i);
    const auto one = std::find_if(added.begin(), added.end(),
                                  [&](const AddedSensor& sensor) { return sensor.instance == config.name; });
    if (one == added.end()) continue;
    scene.handed[config.name] = one->model;
    if (!config.apply) continue;
    for (const int other : config.others) pairs.insert(ordered(config.geom, other));
  }
  for (const int i : contact_instances(m)) {
    const ContactConfig config = read_contact_config(m, i);
    if (config.name == kOldContact && config.apply) pairs.insert(config.pairs.begin(), config.pairs.end());
  }
  exclude_contacts(scene, pairs);
}

/// A user's scene: the file that MuJoCo opens, and the texts that it reads instead of files on disk.
struct OpenedScene {
  fs::path file;
  std::vector<CurrentMjcf> texts;
  std::unique_ptr<Vfs> vfs = std::make_unique<Vfs>();

  void replace(std::map<fs::path, std::string> changed) {
    for (CurrentMjcf& one : texts)
      if (auto text = changed.extract(one.file)) one.text = std::move(text.mapped());
    for (auto& [path, text] : changed) texts.push_back({path, std::move(text)});
    vfs = std::make_unique<Vfs>();
    for (const CurrentMjcf& one : texts) vfs->add(one.file.string(), one.text);
  }
};

OpenedScene open_scene(const fs::path& file, std::vector<std::string>& notes) {
  OpenedScene opened{file, {}};
  if (is_urdf(file)) {
    opened.texts.push_back(mjcf_of_urdf(file));
    opened.file = opened.texts.front().file;
  } else {
    opened.texts = current_mjcf(file, notes);
  }
  opened.replace({});
  return opened;
}

/// Lets the declared sensors whose layouts were edited take other models: reads the scene again with other texts.
void replace_declared(CompiledScene& scene, const std::vector<SceneAttachment>& attachments, const SceneNames& names,
                      OpenedScene& opened, const std::string& name) {
  std::map<std::string, SensorModelPtr> models;
  for (const SceneAttachment& one : attachments) {
    if (!one.is_declared) continue;
    if (models.empty()) compile(scene, opened.vfs->get(), name);
    models[instance_name(*scene.model, declared_instance(*scene.model, one.geom, name))] = one.model;
  }
  if (models.empty()) return;
  opened.replace(texts_for_models(MjcfSource(opened.file, opened.texts), models, name));
  std::vector<std::string> notes = std::move(scene.notes);
  scene = parsed(opened.file.string(), opened.vfs->get(), name);
  scene.notes = std::move(notes);
  scene.edited = std::move(models);
  name_geoms(scene.spec.get(), names);
}

bool has_old_fields(mjSpec* spec) {
  for (mjsElement* e = mjs_firstElement(spec, mjOBJ_NUMERIC); e != nullptr; e = mjs_nextElement(spec, e))
    if (std::string(mjs_getString(mjs_getName(e))).starts_with("cs::")) return true;
  return false;
}

}  // namespace

CompiledScene compile_scene(const std::string& xml, const std::vector<SceneFile>& files, const std::string& name) {
  Vfs vfs;
  vfs.add("scene.xml", xml);
  for (const SceneFile& file : files) vfs.add(file.name, file.bytes);
  CompiledScene scene = parsed("scene.xml", vfs.get(), name);
  compile(scene, vfs.get(), name);
  return scene;
}

CompiledScene load_scene(const fs::path& scene_file, const std::vector<SceneAttachment>& attachments) {
  const std::string name = scene_file.string();
  std::error_code ignored;
  fs::path file = fs::absolute(scene_file, ignored).lexically_normal();
  if (!fs::exists(file, ignored)) throw Error(name, "no such file");
  if (!fs::is_regular_file(file, ignored)) throw Error(name, "is not a regular file");
  std::vector<std::string> notes;
  expect_regular_files(file);
  const bool has_copies = has_replicates(file);
  OpenedScene opened = open_scene(file, notes);
  file = opened.file;
  CompiledScene scene = parsed(file.string(), opened.vfs->get(), name);
  scene.notes = std::move(notes);
  SceneNames names = read_scene_names(scene.spec.get());
  std::vector<SceneAttachment> on_geoms = attachments;
  std::erase_if(on_geoms, [](const SceneAttachment& one) { return one.is_declared; });
  for (SceneAttachment& one : on_geoms)
    if (!one.body.empty()) one.geom = names.labels[static_cast<std::size_t>(names.mesh_geom_of_body(one.body, name))];
  std::vector<AddedSensor> added = attached_sensors(name, on_geoms, names);
  name_geoms(scene.spec.get(), names);
  const bool old = has_old_fields(scene.spec.get());
  replace_declared(scene, attachments, names, opened, name);
  Vfs& vfs = *opened.vfs;
  if (added.empty() || old || any_foreign(added)) compile(scene, vfs.get(), name);
  compile_foreign(added, scene);
  const std::string contact = old ? add_old_sensors(*scene.model, added, scene) : "";
  if (added.empty() && contact.empty()) {
    check_one_sensor_per_geom(*scene.model, added, name);
    scene.names = std::move(names);
    return scene;
  }
  const auto compile_overlay = [&](const std::string& word, const std::map<int, int>& sisters) {
    const fs::path overlay = file.parent_path() / (file.stem().string() + word + ".xml");
    vfs.add(overlay.string(), overlay_xml(file, added, contact, has_copies));
    notes = std::move(scene.notes);
    std::map<std::string, SensorModelPtr> edited = std::move(scene.edited);
    scene = parsed(overlay.string(), vfs.get(), name);
    scene.notes = std::move(notes);
    scene.edited = std::move(edited);
    name_geoms(scene.spec.get(), names);
    remove_contacts(scene.spec.get(), sisters);
    compile(scene, vfs.get(), name);
  };
  compile_overlay("+taxels", {});
  check_one_sensor_per_geom(*scene.model, added, name);
  if (const std::map<int, int> sisters = replaced_sisters(*scene.model, added, scene.notes); !sisters.empty()) {
    give_bits(*scene.model, sisters, added);
    compile_overlay("+skins", sisters);
  }
  finish_added(scene, added);
  compile(scene, vfs.get(), name);
  scene.names = std::move(names);
  return scene;
}

}  // namespace taxel
