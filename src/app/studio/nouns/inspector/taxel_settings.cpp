// The fields of the selected taxels and of their subtaxels in the inspector.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <limits>

#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/inspector/inspector_state.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/fields.h"

namespace taxel::ui {
namespace {

constexpr std::uint64_t kLargestId = std::numeric_limits<int>::max();
constexpr const char* kCenterTip =
    "Of the receptive field, in the frame of the mesh file. Shown in mm, stored in metres";
constexpr const char* kNormalTip = "Outward direction; its length does not count";
constexpr const char* kRadiusTip = "Of the receptive field: samples farther from the centre are not read";

constexpr const char* kDensityLabel = "Samples (1/mm\u00b2)";
constexpr const char* kDensityTip =
    "Samples per area in the field of the taxel, if more than in Layout > Sampling; 0 for as many as there";
constexpr FieldUnit kSamplesPerArea{"1/mm^2", 6, -1};

/// Applies `change(TaxelChange&, const Taxel&)` to each taxel, as one edit.
template <class Change>
void ask_for(WindowUi& ui, const std::vector<const Taxel*>& taxels, const Change& change) {
  SetTaxels set;
  for (const Taxel* taxel : taxels) {
    TaxelChange one;
    one.id = taxel->id;
    change(one, *taxel);
    set.changes.push_back(one);
  }
  post_edit(ui, set);
}

template <class Value>
auto values_of(const std::vector<const Taxel*>& taxels, const Value& value) {
  std::vector<std::decay_t<decltype(value(*taxels.front()))>> values;
  for (const Taxel* taxel : taxels) values.push_back(value(*taxel));
  return values;
}

void draw_id(WindowUi& ui, Selection& selection, const Project& project, const Taxel& taxel) {
  begin_property("Id", "Names the taxel in files and readings: a whole number that no other taxel has");
  const auto id = whole_field(ui, "Id", static_cast<std::uint64_t>(std::max(0, taxel.id)), kLargestId);
  if (id && find_taxel(project.layout, static_cast<int>(*id)) != nullptr) {
    refuse(ui, fmt::format("{} is that of another taxel", *id));
  } else if (id) {
    post_edit(ui, RenumberTaxels{{{taxel.id, static_cast<int>(*id)}}});
    // The selection follows the taxel, not its id.
    selection.remove(taxel.id);
    selection.add(static_cast<int>(*id));
  }
  show_refusal(ui, "Id");
}

/// Draws the fields of a vector; `member` is the centre or the normal.
void draw_vector(WindowUi& ui, const std::vector<const Taxel*>& taxels, const char* name, const char* tip,
                 dvec3 Taxel::*member, std::optional<dvec3> TaxelChange::*changed, const FieldUnit& unit) {
  begin_property(name, tip);
  const auto typed = vector_field(ui, name, values_of(taxels, [&](const Taxel& taxel) { return taxel.*member; }), unit);
  if (!typed) return;
  ask_for(ui, taxels, [&](TaxelChange& change, const Taxel& taxel) {
    dvec3 vector = taxel.*member;
    vector[typed->axis] = typed->value;
    change.*changed = vector;
  });
}

}  // namespace

void draw_taxel_fields(WindowUi& ui, Selection& selection, const Project& project) {
  std::vector<const Taxel*> taxels;
  for (const int id : selection.taxels) {
    if (const Taxel* taxel = find_taxel(project.layout, id)) taxels.push_back(taxel);
  }
  if (taxels.empty()) return;
  if (taxels.size() == 1) {
    draw_id(ui, selection, project, *taxels.front());
  } else {
    property("Taxels", std::to_string(taxels.size()));
  }
  begin_property("Name");
  const auto names = values_of(taxels, [](const Taxel& taxel) { return taxel.name; });
  if (const auto name = text_field(ui, "Name", names)) {
    ask_for(ui, taxels, [&](TaxelChange& change, const Taxel&) { change.name = *name; });
  }
  draw_vector(ui, taxels, "Centre (mm)", kCenterTip, &Taxel::center, &TaxelChange::center, kMillimetres);
  draw_vector(ui, taxels, "Normal", kNormalTip, &Taxel::normal, &TaxelChange::normal, kPlain);
  begin_property("Radius (mm)", kRadiusTip);
  const auto radii = values_of(taxels, [](const Taxel& taxel) { return taxel.radius; });
  if (const auto radius = number_field(ui, "Radius (mm)", radii, kMillimetres)) {
    ask_for(ui, taxels, [&](TaxelChange& change, const Taxel&) { change.radius = *radius; });
  }
  show_refusal(ui, "Radius (mm)");
  begin_property(kDensityLabel, kDensityTip);
  const auto densities = values_of(taxels, [](const Taxel& taxel) { return taxel.density; });
  if (const auto density = number_field(ui, kDensityLabel, densities, kSamplesPerArea)) {
    ask_for(ui, taxels, [&](TaxelChange& change, const Taxel&) { change.density = *density; });
  }
  show_refusal(ui, kDensityLabel);
  // A zero below the number of the taxel's samples would look like no samples.
  if (std::all_of(densities.begin(), densities.end(), [](double density) { return density == 0; }))
    property("", fmt::format("0: the layout's, {} /mm\u00b2",
                             shown_number(project.layout.sampling.density, kSamplesPerArea)));
}

namespace {

/// Radius of a new subtaxel, as a fraction of the taxel's radius.
constexpr double kPartOfRadius = 0.5;

SetTaxels change_of(const Taxel& taxel, std::vector<Subtaxel> subtaxels) {
  TaxelChange change;
  change.id = taxel.id;
  change.subtaxels = std::move(subtaxels);
  return SetTaxels{{change}};
}

/// Draws the fields of a subtaxel and stores their values in `changed`.
bool draw_fields(WindowUi& ui, const std::string& name, Subtaxel& changed) {
  bool any = false;
  const std::string center = name + " centre (mm)", normal = name + " normal", radius = name + " radius (mm)";
  begin_property("Centre (mm)", "Of its part of the receptive field, in the frame of the mesh file");
  if (const auto typed = vector_field(ui, center, {changed.center}, kMillimetres)) {
    changed.center[typed->axis] = typed->value;
    any = true;
  }
  begin_property("Normal", "Outward direction; its length does not count");
  if (const auto typed = vector_field(ui, normal, {changed.normal}, kPlain)) {
    changed.normal[typed->axis] = typed->value;
    any = true;
  }
  begin_property("Radius (mm)", "At most the taxel's own");
  if (const auto typed = number_field(ui, radius, {changed.radius}, kMillimetres)) {
    changed.radius = *typed;
    any = true;
  }
  show_refusal(ui, radius);
  return any;
}

}  // namespace

void draw_subtaxels(WindowUi& ui, const Taxel& taxel) {
  const std::string title =
      taxel.subtaxels.empty() ? "Subtaxels" : fmt::format("Subtaxels ({})", taxel.subtaxels.size());
  if (!header(ui, (title + "##subtaxels").c_str())) return;
  for (std::size_t i = 0; i < taxel.subtaxels.size(); ++i) {
    const std::string name = fmt::format("Subtaxel {}", i);
    ImGui::PushID(static_cast<int>(i));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(name.c_str());
    ImGui::SameLine();
    if (ImGui::SmallButton("Delete")) {
      std::vector<Subtaxel> rest = taxel.subtaxels;
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
      ui.post(EditProject{change_of(taxel, std::move(rest)), {}});
    }
    ui.widgets.note_item("Delete " + name);
    Subtaxel changed = taxel.subtaxels[i];
    if (begin_properties("subtaxel")) {
      if (draw_fields(ui, name, changed)) {
        std::vector<Subtaxel> all = taxel.subtaxels;
        all[i] = changed;
        post_edit(ui, change_of(taxel, std::move(all)));
      }
      end_properties();
    }
    ImGui::PopID();
  }
  if (button(ui, "Add a subtaxel", ImVec2(-1, 0))) {
    std::vector<Subtaxel> more = taxel.subtaxels;
    more.push_back({taxel.center, taxel.normal, kPartOfRadius * taxel.radius});
    ui.post(EditProject{change_of(taxel, std::move(more)), {}});
  }
  tooltip("A taxel with subtaxels reads what lies in their fields instead of its own");
}

}  // namespace taxel::ui
