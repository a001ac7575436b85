#include "app/studio/frame/scene_filter.h"

#include <algorithm>
#include <sstream>

#include "ui/widgets/format.h"

namespace taxel::ui {
namespace {

void add_joints_and_sites(const SimScene& scene, int body, std::vector<std::string>& names) {
  for (const SceneJointPlace& joint : scene.marks.joints)
    if (joint.body == body) names.push_back(joint.name);
  for (const SceneSite& site : scene.marks.sites)
    if (site.body == body) names.push_back(site.name);
}

void add_geom(const SceneGeom& geom, std::vector<std::string>& names) {
  for (const std::string* name : {&geom.label, &geom.name, &geom.class_name, &geom.mesh_name})
    if (!name->empty()) names.push_back(*name);
}

/// Returns the name of a joint and the names of its body.
std::vector<std::string> names_of_joint(const SimScene& scene, const std::string& name) {
  const auto joint = std::ranges::find(scene.marks.joints, name, &SceneJointPlace::name);
  if (joint == scene.marks.joints.end()) return {name};
  return names_of_body(scene, joint->body);
}

}  // namespace

bool finds(const std::string& filter, const std::vector<std::string>& names) {
  std::istringstream words(filter);
  for (std::string word; words >> word;)
    if (std::ranges::none_of(names, [&](const std::string& name) { return contains_word(name, word); })) return false;
  return true;
}

std::vector<std::string> names_of_body(const SimScene& scene, int body) {
  std::vector<std::string> names;
  const auto b = static_cast<std::size_t>(body);
  if (body >= 0 && b < scene.controls.bodies.size()) names.push_back(scene.controls.bodies[b].name);
  for (const SceneGeom& geom : scene.geoms)
    if (geom.body_index == body) add_geom(geom, names);
  add_joints_and_sites(scene, body, names);
  return names;
}

bool finds_geom(const std::string& filter, const SimScene& scene, const SceneGeom& geom) {
  if (filter.empty()) return true;
  std::vector<std::string> names{geom.body};
  add_geom(geom, names);
  add_joints_and_sites(scene, geom.body_index, names);
  return finds(filter, names);
}

bool finds_joint(const std::string& filter, const SimScene& scene, const std::string& name) {
  return filter.empty() || finds(filter, names_of_joint(scene, name));
}

bool finds_actuator(const std::string& filter, const SimScene& scene, const SceneActuator& actuator) {
  if (filter.empty()) return true;
  std::vector<std::string> names = names_of_joint(scene, actuator.joint);
  names.push_back(actuator.name);
  return finds(filter, names);
}

int body_of_sensor(const SimScene& scene, int sensor) {
  const auto geom = std::ranges::find(scene.geoms, sensor, &SceneGeom::sensor);
  return sensor < 0 || geom == scene.geoms.end() ? -1 : geom->body_index;
}

bool finds_sensor(const std::string& filter, const SimScene& scene, std::size_t sensor) {
  std::vector<std::string> names = names_of_body(scene, body_of_sensor(scene, static_cast<int>(sensor)));
  if (sensor < scene.sensor_geoms.size()) names.push_back(scene.sensor_geoms[sensor]);
  return finds(filter, names);
}

}  // namespace taxel::ui
