#include "core/sim/scene/scene_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/base/error.h"
#include "core/sim/model/geometry.h"

namespace taxel {
namespace {

std::string name_of(mjsElement* element) {
  return mjs_getString(mjs_getName(element));
}

/// The bodies of a scene by their elements: names, and the classes that their geoms have without a class of their own.
class BodiesOfSpec {
 public:
  explicit BodiesOfSpec(mjSpec* spec) { add(mjs_findBody(spec, "world"), ""); }
  [[nodiscard]] const std::string& name(mjsBody* body) const { return bodies_.at(body->element).name; }
  [[nodiscard]] const std::string& child_class(mjsBody* body) const { return bodies_.at(body->element).child_class; }
  [[nodiscard]] std::set<std::string> names() const {
    std::set<std::string> names;
    for (const auto& [element, body] : bodies_) names.insert(body.name);
    return names;
  }

 private:
  struct Body {
    std::string name, child_class;
  };
  void add(mjsBody* body, const std::string& inherited) {
    std::string name = name_of(body->element), own = mjs_getString(body->childclass);
    if (name.empty()) name = fmt::format("body {}", bodies_.size());
    const std::string& child_class =
        bodies_.emplace(body->element, Body{name, own.empty() ? inherited : own}).first->second.child_class;
    for (mjsElement* e = mjs_firstChild(body, mjOBJ_BODY, 0); e != nullptr; e = mjs_nextChild(body, e, 0))
      add(mjs_asBody(e), child_class);
  }
  std::map<mjsElement*, Body> bodies_;
};

/// Returns the class that a geom names itself, or an empty text for one that it has by its body.
std::string own_class(mjsElement* geom, const std::string& child_class) {
  const mjsDefault* defaults = mjs_getDefault(geom);
  const std::string name = defaults == nullptr ? "" : name_of(defaults->element);
  return name == "main" || name == child_class ? "" : name;
}

}  // namespace

std::vector<mjsElement*> geoms_of_spec(mjSpec* spec) {
  std::vector<mjsElement*> geoms;
  mjsBody* world = mjs_findBody(spec, "world");
  for (mjsElement* e = mjs_firstChild(world, mjOBJ_GEOM, 1); e != nullptr; e = mjs_nextChild(world, e, 1))
    geoms.push_back(e);
  return geoms;
}

SceneNames read_scene_names(mjSpec* spec) {
  SceneNames names;
  const BodiesOfSpec bodies(spec);
  for (mjsElement* e : geoms_of_spec(spec)) {
    mjsBody* const body = mjs_getParent(e);
    const mjsGeom& geom = *mjs_asGeom(e);
    names.geoms.push_back({name_of(e), bodies.name(body), own_class(e, bodies.child_class(body)),
                           mjs_getString(geom.meshname), geom_type_word(geom.type),
                           geom.contype != 0 || geom.conaffinity != 0});
  }
  names.labels = names.names = geom_labels(names.geoms);
  names.sensor_names = geom_sensor_names(names.geoms);
  names.bodies = bodies.names();
  return names;
}

int SceneNames::find(const std::string& text) const {
  const auto place = [&](const std::vector<std::string>& texts) {
    const auto found = std::ranges::find(texts, text);
    return found == texts.end() ? -1 : static_cast<int>(found - texts.begin());
  };
  if (const int label = place(labels); label >= 0) return label;
  if (const int name = place(sensor_names); name >= 0) return name;
  std::vector<GeomParts> without_class = geoms;
  for (GeomParts& geom : without_class) geom.class_name.clear();
  if (const int label = place(geom_labels(without_class)); label >= 0) return label;
  const int number = number_in_label(text);
  return number < static_cast<int>(geoms.size()) ? number : -1;
}

std::string SceneNames::name_for_sensor(const std::string& text) {
  const int geom = find(text);
  if (geom < 0) return text;
  const auto g = static_cast<std::size_t>(geom);
  return names[g] = sensor_names[g];
}

int SceneNames::mesh_geom_of_body(const std::string& body, const std::string& file) const {
  if (!bodies.contains(body)) throw Error(file, fmt::format("has no body \"{}\"", body));
  if (std::ranges::find(geoms, body, &GeomParts::body) == geoms.end())
    throw Error(file, fmt::format("body \"{}\" has no geoms, and taxels need one with a mesh", body));
  if (const auto geom = mesh_geom(geoms, body)) return static_cast<int>(*geom);
  const std::vector<std::size_t> all = first_with_each_mesh(geoms, body, false);
  if (all.empty())
    throw Error(file, fmt::format("body \"{}\" has no geom with a mesh: choose one of its geoms with --geom", body));
  throw Error(file, fmt::format("body \"{}\" has the meshes of \"{}\" ({}) and \"{}\" ({}): choose one with --geom",
                                body, labels[all[0]], geoms[all[0]].mesh, labels[all[1]], geoms[all[1]].mesh));
}

void name_geoms(mjSpec* spec, const SceneNames& names) {
  const std::vector<mjsElement*> geoms = geoms_of_spec(spec);
  for (std::size_t g = 0; g < std::min(geoms.size(), names.names.size()); ++g)
    if (name_of(geoms[g]).empty()) mjs_setName(geoms[g], names.names[g].c_str());
}

void set_labels(mjSpec* spec, const SceneNames& names, bool are_given) {
  const std::vector<mjsElement*> geoms = geoms_of_spec(spec);
  for (std::size_t g = 0; g < std::min(geoms.size(), names.names.size()); ++g)
    if (names.is_label(g)) mjs_setName(geoms[g], are_given ? names.names[g].c_str() : "");
}

}  // namespace taxel
