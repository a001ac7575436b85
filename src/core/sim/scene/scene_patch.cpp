#include "core/sim/scene/scene_patch.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/sim/model/geometry.h"
#include "core/sim/plugin/plugin_config.h"
#include "core/sim/plugin/plugin_instances.h"
#include "core/sim/scene/added_sensors.h"
#include "core/sim/scene/declared_layouts.h"
#include "core/sim/scene/mjcf_source.h"
#include "core/sim/scene/mjcf_text.h"
#include "core/sim/scene/patched_files.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMark = "taxel mark ";  // begin of the name that marks an element in the text

/// The scene without attachments: its text, and which element of the text is which geom and body of the model.
struct MarkedScene {
  std::unique_ptr<MjcfSource> source;
  SpecHandle spec;
  ModelHandle model;
  std::map<int, int> geom_elements, body_elements;  ///< element by id in the model
  bool is_urdf = false;
};

struct ParsedModel {
  SpecHandle spec;
  ModelHandle model;
};

/// Returns MuJoCo's message without line breaks.
std::string without_breaks(std::string message) {
  std::ranges::replace(message, '\n', ' ');
  return message;
}

/// Compiles texts as files of a folder, with all geoms that are only drawn. Throws Error naming `title`.
ParsedModel compile_texts(const fs::path& main, const std::map<fs::path, std::string>& texts,
                          const std::string& title) {
  Vfs vfs;
  for (const auto& [path, text] : texts) vfs.add(path.string(), text);
  std::array<char, 2048> reason{};
  ParsedModel parsed;
  parsed.spec.reset(mj_parseXML(main.string().c_str(), vfs.get(), reason.data(), static_cast<int>(reason.size())));
  if (parsed.spec == nullptr) throw Error(title, without_breaks(reason.data()));
  parsed.spec->compiler.discardvisual = 0;
  parsed.model.reset(mj_compile(parsed.spec.get(), vfs.get()));
  if (parsed.model == nullptr) throw Error(title, without_breaks(mjs_getError(parsed.spec.get())));
  return parsed;
}

/// Returns the number behind kMark in a name, or -1. `<replicate>` puts a number behind the names of its copies, so its
/// elements have no number of their own.
int marked_element(const std::string& name) {
  const std::string start = kMark;
  const bool is_mark = name.starts_with(start) && name.size() > start.size() + 1 && name.ends_with(";");
  if (!is_mark || name.find_first_not_of("0123456789", start.size()) != name.size() - 1) return -1;
  return std::stoi(name.substr(start.size()));
}

bool is_in_replicate(const MjcfSource& source, int element) {
  for (int up = element; up >= 0; up = source.elements()[static_cast<std::size_t>(up)].parent)
    if (source.name(up) == "replicate") return true;
  return false;
}

/// Finds the elements of the objects of one type: by their names, of which the text has those without an own as marks.
std::map<int, int> elements_of(const MjcfSource& source, const mjModel& m, mjtObj type, std::string_view tag,
                               int count) {
  std::map<std::string, int> named;
  for (int e = 0; e < static_cast<int>(source.elements().size()); ++e) {
    if (source.name(e) != tag || !source.is_in_world(e) || is_in_replicate(source, e)) continue;
    if (const auto name = source.value(e, "name"); name && !name->empty()) named[*name] = e;
  }
  std::map<int, int> elements;
  for (int id = 0; id < count; ++id) {
    const char* const given = mj_id2name(&m, type, id);
    const std::string name = given == nullptr ? "" : given;
    const auto found = named.find(name);
    const int element = found != named.end() ? found->second : marked_element(name);
    if (element >= 0) elements[id] = element;
  }
  return elements;
}

