// Commands about selection, tools and edits of the layout, carried out.
#include <algorithm>
#include <cmath>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/surface_place.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/table/table.h"
#include "app/studio/nouns/table/table_state.h"
#include "app/studio/nouns/table/taxel_order.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "app/studio/shell/interface/carry_out.h"

namespace taxel::ui {

namespace {

/// The origin is taken as the middle of a mesh if its distance to it is at most this fraction of the mesh's width.
constexpr double kMiddle = 0.02;

/// Removes hidden taxels from the selection.
void keep_shown(App& app) {
  if (app.viewer->mode != Mode::layout || !app.shown->document.editing.project) return;
  for (const int id : app.shown->document.editing.project->hidden) app.viewer->selection.remove(id);
}

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

void CarryOut::operator()(const SelectAll&) const {
  app.viewer->selection.set_all(*app.shown->layout(*app.viewer));
  keep_shown(app);
}

void CarryOut::operator()(const InvertSelection&) const {
  app.viewer->selection.invert(*app.shown->layout(*app.viewer));
  keep_shown(app);
}

void CarryOut::operator()(const ToggleTool& command) const {
  const bool active = app.get<ToolState>().tool == command.tool;
  cancel_tool(*app.ui, app.viewer->selection, app.get<ToolState>());
  if (!active) app.get<ToolState>().tool = command.tool;
}

void CarryOut::operator()(const ProjectSelectedBack&) const {
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

void CarryOut::operator()(const RenameSelected&) const {
  app.get<PanelsShown>()[kTaxelTable] = true;
  app.get<TableState>().cell = {app.viewer->selection.taxels.back(), TableColumn::name, true, {}};
}

void CarryOut::operator()(const MoveInOrder& command) const {
  const Layout& layout = app.shown->document.editing.project->layout;
  app.ui->post(EditProject{ReorderTaxels{moved_by_one(layout, app.viewer->selection.taxels, command.earlier)}, {}});
}

void CarryOut::operator()(const MirrorSelected&) const {
  const MirrorPlane plane =
      mirror_plane_of(app.shown->document.editing.project->layout, app.shown->document.model->mesh->bounds());
  app.ui->post(EditProject{
      MirrorTaxels{app.viewer->selection.taxels, plane, MirrorTaxels{}.tolerance, app.shown->document.model->skin},
      {}});
}

void CarryOut::operator()(const HideSelected&) const {
  std::vector<int> hidden = app.shown->document.editing.project->hidden;
  hidden.insert(hidden.end(), app.viewer->selection.taxels.begin(), app.viewer->selection.taxels.end());
  app.ui->post(EditProject{SetHidden{hidden}, {}});
  app.viewer->selection.clear();
}

void CarryOut::operator()(const ShowOnlySelected&) const {
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
