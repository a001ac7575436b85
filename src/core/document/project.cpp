#include "core/document/project.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

namespace taxel {
namespace {

void check_ids(const Layout& layout, std::set<int>& ids) {
  for (std::size_t i = 0; i < layout.taxels.size(); ++i) {
    const int id = layout.taxels[i].id;
    const std::string where = fmt::format("/layout/taxels/{}/id", i);
    if (id < 0) throw Error("", where, fmt::format("must be 0 or more, is {}", id));
    if (!ids.insert(id).second) throw Error("", where, fmt::format("{} is also the id of another taxel", id));
  }
}

void check_mirror(const Mirror& mirror, const std::string& where, const std::set<int>& ids) {
  if (!is_finite(mirror.plane.point)) throw Error("", where + "/plane/point", "must be finite");
  const double length = glm::length(mirror.plane.normal);
  if (!(length > 0.0) || !std::isfinite(length)) throw Error("", where + "/plane/normal", "must be a direction");
  std::set<int> linked;
  for (std::size_t i = 0; i < mirror.links.size(); ++i) {
    const MirrorLink& link = mirror.links[i];
    for (const int id : {link.taxel, link.image}) {
      const std::string place = fmt::format("{}/links/{}", where, i);
      if (!ids.contains(id)) throw Error("", place, fmt::format("there is no taxel {}", id));
      if (!linked.insert(id).second)
        throw Error("", place, fmt::format("taxel {} is linked twice across one plane", id));
    }
  }
}

void check_ascending(const std::vector<int>& values, const std::string& where) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i] < 0 || (i > 0 && values[i] <= values[i - 1]))
      throw Error("", fmt::format("{}/{}", where, i), "must ascend from 0 or more");
}

}  // namespace

const Taxel* find_taxel(const Layout& layout, int id) {
  const auto found =
      std::find_if(layout.taxels.begin(), layout.taxels.end(), [&](const Taxel& taxel) { return taxel.id == id; });
  return found == layout.taxels.end() ? nullptr : &*found;
}

std::size_t taxel_index(const Layout& layout, int id) {
  const Taxel* taxel = find_taxel(layout, id);
  if (taxel == nullptr) throw Error("", fmt::format("taxel {}", id), "is not in the layout");
  return static_cast<std::size_t>(taxel - layout.taxels.data());
}

std::unordered_map<int, std::size_t> taxel_indices(const Layout& layout) {
  std::unordered_map<int, std::size_t> indices;
  for (std::size_t i = 0; i < layout.taxels.size(); ++i) indices.emplace(layout.taxels[i].id, i);
  return indices;
}

std::vector<int> unused_ids(const Layout& layout, std::size_t count) {
  std::int64_t next = 0;
  for (const Taxel& taxel : layout.taxels) next = std::max<std::int64_t>(next, std::int64_t{taxel.id} + 1);
  if (next + static_cast<std::int64_t>(count) - 1 > std::numeric_limits<int>::max())
    throw Error("", "taxels", "no id is left after the largest");
  std::vector<int> ids(count);
  for (int& id : ids) id = static_cast<int>(next++);
  return ids;
}

std::vector<std::string> make_ids_unique(Layout& layout) {
  std::vector<std::string> notes;
  std::set<int> ids;
  for (Taxel& taxel : layout.taxels) {
    if (taxel.id >= 0 && ids.insert(taxel.id).second) continue;
    const int old = taxel.id;
    taxel.id = unused_ids(layout, 1).front();
    ids.insert(taxel.id);
    notes.push_back(fmt::format("/taxels/{}: the id {} {}, this taxel is {} now", &taxel - layout.taxels.data(), old,
                                old < 0 ? "is negative" : "is that of another taxel", taxel.id));
  }
  return notes;
}

std::vector<Taxel> with_unused_ids(std::vector<Taxel> taxels, const Layout& layout) {
  std::set<int> taken;
  for (const Taxel& taxel : layout.taxels) taken.insert(taxel.id);
  std::vector<Taxel*> without_id;
  for (Taxel& taxel : taxels)
    if (taxel.id < 0 || !taken.insert(taxel.id).second) without_id.push_back(&taxel);
  Layout all = layout;
  for (const Taxel& taxel : taxels) all.taxels.push_back(taxel);
  const std::vector<int> ids = unused_ids(all, without_id.size());
  for (std::size_t i = 0; i < without_id.size(); ++i) without_id[i]->id = ids[i];
  return taxels;
}

void check_project(const Project& project) {
  std::set<int> ids;
  check_ids(project.layout, ids);
  for (std::size_t i = 0; i < project.mirrors.size(); ++i)
    check_mirror(project.mirrors[i], fmt::format("/mirrors/{}", i), ids);
  check_ascending(project.hidden, "/hidden");
  for (std::size_t i = 0; i < project.hidden.size(); ++i)
    if (!ids.contains(project.hidden[i]))
      throw Error("", fmt::format("/hidden/{}", i), fmt::format("there is no taxel {}", project.hidden[i]));
}

}  // namespace taxel