MarkedScene read_marked(const fs::path& scene, const std::string& title) {
  MarkedScene marked;
  std::vector<std::string> ignored;
  std::vector<CurrentMjcf> replaced;
  fs::path file = scene;
  marked.is_urdf = is_urdf(scene);
  if (marked.is_urdf) {
    replaced.push_back(mjcf_of_urdf(scene));
    file = replaced.front().file;
  } else {
    replaced = current_mjcf(scene, ignored);
  }
  marked.source = std::make_unique<MjcfSource>(file, replaced);
  const MjcfSource& source = *marked.source;
  MjcfChanges marks(source);
  for (int e = 0; e < static_cast<int>(source.elements().size()); ++e) {
    const bool has_name = source.value(e, "name").value_or("") != "";
    if ((source.name(e) == "geom" || source.name(e) == "body") && source.is_in_world(e) && !has_name)
      marks.set(e, "name", fmt::format("{}{};", kMark, e));
  }
  std::map<fs::path, std::string> texts;
  for (std::size_t f = 0; f < source.files().size(); ++f)
    texts[source.files()[f].path] = marks.text(static_cast<int>(f));
  ParsedModel parsed = compile_texts(file, texts, title);
  marked.spec = std::move(parsed.spec);
  marked.model = std::move(parsed.model);
  const mjModel& m = *marked.model;
  marked.geom_elements = elements_of(source, m, mjOBJ_GEOM, "geom", static_cast<int>(m.ngeom));
  marked.body_elements = elements_of(source, m, mjOBJ_BODY, "body", static_cast<int>(m.nbody));
  return marked;
}

/// A sensor to be written.
struct Addition {
  const SceneAttachment* attachment = nullptr;
  int geom = -1;
  SensorModelPtr model;
  bool applies = true;                       ///< its forces move bodies
  ContactBits bits;                          ///< bits of the geoms that the skin replaces
  std::string name, geom_name, layout, key;  ///< names of instance, geom and layout file; its key
};

/// Returns the attachments that add a sensor to the scene.
std::vector<SceneAttachment> added_ones(std::vector<SceneAttachment> attachments) {
  std::erase_if(attachments, [](const SceneAttachment& one) { return one.is_declared; });
  return attachments;
}

using IntPair = std::pair<int, int>;

std::set<IntPair> excluded_bodies(const mjModel& m) {
  std::set<IntPair> pairs;
  for (int i = 0; i < m.nexclude; ++i) pairs.insert({m.exclude_signature[i] >> 16, m.exclude_signature[i] & 0xFFFF});
  return pairs;
}

/// The making of one patch.
class Patch {
 public:
  /// `zero` takes the contacts of the sensors' own geoms by their bits; otherwise bodies are excluded as in `attached`.
  Patch(const MarkedScene& marked, const CompiledScene& attached, const std::vector<SceneAttachment>& attachments,
        fs::path output, std::string title, bool zero)
      : marked_(marked),
        attached_(attached),
        attachments_(added_ones(attachments)),
        output_(std::move(output)),
        title_(std::move(title)),
        has_copies_(has_replicate()),
        zeroes_(zero),
        changes_(*marked.source) {}

  PatchedScene make() {
    if (marked_.is_urdf) name_meshes_of_urdf();
    find_additions();
    take_contacts();
    name_geoms();
    PatchedScene out;
    LayoutFiles layouts(output_);
    for (Addition& one : additions_) write_layout(one, layouts, out);
    const std::map<int, std::string> edited = write_edited_layouts(layouts);
    const std::vector<std::string> excludes = exclude_lines();
    verify(excludes);
    MjcfChanges changes = changes_;
    for (const auto& [element, value] : edited) changes.set(element, "value", value);
    changes.append(lines(excludes, false));
    for (auto& [name, text] : texts_next_to(*marked_.source, changes, output_)) {
      if (name == output_.filename().string()) {
        out.scene.xml = std::move(text);
        continue;
      }
      notes_.push_back(fmt::format("{} is a copy of an included file, with the changes", name));
      out.scene.files.push_back({name, std::move(text)});
    }
    for (const SceneFile& file : layouts.files()) out.scene.files.push_back(file);
    out.notes = std::move(notes_);
    return out;
  }

