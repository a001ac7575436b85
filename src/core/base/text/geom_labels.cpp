#include "core/base/text/geom_labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "core/base/text/sensor_names.h"

namespace taxel {
namespace {

using Texts = std::vector<std::string>;

/// Adds the text that add(place) returns to each label that two or more geoms have.
void tell_apart(Texts& labels, const std::function<std::string(std::size_t)>& add) {
  std::map<std::string, std::size_t> counts;
  for (const std::string& label : labels) ++counts[label];
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (counts[labels[i]] > 1) labels[i] += add(i);
}

/// Returns the labels of geoms as if none of them had a name. They may still equal a name.
Texts labels_without_names(const std::vector<GeomParts>& geoms) {
  Texts labels;
  for (const GeomParts& geom : geoms) {
    const std::string& detail = !geom.class_name.empty() ? geom.class_name : !geom.mesh.empty() ? geom.mesh : geom.type;
    labels.push_back(detail.empty() ? geom.body : geom.body + ", " + detail);
  }
  tell_apart(labels, [&](std::size_t i) {
    const GeomParts& geom = geoms[i];
    if (geom.class_name.empty()) return std::string();
    const std::string& shape = !geom.mesh.empty() ? geom.mesh : geom.type;
    return shape.empty() ? "" : ", " + shape;
  });
  std::map<std::string, int> numbers;
  const Texts repeated = labels;
  tell_apart(labels, [&](std::size_t i) { return fmt::format(" {}", ++numbers[repeated[i]]); });
  return labels;
}

}  // namespace

std::vector<std::size_t> first_with_each_mesh(const std::vector<GeomParts>& geoms, const std::string& body,
                                              bool only_drawn) {
  std::vector<std::size_t> found;
  for (std::size_t g = 0; g < geoms.size(); ++g) {
    const GeomParts& geom = geoms[g];
    if (geom.body != body || geom.type != "mesh" || geom.mesh.empty() || (only_drawn && geom.collides)) continue;
    const auto is_same = [&](std::size_t other) { return geoms[other].mesh == geom.mesh; };
    if (std::ranges::none_of(found, is_same)) found.push_back(g);
  }
  return found;
}

std::optional<std::size_t> mesh_geom(const std::vector<GeomParts>& geoms, const std::string& body) {
  for (const bool only_drawn : {true, false})
    if (const std::vector<std::size_t> found = first_with_each_mesh(geoms, body, only_drawn); found.size() == 1)
      return found.front();
  return std::nullopt;
}

Texts geom_sensor_names(const std::vector<GeomParts>& geoms) {
  std::map<std::string, std::vector<std::size_t>> bodies;
  std::set<std::string> taken;
  for (std::size_t i = 0; i < geoms.size(); ++i) {
    bodies[geoms[i].body].push_back(i);
    taken.insert(geoms[i].name);
  }
  Texts names(geoms.size());
  for (const auto& [body, of_body] : bodies) {
    std::vector<GeomParts> own;
    for (const std::size_t geom : of_body) own.push_back(geoms[geom]);
    const std::optional<std::size_t> main = own.size() == 1 ? 0 : mesh_geom(own, body);
    const std::vector<std::size_t> meshes = first_with_each_mesh(own, body, false);
    for (std::size_t place = 0; place < own.size(); ++place) {
      const bool has_own_mesh = std::ranges::find(meshes, place) != meshes.end();
      std::string& name = names[of_body[place]];
      name = !own[place].name.empty() ? own[place].name
             : main == place          ? body
             : has_own_mesh           ? body + "_" + own[place].mesh
                                      : fmt::format("{}_{}", body, place + 1);
    }
  }
  for (std::size_t i = 0; i < geoms.size(); ++i) {
    if (!geoms[i].name.empty()) continue;
    names[i] = sensor_name(names[i], taken);
    taken.insert(names[i]);
  }
  return names;
}

Texts geom_labels(const std::vector<GeomParts>& geoms) {
  Texts labels = labels_without_names(geoms);
  std::set<std::string> taken;
  for (std::size_t i = 0; i < geoms.size(); ++i) {
    if (geoms[i].name.empty()) continue;
    labels[i] = geoms[i].name;
    taken.insert(geoms[i].name);
  }
  for (std::size_t i = 0; i < geoms.size(); ++i) {
    if (!geoms[i].name.empty()) continue;
    const std::string start = labels[i];
    for (int number = 2; !taken.insert(labels[i]).second; ++number) labels[i] = fmt::format("{} ({})", start, number);
  }
  return labels;
}

int number_in_label(const std::string& label) {
  constexpr std::string_view kWord = "geom ";
  constexpr std::size_t kMaxDigits = 8;
  const bool is_number = label.starts_with(kWord) && label.size() > kWord.size() &&
                         label.size() <= kWord.size() + kMaxDigits &&
                         label.find_first_not_of("0123456789", kWord.size()) == std::string::npos;
  return is_number ? std::stoi(label.substr(kWord.size())) : -1;
}

}  // namespace taxel
