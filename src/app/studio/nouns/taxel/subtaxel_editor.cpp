#include "app/studio/nouns/taxel/subtaxel_editor.h"

#include <fmt/format.h>
#include <imgui.h>

#include "app/studio/nouns/history/edit_commands.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/number_field.h"

namespace taxel::ui {

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