 private:
  [[nodiscard]] bool has_replicate() const {
    const MjcfSource& source = *marked_.source;
    for (int e = 0; e < static_cast<int>(source.elements().size()); ++e)
      if (source.name(e) == "replicate") return true;
    return false;
  }

  /// Makes the meshes of a converted URDF, which have absolute paths, relative.
  void name_meshes_of_urdf() {
    const MjcfSource& source = *marked_.source;
    for (int e = 0; e < static_cast<int>(source.elements().size()); ++e) {
      const fs::path file = source.name(e) == "mesh" ? source.value(e, "file").value_or("") : "";
      if (file.is_absolute())
        changes_.set(e, "file", path_from(folder() / mjs_getString(marked_.spec->compiler.meshdir), file));
    }
  }

  /// Folder of the output.
  [[nodiscard]] fs::path folder() const {
    return output_.parent_path().empty() ? fs::path(".") : output_.parent_path();
  }

  void find_additions() {
    const mjModel& m = *attached_.model;
    if (m.ngeom != marked_.model->ngeom || m.nbody != marked_.model->nbody)
      throw Error(title_, "has changed on disk since it was loaded: load it again");
    for (const int i : sensor_instances(m)) {
      const SensorConfig config = read_sensor_config(m, i);
      const auto model = attached_.handed.find(config.name);
      if (model == attached_.handed.end()) continue;
      if (additions_.size() == attachments_.size())
        throw Error(title_, "has fields \"cs::\", which other programs ignore: they are not part of a patch");
      additions_.push_back(
          {&attachments_[additions_.size()], config.geom, model->second, config.apply, {}, "", "", "", ""});
    }
    if (contact_instances(m).size() != contact_instances(*marked_.model).size())
      throw Error(title_, "has fields \"cs::\", which other programs ignore: they are not part of a patch");
    if (additions_.size() != attachments_.size()) throw Error(title_, "the sensors do not belong to the attachments");
  }

  [[nodiscard]] int element_of_geom(int geom, const std::string& purpose) const {
    const auto found = marked_.geom_elements.find(geom);
    if (found != marked_.geom_elements.end()) return found->second;
    throw Error(title_, fmt::format("geom \"{}\" of body \"{}\" has to {}, but it is made by <replicate>, <composite>, "
                                    "<flexcomp> or <attach>, so no text of this scene is its own",
                                    shown_geom(geom), body_name(*attached_.model, attached_.model->geom_bodyid[geom]),
                                    purpose));
  }

  [[nodiscard]] std::string shown_geom(int geom) const { return geom_name(*attached_.model, geom); }

  /// Takes MuJoCo's own contacts of the sisters, and of the sensors' geoms themselves.
  void take_contacts() {
    const mjModel &before = *marked_.model, &after = *attached_.model;
    for (int g = 0; g < before.ngeom; ++g) {
      const bool is_own = zeroes_ && touches_by_default(g);
      if (!can_collide(before, g) || (can_collide(after, g) && !is_own)) continue;
      const int element = element_of_geom(g, "lose its contacts to the skin");
      changes_.set(element, "contype", "0");
      changes_.set(element, "conaffinity", "0");
      Addition& skin = skin_over(g);
      skin.bits = skin.bits | ContactBits{before.geom_contype[g], before.geom_conaffinity[g]};
      zeroed_.insert(g);
    }
  }

  /// Returns true for the geom of a sensor that touches whatever its bits allow.
  [[nodiscard]] bool touches_by_default(int geom) const {
    return std::ranges::any_of(additions_, [&](const Addition& one) {
      return one.geom == geom && one.applies && one.attachment->others.empty();
    });
  }

