#include "core/document/apply_edit.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/document/mirror_link.h"
#include "core/document/scenario/scenario_json.h"
#include "core/document/taxel_edits.h"
#include "core/layout/check/layout_check.h"

namespace taxel {

namespace {

/// Returns the errors of layout_check in the settings below `pointer`.
Problems errors_of_settings(const Layout& layout, const std::string& pointer) {
  Layout settings = layout;
  settings.taxels.clear();
  Problems problems = check_layout_values(settings, "");
  std::erase_if(problems, [&](const Problem& problem) {
    return problem.severity != Severity::error || !problem.pointer.starts_with(pointer);
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
  const auto there = taxel_indices(project.layout);
  drop_links(project.mirrors, [&](int id) { return !there.contains(id); });
  std::erase_if(project.hidden, [&](int id) { return !there.contains(id); });
  check_project(project);
}

void replace_project(Project& project, const ReplaceProject& edit) {
  check_project(edit.project);
  const std::optional<View> view = project.view;
  project = edit.project;
  project.view = view;
}

void set_hidden(Project& project, const SetHidden& edit) {
  const auto there = taxel_indices(project.layout);
  for (const int id : edit.ids)
    if (!there.contains(id)) throw Error("", fmt::format("taxel {}", id), "is not in the layout");
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
      const bool there = std::any_of(before.begin(), before.end(), [&](const Problem& old) {
        return old.pointer == problem.pointer && old.message == problem.message;  // the message contains the value
      });
      if (!there) throw Error("", problem.pointer, problem.message);
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
