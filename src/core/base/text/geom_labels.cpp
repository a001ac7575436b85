#include "core/base/text/geom_labels.h"

#include <fmt/format.h>

#include <functional>
#include <map>
#include <set>
#include <utility>

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