  /// Returns the sensor whose skin replaces a geom.
  Addition& skin_over(int geom) {
    const mjModel& before = *marked_.model;
    Addition* found = nullptr;
    for (Addition& one : additions_) {
      if (one.geom == geom) return one;
      if (before.geom_bodyid[one.geom] != before.geom_bodyid[geom]) continue;
      const std::vector<Sister> within = sister_geoms(before, one.geom, *one.model);
      if (found == nullptr && std::ranges::find(within, geom, &Sister::geom) != within.end()) found = &one;
    }
    if (found == nullptr) throw Error(title_, fmt::format("no skin replaces geom \"{}\"", shown_geom(geom)));
    return *found;
  }

  /// Gives the sensors' geoms without a name those of the attached scene, and names the sensors after the geoms.
  void name_geoms() {
    for (Addition& one : additions_) {
      const std::string own = shown_geom(one.geom);
      const char* const given = mj_id2name(marked_.model.get(), mjOBJ_GEOM, one.geom);
      const bool is_named = given != nullptr && given == own;
      one.geom_name = is_named ? own : free_name(mjOBJ_GEOM, own);
      if (!is_named) {
        changes_.set(element_of_geom(one.geom, "get a name"), "name", one.geom_name);
        notes_.push_back(fmt::format("geom \"{}\" is named \"{}\"",
                                     attached_.names.labels.at(static_cast<std::size_t>(one.geom)), one.geom_name));
      }
      one.name = free_name(mjOBJ_PLUGIN, one.geom_name);
    }
  }

  std::string free_name(mjtObj type, const std::string& wanted) {
    std::string name = wanted;
    for (int i = 2; mj_name2id(marked_.model.get(), type, name.c_str()) >= 0 || !taken_.insert({type, name}).second;
         ++i)
      name = fmt::format("{}_{}", wanted, i);
    return name;
  }

  void write_layout(Addition& one, LayoutFiles& layouts, PatchedScene& out) {
    const mjModel& m = *attached_.model;
    one.layout = layouts.add(*one.attachment, *one.model, one.geom_name);
    one.key = key_of(one.geom, one.geom_name, one.layout, layouts);
    out.sensors.push_back({one.geom_name, body_name(m, m.geom_bodyid[one.geom]), one.name + " taxels", one.layout,
                           one.model->taxel_count()});
  }

  /// Returns the value of the key `layout` for the file that was added last.
  std::string key_of(int geom, const std::string& geom_name, const std::string& layout, const LayoutFiles& layouts) {
    const std::vector<fs::path> folders = layout_folders(*attached_.model, geom);
    const fs::path file = folder() / layout;
    if (folders.size() > 1) return path_from(folders.front(), file);  // the last one is the working directory
    // No mesh says where the scene's files are.
    const std::string mesh = path_from(folder(), layouts.mesh());
    assets_.push_back(fmt::format(R"(    <mesh name="skin of {}" file="{}" inertia="shell"/>)", xml_escaped(geom_name),
                                  xml_escaped(mesh)));
    return path_from(layouts.mesh().parent_path(), file);
  }

  /// Adds the edited layouts of declared sensors. Returns the new values of their keys `layout`, by element.
  std::map<int, std::string> write_edited_layouts(LayoutFiles& layouts) {
    std::map<int, std::string> values;
    const mjModel& m = *marked_.model;
    for (const int i : sensor_instances(m)) {
      const auto model = attached_.edited.find(instance_name(m, i));
      if (model == attached_.edited.end()) continue;
      const DeclaredLayout declared = declared_layout(m, i, *model->second);
      if (declared.is_unchanged) continue;
      const SensorConfig config = read_sensor_config(m, i);
      const int element = layout_element(*marked_.source, model->first, title_);
      const SceneAttachment edited{.geom = config.geom_name, .layout = declared.file.string(), .model = model->second};
      const std::string name = layouts.add(edited, *model->second, config.geom_name);
      values[element] = key_of(config.geom, config.geom_name, name, layouts);
      notes_.push_back(fmt::format("sensor \"{}\" reads the edited layout {}", model->first, name));
    }
    return values;
  }

