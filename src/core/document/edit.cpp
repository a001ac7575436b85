#include "core/document/edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <numeric>
#include <optional>
#include <set>
#include <string_view>

#include "core/base/error.h"
#include "core/document/edit_impl.h"
#include "core/document/scenario/scenario.h"
#include "core/layout/check/layout_check.h"

namespace taxel {

Edit::Edit(const Edit&) = default;
Edit& Edit::operator=(const Edit&) = default;
Edit::Edit(Edit&&) noexcept = default;
Edit& Edit::operator=(Edit&&) noexcept = default;
Edit::~Edit() = default;

namespace {

// Each throws Error that names the taxel if its id, or a value, is not valid.

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

/// Moves rows and columns of the crosstalk matrix with their taxels. `from` has the earlier index of each taxel, or
/// nothing for a new taxel, which has no crosstalk.
void move_crosstalk(Layout& layout, const std::vector<std::optional<std::size_t>>& from) {
  if (!layout.calibration || layout.calibration->crosstalk_matrix.empty()) return;
  const CrosstalkMatrix before = std::move(layout.calibration->crosstalk_matrix);
  CrosstalkMatrix& matrix = layout.calibration->crosstalk_matrix;
  matrix.assign(from.size(), std::vector<double>(from.size()));
  for (std::size_t k = 0; k < from.size(); ++k)
    for (std::size_t j = 0; j < from.size(); ++j) {
      const bool is_known = from[k] && from[j] && *from[k] < before.size() && *from[j] < before[*from[k]].size();
      matrix[k][j] = is_known ? before[*from[k]][*from[j]] : k == j ? 1.0 : 0.0;
    }
}

void add_taxels(Project& project, const AddTaxels& edit) {
  std::vector<Taxel>& taxels = project.layout.taxels;
  require_usable(edit.taxels, [](std::size_t, const std::string&) { return true; });
  const auto indices = taxel_indices(project.layout);
  for (const Taxel& taxel : edit.taxels)
    if (indices.contains(taxel.id)) fail(taxel.id, "is already in the layout");
  const std::size_t at = edit.before ? taxel_index(project.layout, *edit.before) : taxels.size();
  const std::size_t count = edit.taxels.size();
  move_unknown_keys(project.layout, "/taxels/",
                    [&](std::size_t i) { return static_cast<std::int64_t>(i < at ? i : i + count); });
  std::vector<std::optional<std::size_t>> from(taxels.size());
  std::iota(from.begin(), from.end(), std::size_t{0});
  from.insert(from.begin() + static_cast<std::ptrdiff_t>(at), count, std::nullopt);
  move_crosstalk(project.layout, from);
  taxels.insert(taxels.begin() + static_cast<std::ptrdiff_t>(at), edit.taxels.begin(), edit.taxels.end());
}

void delete_taxels(Project& project, const DeleteTaxels& edit) {
  Layout& layout = project.layout;
  const auto indices = taxel_indices(layout);
  std::set<int> ids;
  for (const int id : edit.ids) {
    if (!indices.contains(id)) fail(id, "is not in the layout");
    ids.insert(id);
  }
  const auto is_deleted = [&](const auto& item) { return ids.contains(item.id); };
  std::vector<std::optional<std::size_t>> from;
  for (std::size_t i = 0; i < layout.taxels.size(); ++i)
    if (!is_deleted(layout.taxels[i])) from.emplace_back(i);
  move_crosstalk(layout, from);
  drop_items(layout, layout.taxels, "/taxels/", is_deleted);
  if (layout.calibration) drop_items(layout, layout.calibration->taxels, "/calibration/taxels/", is_deleted);
  drop_links(project.mirrors, [&](int id) { return ids.contains(id); });
  std::erase_if(project.hidden, [&](int id) { return ids.contains(id); });
}

void set_taxels(Project& project, const SetTaxels& edit) {
  const auto indices = taxel_indices(project.layout);
  std::set<int> seen;
  std::vector<ChangedFields> changed;
  std::vector<Taxel> touched;
  for (const TaxelChange& change : edit.changes) {
    must_be_new(seen, change.id);
    const auto found = indices.find(change.id);
    if (found == indices.end()) fail(change.id, "is not in the layout");
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
  const auto indices = taxel_indices(layout);
  std::vector<Taxel> ordered;
  std::vector<std::int64_t> to(layout.taxels.size(), -1);
  for (const int id : edit.ids) {
    const auto found = indices.find(id);
    if (found == indices.end()) fail(id, "is not in the layout");
    if (to[found->second] >= 0) fail(id, "is listed twice");
    to[found->second] = static_cast<std::int64_t>(ordered.size());
    ordered.push_back(layout.taxels[found->second]);
  }
  for (std::size_t i = 0; i < to.size(); ++i)
    if (to[i] < 0) fail(layout.taxels[i].id, "is missing in the new order");
  move_unknown_keys(layout, "/taxels/", [&](std::size_t i) { return i < to.size() ? to[i] : -1; });
  std::vector<std::optional<std::size_t>> from(to.size());
  for (std::size_t i = 0; i < to.size(); ++i) from[static_cast<std::size_t>(to[i])] = i;
  move_crosstalk(layout, from);
  layout.taxels = std::move(ordered);
}

/// Returns the errors of layout_check in the settings below `pointer`, except for a size that follows from the taxels.
Problems errors_of_settings(const Layout& layout, const std::string& pointer) {
  Layout settings = layout;
  settings.taxels.clear();
  Problems problems = check_layout_values(settings, "");
  std::erase_if(problems, [&](const Problem& problem) {
    return problem.severity != Severity::error || !problem.pointer.starts_with(pointer) ||
           problem.code == std::string_view("matrix_size");
  });
  return problems;
}

/// Returns the values in ascending order, each once.
std::vector<int> as_set(std::vector<int> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

std::vector<int> region_of(const std::vector<int>& faces) {
  std::vector<int> region = as_set(faces);
  if (!region.empty() && region.front() < 0)
    throw Error("", "region", fmt::format("faces are numbered from 0, is {}", region.front()));
  return region;
}

void replace_layout(Project& project, const ReplaceLayout& edit) {
  project.layout = edit.layout;
  const auto indices = taxel_indices(project.layout);
  drop_links(project.mirrors, [&](int id) { return !indices.contains(id); });
  std::erase_if(project.hidden, [&](int id) { return !indices.contains(id); });
  check_project(project);
}

void replace_project(Project& project, const ReplaceProject& edit) {
  check_project(edit.project);
  const std::optional<View> view = project.view;
  project = edit.project;
  project.view = view;
}

void set_hidden(Project& project, const SetHidden& edit) {
  const auto indices = taxel_indices(project.layout);
  for (const int id : edit.ids)
    if (!indices.contains(id)) throw Error("", fmt::format("taxel {}", id), "is not in the layout");
  project.hidden = as_set(edit.ids);
}

void set_scenario(Project& project, const SetScenario& edit) {
  try {
    check_scenario(edit.scenario);
  } catch (const Error& e) {
    throw Error("", "/scenario" + e.where(), e.message());
  }
  project.scenario = edit.scenario;
}

/// Applies an edit to a copy of the project: one overload per edit.
struct Apply {
  Project& project;
  Layout& layout = project.layout;

  void operator()(const AddTaxels& edit) const { add_taxels(project, edit); }
  void operator()(const DeleteTaxels& edit) const { delete_taxels(project, edit); }
  void operator()(const SetTaxels& edit) const { set_taxels(project, edit); }
  void operator()(const RenumberTaxels& edit) const { renumber_taxels(project, edit); }
  void operator()(const ReorderTaxels& edit) const { reorder_taxels(project, edit); }
  void operator()(const MirrorTaxels& edit) const { mirror_taxels(project, edit); }
  void operator()(const LinkTaxels& edit) const { link_taxels(project, edit); }
  void operator()(const UnlinkTaxels& edit) const { unlink_taxels(project, edit); }
  void operator()(const SetHidden& edit) const { set_hidden(project, edit); }
  void operator()(const SetRegion& edit) const { layout.sampling.region = region_of(edit.faces); }
  void operator()(const SetName& edit) const { layout.name = edit.name; }
  void operator()(const SetFrame& edit) const { set(layout.frame, edit.frame, "/frame"); }
  void operator()(const SetSampling& edit) const { set(layout.sampling, edit.sampling, "/sampling"); }
  void operator()(const SetReceptiveField& edit) const { set(layout.receptive_field, edit.rule, "/receptive_field"); }
  void operator()(const SetReadout& edit) const { set(layout.readout, edit.readout, "/readout"); }
  void operator()(const SetMaterial& edit) const { set(layout.material, edit.material, "/material"); }
  void operator()(const SetRepair& edit) const { set(layout.mesh.repair, edit.repair, "/mesh/repair"); }
  void operator()(const SetCalibration& edit) const { set(layout.calibration, edit.calibration, "/calibration"); }
  void operator()(const SetScenario& edit) const { set_scenario(project, edit); }
  void operator()(const ReplaceMesh& edit) const {
    set(layout.mesh, edit.mesh, "/mesh");
    layout.sampling.region = region_of(edit.region);
  }
  void operator()(const ReplaceLayout& edit) const { replace_layout(project, edit); }
  void operator()(const ReplaceProject& edit) const { replace_project(project, edit); }
  void operator()(const ApplyAll& edit) const {
    for (const Edit& each : edit.edits->edits) std::visit(*this, each);
  }

 private:
  /// Throws Error for an error of the new value, unless the old value had the same error.
  template <class T>
  void set(T& setting, const T& value, const char* pointer) const {
    const Problems before = errors_of_settings(layout, pointer);
    setting = value;
    for (const Problem& problem : errors_of_settings(layout, pointer)) {
      const bool is_old = std::any_of(before.begin(), before.end(), [&](const Problem& old) {
        return old.pointer == problem.pointer && old.message == problem.message;  // the message contains the value
      });
      if (!is_old) throw Error("", problem.pointer, problem.message);
    }
  }
};

std::string taxels_text(const std::vector<int>& ids) {
  return ids.size() == 1 ? fmt::format("taxel {}", ids.front()) : fmt::format("{} taxels", ids.size());
}

/// Returns the verb for a change of taxels from the fields that it sets.
std::string verb_of(const SetTaxels& edit) {
  bool name = false, center = false, normal = false, radius = false, subtaxels = false, density = false;
  for (const TaxelChange& change : edit.changes) {
    name = name || change.name;
    center = center || change.center;
    normal = normal || change.normal;
    radius = radius || change.radius;
    subtaxels = subtaxels || change.subtaxels;
    density = density || change.density;
  }
  if (name + (center || normal) + radius + subtaxels + density > 1) return "Change";
  if (center) return "Move";
  if (normal) return "Turn";
  if (radius) return "Resize";
  if (density) return "Set density of";
  return name ? "Rename" : "Change subtaxels of";
}

struct Name {
  std::string operator()(const AddTaxels& edit) const { return "Add " + of(edit.taxels); }
  std::string operator()(const DeleteTaxels& edit) const { return "Delete " + taxels_text(edit.ids); }
  std::string operator()(const SetTaxels& edit) const { return verb_of(edit) + " " + of(edit.changes); }
  std::string operator()(const RenumberTaxels& edit) const {
    if (edit.ids.size() == 1) return fmt::format("Renumber taxel {}", edit.ids.front().first);
    return fmt::format("Renumber {} taxels", edit.ids.size());
  }
  std::string operator()(const ReorderTaxels&) const { return "Reorder taxels"; }
  std::string operator()(const MirrorTaxels& edit) const { return "Mirror " + taxels_text(edit.ids); }
  std::string operator()(const LinkTaxels& edit) const {
    if (edit.links.size() == 1)
      return fmt::format("Link taxels {} and {}", edit.links.front().taxel, edit.links.front().image);
    return fmt::format("Link {} pairs of taxels", edit.links.size());
  }
  std::string operator()(const UnlinkTaxels& edit) const { return "Unlink " + taxels_text(edit.ids); }
  std::string operator()(const SetHidden& edit) const {
    return edit.ids.empty() ? "Show all taxels" : "Hide " + taxels_text(as_set(edit.ids));
  }
  std::string operator()(const SetRegion& edit) const {
    return edit.faces.empty() ? "Clear the painted region" : "Paint the region";
  }
  std::string operator()(const SetName&) const { return "Rename the layout"; }
  std::string operator()(const SetFrame&) const { return "Change the frame"; }
  std::string operator()(const SetSampling&) const { return "Change the sampling"; }
  std::string operator()(const SetReceptiveField&) const { return "Change the receptive fields"; }
  std::string operator()(const SetReadout&) const { return "Change the readout"; }
  std::string operator()(const SetMaterial&) const { return "Change the material"; }
  std::string operator()(const SetRepair&) const { return "Change the repair of the mesh"; }
  std::string operator()(const SetCalibration& edit) const {
    return edit.calibration ? "Change the calibration" : "Remove the calibration";
  }
  std::string operator()(const SetScenario&) const { return "Change the scenario"; }
  std::string operator()(const ReplaceMesh&) const { return "Replace the mesh"; }
  std::string operator()(const ReplaceLayout&) const { return "Replace the layout"; }
  std::string operator()(const ReplaceProject&) const { return "Replace the project"; }
  std::string operator()(const ApplyAll& edit) const { return edit.name; }

 private:
  template <class Item>
  static std::string of(const std::vector<Item>& items) {
    std::vector<int> ids;
    for (const Item& item : items) ids.push_back(item.id);
    return taxels_text(ids);
  }
};

}  // namespace

Project apply_edit(const Project& project, const Edit& edit) {
  Project edited = project;
  std::visit(Apply{edited}, edit);
  return edited;
}

std::string edit_name(const Edit& edit) {
  return std::visit(Name{}, edit);
}

}  // namespace taxel
