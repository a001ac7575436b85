#include "core/document/taxel_edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <set>

#include "core/base/error.h"
#include "core/document/mirror_link.h"
#include "core/layout/check/layout_check.h"

namespace taxel {
namespace {

[[noreturn]] void fail(int id, const std::string& message) {
  throw Error("", fmt::format("taxel {}", id), message);
}

void must_be_new(std::set<int>& seen, int id) {
  if (!seen.insert(id).second) fail(id, "is listed twice");
}

/// Changes the indices of unknown keys below `start` ("/taxels/3/note") to new_index(old), because a layout stores them
/// by the index of their object. Removes the keys whose new index is negative.
void move_unknown_keys(Layout& layout, const std::string& start,
                       const std::function<std::int64_t(std::size_t)>& new_index) {
  std::map<std::string, std::string> moved;
  for (const auto& [pointer, text] : layout.unknown) {
    std::size_t index = 0;
    const char* const end = pointer.data() + pointer.size();
    const bool below = pointer.starts_with(start);
    const auto read = below ? std::from_chars(pointer.data() + start.size(), end, index) : std::from_chars_result{};
    if (!below || read.ec != std::errc()) {
      moved.emplace(pointer, text);
      continue;
    }
    if (const std::int64_t to = new_index(index); to >= 0)
      moved.emplace(fmt::format("{}{}{}", start, to, std::string(read.ptr, end)), text);
  }
  layout.unknown = std::move(moved);
}

/// Returns the new index of each old index, or -1 if the item is removed.
template <class Item, class Drop>
std::vector<std::int64_t> indices_without(const std::vector<Item>& items, const Drop& drop) {
  std::vector<std::int64_t> to;
  std::int64_t next = 0;
  for (const Item& item : items) to.push_back(drop(item) ? -1 : next++);
  return to;
}

template <class Item, class Drop>
void drop_items(Layout& layout, std::vector<Item>& items, const std::string& start, const Drop& drop) {
  const std::vector<std::int64_t> to = indices_without(items, drop);
  move_unknown_keys(layout, start, [&](std::size_t i) { return i < to.size() ? to[i] : -1; });
  std::erase_if(items, drop);
}

/// Returns the shortest rotation from one direction to another, or nothing if they are 90 degrees or more apart.
std::optional<dmat3> small_turn(const dvec3& from, const dvec3& to) {
  const dvec3 a = glm::normalize(from), b = glm::normalize(to);
  if (!(glm::dot(a, b) > 0.0)) return std::nullopt;
  const dquat q = glm::normalize(dquat(1.0 + glm::dot(a, b), glm::cross(a, b)));
  return glm::mat3_cast(q);
}

/// Moves and turns the subtaxels together with their taxel.
void carry_subtaxels(const Taxel& before, Taxel& taxel) {
  const bool turns = taxel.normal != before.normal;
  const std::optional<dmat3> R = turns ? small_turn(before.normal, taxel.normal) : std::nullopt;
  for (Subtaxel& subtaxel : taxel.subtaxels) {
    if (R) {
      subtaxel.center = taxel.center + *R * (subtaxel.center - before.center);
      subtaxel.normal = *R * subtaxel.normal;
    } else {
      subtaxel.center += taxel.center - before.center;
    }
  }
}

ChangedFields change_taxel(const TaxelChange& change, Taxel& taxel) {
  const Taxel before = taxel;
  if (change.name) taxel.name = *change.name;
  if (change.center) taxel.center = *change.center;
  if (change.normal) taxel.normal = *change.normal;
  if (change.radius) taxel.radius = *change.radius;
  if (change.density) taxel.density = *change.density;
  if (change.subtaxels)
    taxel.subtaxels = *change.subtaxels;
  else if (change.center)
    carry_subtaxels(before, taxel);
  return {.id = change.id,
          .center = change.center.has_value(),
          .normal = change.normal.has_value(),
          .radius = change.radius.has_value(),
          .subtaxels = change.subtaxels.has_value() || (change.center && !taxel.subtaxels.empty()),
          .density = change.density.has_value()};
}

/// Throws Error("", "taxel ID: FIELD", ...) for the first error of layout_check in these taxels for which
/// concerns(index, field) is true; the field is "center", "normal", "radius", "subtaxels", "density" or "id".
template <class Concerns>
void require_usable(const std::vector<Taxel>& taxels, const Concerns& concerns) {
  Layout layout;
  layout.taxels = taxels;
  const std::string start = "/taxels/";
  for (const Problem& problem : check_layout_values(layout, "")) {
    if (problem.severity != Severity::error || !problem.pointer.starts_with(start)) continue;
    const std::size_t index = std::stoul(problem.pointer.substr(start.size()));
    const std::string place = problem.pointer.substr(problem.pointer.find('/', start.size()) + 1);
    if (!concerns(index, place.substr(0, place.find('/')))) continue;
    std::string message = problem.message;
    const std::string named = fmt::format(" (taxel {})", taxels[index].id);
    if (message.ends_with(named)) message.resize(message.size() - named.size());
    throw Error("", fmt::format("taxel {}: {}", taxels[index].id, place), message);
  }
}

}  // namespace

void add_taxels(Project& project, const AddTaxels& edit) {
  std::vector<Taxel>& taxels = project.layout.taxels;
  require_usable(edit.taxels, [](std::size_t, const std::string&) { return true; });
  const auto there = taxel_indices(project.layout);
  for (const Taxel& taxel : edit.taxels)
    if (there.contains(taxel.id)) fail(taxel.id, "is already in the layout");
  const std::size_t at = edit.before ? taxel_index(project.layout, *edit.before) : taxels.size();
  const std::size_t count = edit.taxels.size();
  move_unknown_keys(project.layout, "/taxels/",
                    [&](std::size_t i) { return static_cast<std::int64_t>(i < at ? i : i + count); });
  taxels.insert(taxels.begin() + static_cast<std::ptrdiff_t>(at), edit.taxels.begin(), edit.taxels.end());
}

void delete_taxels(Project& project, const DeleteTaxels& edit) {
  Layout& layout = project.layout;
  const auto there = taxel_indices(layout);
  std::set<int> ids;
  for (const int id : edit.ids) {
    if (!there.contains(id)) fail(id, "is not in the layout");
    ids.insert(id);
  }
  const auto gone = [&](const auto& item) { return ids.contains(item.id); };
  drop_items(layout, layout.taxels, "/taxels/", gone);
  if (layout.calibration) drop_items(layout, layout.calibration->taxels, "/calibration/taxels/", gone);
  drop_links(project.mirrors, [&](int id) { return ids.contains(id); });
  std::erase_if(project.hidden, [&](int id) { return ids.contains(id); });
}

void set_taxels(Project& project, const SetTaxels& edit) {
  const auto there = taxel_indices(project.layout);
  std::set<int> seen;
  std::vector<ChangedFields> changed;
  std::vector<Taxel> touched;
  for (const TaxelChange& change : edit.changes) {
    must_be_new(seen, change.id);
    const auto found = there.find(change.id);
    if (found == there.end()) fail(change.id, "is not in the layout");
    Taxel taxel = project.layout.taxels[found->second];
    changed.push_back(change_taxel(change, taxel));
    touched.push_back(taxel);
    project.layout.taxels[found->second] = std::move(taxel);
  }
  require_usable(touched, [&](std::size_t i, const std::string& field) {
    const TaxelChange& change = edit.changes[i];
    return (change.center && field == "center") || (change.normal && field == "normal") ||
           (change.radius && field == "radius") || (change.subtaxels && field == "subtaxels") ||
           (change.density && field == "density");
  });
  if (edit.twins_follow) follow_links(project, changed);
}

void renumber_taxels(Project& project, const RenumberTaxels& edit) {
  std::unordered_map<int, int> to;
  Layout& layout = project.layout;
  for (const auto& [from, id] : edit.ids) {
    taxel_index(layout, from);
    if (id < 0) fail(from, fmt::format("cannot get the id {}: it must be 0 or more", id));
    if (!to.emplace(from, id).second) fail(from, "is listed twice");
  }
  const auto renumber = [&](int& id) {
    if (const auto found = to.find(id); found != to.end()) id = found->second;
  };
  for (Taxel& taxel : layout.taxels) renumber(taxel.id);
  std::set<int> ids;
  for (const Taxel& taxel : layout.taxels)
    if (!ids.insert(taxel.id).second) fail(taxel.id, "would be there twice");
  if (layout.calibration)
    for (TaxelCalibration& calibration : layout.calibration->taxels) renumber(calibration.id);
  for (Mirror& mirror : project.mirrors)
    for (MirrorLink& link : mirror.links) renumber(link.taxel), renumber(link.image);
  for (int& id : project.hidden) renumber(id);
  std::sort(project.hidden.begin(), project.hidden.end());
}

void reorder_taxels(Project& project, const ReorderTaxels& edit) {
  Layout& layout = project.layout;
  const auto there = taxel_indices(layout);
  std::vector<Taxel> ordered;
  std::vector<std::int64_t> to(layout.taxels.size(), -1);
  for (const int id : edit.ids) {
    const auto found = there.find(id);
    if (found == there.end()) fail(id, "is not in the layout");
    if (to[found->second] >= 0) fail(id, "is listed twice");
    to[found->second] = static_cast<std::int64_t>(ordered.size());
    ordered.push_back(layout.taxels[found->second]);
  }
  for (std::size_t i = 0; i < to.size(); ++i)
    if (to[i] < 0) fail(layout.taxels[i].id, "is missing in the new order");
  move_unknown_keys(layout, "/taxels/", [&](std::size_t i) { return i < to.size() ? to[i] : -1; });
  layout.taxels = std::move(ordered);
}

}  // namespace taxel