  /// Returns the lines of `<exclude>`, and names their bodies.
  std::vector<std::string> exclude_lines() {
    const std::set<IntPair> before = excluded_bodies(*marked_.model);
    std::map<int, std::string> named;
    const auto name_of = [&](int body) {
      const std::string own = body_name(*marked_.model, body);
      if (!own.starts_with(kMark)) return own;
      if (!named[body].empty()) return named[body];
      if (!marked_.body_elements.contains(body))
        throw Error(title_, fmt::format("body {} has no name, and no text of this scene is its own", body));
      named[body] = free_name(mjOBJ_BODY, "body");
      changes_.set(marked_.body_elements.at(body), "name", named[body]);
      return named[body];
    };
    std::vector<std::string> lines;
    for (const auto& [a, b] : excluded_bodies(*attached_.model)) {
      if (before.contains({a, b}) || !still_collide(a, b)) continue;
      lines.push_back(
          fmt::format(R"(    <exclude body1="{}" body2="{}"/>)", xml_escaped(name_of(a)), xml_escaped(name_of(b))));
    }
    return lines;
  }

  /// Returns true if geoms of two bodies collide that keep their bits.
  [[nodiscard]] bool still_collide(int a, int b) const {
    const mjModel& m = *marked_.model;
    for (int i = 0; i < m.body_geomnum[a]; ++i)
      for (int j = 0; j < m.body_geomnum[b]; ++j) {
        const int g = m.body_geomadr[a] + i, h = m.body_geomadr[b] + j;
        if (!zeroed_.contains(g) && !zeroed_.contains(h) && would_collide(m, g, h)) return true;
      }
    return false;
  }

  [[nodiscard]] std::vector<std::string> keys_of(const Addition& one, bool hosted) const {
    std::vector<std::string> keys;
    const auto add = [&](const char* key, const std::string& value) {
      keys.push_back(fmt::format(R"(<config key="{}" value="{}"/>)", key, xml_escaped(value)));
    };
    if (hosted)
      keys.push_back(hosted_keys(*one.model));
    else
      add("layout", one.key);
    add("geom", one.geom_name);
    if (!one.attachment->others.empty()) add("others", one.attachment->others);
    if (one.bits.any()) {
      add("contype", std::to_string(one.bits.contype));
      add("conaffinity", std::to_string(one.bits.conaffinity));
    }
    return keys;
  }

  /// Returns the text at the end of the scene. `hosted`: the models are handed over instead of read from layouts.
  [[nodiscard]] std::vector<std::string> lines(const std::vector<std::string>& excludes, bool hosted) const {
    std::vector<std::string> all =
        compiler_lines(*marked_.source, output_, mjs_getString(marked_.spec->compiler.meshdir),
                       mjs_getString(marked_.spec->compiler.texturedir));
    if (additions_.empty()) return all;
    std::vector<std::string> sensors{"<sensor>"};
    all.insert(all.end(), {"<extension>", fmt::format("  <plugin plugin=\"{}\">", kPluginName)});
    if (has_copies_) all.back() = fmt::format("  <plugin plugin=\"{}\"/>", kPluginName);
    for (const Addition& one : additions_) {
      const std::string name = xml_escaped(one.name), geom = xml_escaped(one.geom_name);
      const std::string entry =
          fmt::format(R"(  <plugin name="{} taxels" plugin="{}"{} objtype="geom" objname="{}")", name, kPluginName,
                      has_copies_ ? "" : fmt::format(R"( instance="{}")", name), geom);
      sensors.push_back(entry + (has_copies_ ? ">" : "/>"));
      if (!has_copies_) all.push_back(fmt::format(R"(    <instance name="{}">)", name));
      for (const std::string& key : keys_of(one, hosted))
        has_copies_ ? sensors.push_back("    " + key) : all.push_back("      " + key);
      has_copies_ ? sensors.emplace_back("  </plugin>") : all.emplace_back("    </instance>");
    }
    if (!has_copies_) all.emplace_back("  </plugin>");
    all.emplace_back("</extension>");
    if (!hosted) add_section("asset", assets_, all);  // its mesh may be written only afterwards
    add_section("contact", excludes, all);
    all.insert(all.end(), sensors.begin(), sensors.end());
    all.emplace_back("</sensor>");
    return all;
  }

