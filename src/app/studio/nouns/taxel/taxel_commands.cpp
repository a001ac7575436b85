#include "app/studio/nouns/taxel/taxel_commands.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/surface_place.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/host/host.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/scenario/path_state.h"
#include "app/studio/nouns/table/table.h"
#include "app/studio/nouns/table/table_state.h"
#include "app/studio/nouns/table/taxel_order.h"
#include "app/studio/nouns/taxel/gesture.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "core/layout/file/taxel_clipboard.h"

namespace taxel::ui {

namespace {

/// The origin is taken as the middle of a mesh if its distance to it is at most this fraction of the mesh's width.
constexpr double kMiddle = 0.02;

}  // namespace

MirrorPlane mirror_plane_of(const Layout& layout, const Aabb& bounds) {
  MirrorPlane plane;
  plane.normal = glm::normalize(glm::cross(layout.frame.distal, layout.frame.pad));
  // A normal along an axis becomes exact: the tilt is a rounding error of the cross product.
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(std::abs(plane.normal[axis]) - 1) < 1e-9) {
      const double sign = plane.normal[axis];
      plane.normal = dvec3(0);
      plane.normal[axis] = sign > 0 ? 1 : -1;
    }
  }
  const double width = glm::dot(glm::abs(plane.normal), bounds.extent());
  const double middle = glm::dot(plane.normal, bounds.center());
  if (std::abs(middle) > kMiddle * width) plane.point = middle * plane.normal;
  return plane;
}

void carry_out(const BeginGesture& command, App& app) {
  begin_gesture(*app.ui, *app.viewer, *app.shown, app.get<ToolState>(), app.get<PathState>(), command.tool,
                command.copies);
}

void carry_out(const ConstrainGesture& command, App& app) {
  constrain_gesture(app.get<ToolState>(), command.axis);
}

void carry_out(const AcceptGesture&, App& app) {
  accept_gesture(*app.ui, *app.viewer, *app.shown, app.get<ToolState>(), app.get<PathState>());
}

void carry_out(const CancelTool&, App& app) {
  cancel_tool(*app.ui, app.viewer->selection, app.get<ToolState>());
}

void carry_out(const ToggleTool& command, App& app) {
  const bool active = app.get<ToolState>().tool == command.tool;
  cancel_tool(*app.ui, app.viewer->selection, app.get<ToolState>());
  if (!active) app.get<ToolState>().tool = command.tool;
}

void leave_tool(App& app) {
  if (app.get<ToolState>().tool != Tool::none) cancel_tool(*app.ui, app.viewer->selection, app.get<ToolState>());
}

void carry_out(const DeleteSelected&, App& app) {
  app.ui->post(EditProject{DeleteTaxels{app.viewer->selection.taxels}, {}});
}

void carry_out(const ProjectSelectedBack&, App& app) {
  SetTaxels set;
  for (const int id : app.viewer->selection.taxels) {
    const Taxel* taxel = find_taxel(app.shown->document.editing.project->layout, id);
    if (taxel == nullptr) continue;
    const SurfacePlace place = place_near(*app.shown->document.model->skin, taxel->center);
    TaxelChange change;
    change.id = id;
    change.center = place.position;
    change.normal = place.normal;
    set.changes.push_back(change);
  }
  app.ui->post(EditProject{set, {}});
}

void carry_out(const RenameSelected&, App& app) {
  app.get<PanelsShown>()[kTaxelTable] = true;
  app.get<TableState>().cell = {app.viewer->selection.taxels.back(), TableColumn::name, true, {}};
}

void carry_out(const MoveInOrder& command, App& app) {
  const Layout& layout = app.shown->document.editing.project->layout;
  app.ui->post(EditProject{ReorderTaxels{moved_by_one(layout, app.viewer->selection.taxels, command.earlier)}, {}});
}

void carry_out(const MirrorSelected&, App& app) {
  const MirrorPlane plane =
      mirror_plane_of(app.shown->document.editing.project->layout, app.shown->document.model->mesh->bounds());
  app.ui->post(EditProject{
      MirrorTaxels{app.viewer->selection.taxels, plane, MirrorTaxels{}.tolerance, app.shown->document.model->skin},
      {}});
}

void carry_out(const HideSelected&, App& app) {
  std::vector<int> hidden = app.shown->document.editing.project->hidden;
  hidden.insert(hidden.end(), app.viewer->selection.taxels.begin(), app.viewer->selection.taxels.end());
  app.ui->post(EditProject{SetHidden{hidden}, {}});
  app.viewer->selection.clear();
}

void carry_out(const ShowOnlySelected&, App& app) {
  const Project& project = *app.shown->document.editing.project;
  std::vector<int> hidden;
  for (const Taxel& taxel : project.layout.taxels) {
    if (!app.viewer->selection.contains(taxel.id)) hidden.push_back(taxel.id);
  }
  std::vector<int> ascending = hidden;
  std::sort(ascending.begin(), ascending.end());
  if (ascending == project.hidden) hidden.clear();
  app.ui->post(EditProject{SetHidden{hidden}, {}});
}

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::CopyTaxels&, Host& host) {
  if (!host.edits().is_open()) return;
  const Layout& layout = host.edits().project()->layout;
  std::vector<Taxel> taxels;
  for (const int index : ui::selected_indices(host.app.viewer->selection, layout))
    taxels.push_back(layout.taxels[static_cast<std::size_t>(index)]);
  if (!taxels.empty()) ImGui::SetClipboardText(taxels_to_json(taxels).c_str());
}

void carry_out(const ui::PasteTaxels&, Host& host) {
  edit_document(host, [&](EditSession& edits) {
    const char* const text = ImGui::GetClipboardText();
    const std::vector<Taxel> taxels =
        with_unused_ids(parse_taxels(text != nullptr ? text : ""), edits.project()->layout);
    edits.edit(AddTaxels{taxels, std::nullopt});
    host.app.viewer->selection.clear();
    for (const Taxel& taxel : taxels) host.app.viewer->selection.add(taxel.id);
  });
}

}  // namespace taxel::studio