  static void add_section(const char* name, const std::vector<std::string>& content, std::vector<std::string>& all) {
    if (content.empty()) return;
    all.push_back(fmt::format("<{}>", name));
    for (const std::string& line : content) all.push_back(line.substr(2));
    all.push_back(fmt::format("</{}>", name));
  }

  void verify(const std::vector<std::string>& excludes) const;

  const MarkedScene& marked_;
  const CompiledScene& attached_;
  const std::vector<SceneAttachment> attachments_;  // without those of declared sensors
  fs::path output_;
  std::string title_;
  bool has_copies_ = false;  // the scene has <replicate>, with which MuJoCo takes no instances
  bool zeroes_ = true;
  MjcfChanges changes_;
  std::vector<Addition> additions_;
  std::vector<std::string> assets_, notes_;
  std::set<int> zeroed_;  // geoms whose contacts are taken
  std::set<std::pair<int, std::string>> taken_;
};

/// Returns the number and a hash (FNV-1a) of the pairs of geoms for which MuJoCo computes contacts of its own.
std::pair<std::uint64_t, std::uint64_t> own_contacts(const mjModel& m) {
  constexpr std::uint64_t kBasis = 14695981039346656037U, kPrime = 1099511628211U;
  const std::set<IntPair> excluded = excluded_bodies(m);
  std::uint64_t count = 0, hash = kBasis;
  for (int a = 0; a < m.ngeom; ++a) {
    if (!can_collide(m, a)) continue;
    for (int b = a + 1; b < m.ngeom; ++b) {
      const auto bodies = std::minmax(m.geom_bodyid[a], m.geom_bodyid[b]);
      if (would_collide(m, a, b) && !excluded.contains(bodies)) {
        ++count;
        for (const int geom : {a, b}) hash = (hash ^ static_cast<std::uint64_t>(geom)) * kPrime;
      }
    }
  }
  return {count, hash};
}

/// Returns the geoms that each sensor touches, by its geom.
std::map<int, std::vector<int>> touched_geoms(const mjModel& m) {
  std::map<int, std::vector<int>> touched;
  for (const int i : sensor_instances(m)) {
    const SensorConfig config = read_sensor_config(m, i);
    touched[config.geom] = config.others;
  }
  return touched;
}

/// Returns the first part in which two models differ, or an empty text.
std::string difference(const mjModel& a, const mjModel& b) {
  const auto sizes = [](const mjModel& m) {
    return std::tuple(m.nbody, m.ngeom, m.njnt, m.nq, m.nv, m.nu, m.neq, m.ntendon, m.nsensor, m.nkey, m.nsite, m.ncam);
  };
  if (sizes(a) != sizes(b)) return "numbers of bodies, geoms, joints, actuators or sensors";
  const auto same = [](const auto* x, const auto* y, auto count) { return std::equal(x, x + count, y); };
  if (!same(a.body_mass, b.body_mass, a.nbody) || !same(a.body_inertia, b.body_inertia, 3 * a.nbody)) return "masses";
  if (!same(a.body_pos, b.body_pos, 3 * a.nbody) || !same(a.body_quat, b.body_quat, 4 * a.nbody) ||
      !same(a.geom_pos, b.geom_pos, 3 * a.ngeom) || !same(a.geom_quat, b.geom_quat, 4 * a.ngeom) ||
      !same(a.geom_bodyid, b.geom_bodyid, a.ngeom))
    return "poses";
  if (!same(a.geom_type, b.geom_type, a.ngeom) || !same(a.geom_size, b.geom_size, 3 * a.ngeom)) return "shapes";
  if (!same(a.qpos0, b.qpos0, a.nq) || !same(a.key_qpos, b.key_qpos, a.nkey * a.nq)) return "keyframes";
  if (touched_geoms(a) != touched_geoms(b)) return "the geoms that the sensors touch";
  if (own_contacts(a) != own_contacts(b)) return "the contacts that MuJoCo computes itself";
  return "";
}

void Patch::verify(const std::vector<std::string>& excludes) const {
  MjcfChanges changes = changes_;
  changes.append(lines(excludes, true));
  std::map<fs::path, std::string> texts;
  std::error_code ignored;
  const fs::path output = fs::absolute(output_, ignored).lexically_normal();
  for (auto& [name, text] : texts_next_to(*marked_.source, changes, output))
    texts[output.parent_path() / name] = std::move(text);
  const ParsedModel patched = compile_texts(output, texts, title_);
  const std::string other = difference(*attached_.model, *patched.model);
  if (!other.empty())
    throw Error(title_,
                fmt::format("no text that is only added gives the scene that was loaded: {} differ; load it again if "
                            "its file has changed on disk since then",
                            other));
}

/// A folder that MuJoCo needs while it follows paths like "../meshes". It is removed again if nothing was written to
/// it.
class NewFolder {
 public:
  explicit NewFolder(fs::path folder) : folder_(std::move(folder)) {
    std::error_code ignored;
    is_new_ = !folder_.empty() && !fs::exists(folder_, ignored);
    if (is_new_) make_folder(folder_);
  }
  ~NewFolder() {
    std::error_code ignored;
    if (is_new_) fs::remove(folder_, ignored);
  }
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

 private:
  fs::path folder_;
  bool is_new_ = false;
};

}  // namespace

PatchedScene patched_scene(const fs::path& scene, const std::vector<SceneAttachment>& attachments,
                           const CompiledScene& attached, const fs::path& output) {
  std::error_code ignored;
  const std::string title = scene.string();
  const fs::path file = fs::absolute(scene, ignored).lexically_normal();
  const MarkedScene marked = read_marked(file, title);
  for (const MjcfFile& one : marked.source->files())
    if (fs::equivalent(one.path, output, ignored))
      throw Error(output.string(), "is a file of the scene itself: choose another name");
  const auto patch = [&](bool zero) { return Patch(marked, attached, attachments, output, title, zero).make(); };
  const NewFolder folder(output.parent_path());
  try {
    return patch(true);
  } catch (const Error&) {  // contacts of the sensors' own geoms may need excludes of bodies
  }
  return patch(false);
}

std::map<fs::path, std::string> with_layout_file(const fs::path& scene, const std::vector<std::string>& geoms,
                                                 const fs::path& file) {
  std::error_code ignored;
  const std::string title = scene.string();
  const fs::path main = fs::absolute(scene, ignored).lexically_normal();
  const MarkedScene marked = read_marked(main, title);
  if (marked.is_urdf) throw Error(title, "is a URDF, which declares no sensors");
  const mjModel& m = *marked.model;
  MjcfChanges changes(*marked.source);
  for (const std::string& geom : geoms) {
    const int instance = declared_instance(m, geom, title);
    const int element = layout_element(*marked.source, instance_name(m, instance), title);
    const std::vector<fs::path> folders = layout_folders(m, read_sensor_config(m, instance).geom);
    const bool has_folder = folders.size() > 1;  // the last one is the working directory
    changes.set(element, "value",
                has_folder ? path_from(folders.front(), file) : fs::absolute(file, ignored).generic_string());
  }
  std::map<fs::path, std::string> all, changed;
  for (int f = 0; f < static_cast<int>(marked.source->files().size()); ++f) {
    const fs::path& path = marked.source->files()[static_cast<std::size_t>(f)].path;
    all[path] = changes.text(f);
    if (changes.has_changes(f)) changed[path] = all[path];
  }
  compile_texts(main, all, title);
  return changed;
}

}  // namespace taxel
