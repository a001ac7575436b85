// Commands about selection, tools and edits of the layout, carried out.
#include <algorithm>
#include <cmath>

#include "app/studio/app/carry_out.h"
#include "app/studio/app/pointing/surface_place.h"
#include "app/studio/features/table/taxel_order.h"

namespace taxel::ui {

namespace {

/// The origin is taken as the middle of a mesh if its distance to it is at most this fraction of the mesh's width.
constexpr double kMiddle = 0.02;

/// Removes hidden taxels from the selection.
void keep_shown(UiState& ui, const UiInput& input) {
  if (ui.mode != Mode::layout || !input.editing.project) return;
  for (const int id : input.editing.project->hidden) ui.selection.remove(id);
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
  ui.selection.set_all(*input.shown_layout(ui));
  keep_shown(ui, input);
}

void CarryOut::operator()(const InvertSelection&) const {
  ui.selection.invert(*input.shown_layout(ui));
  keep_shown(ui, input);
}

void CarryOut::operator()(const ToggleTool& command) const {
  const bool active = ui.tool.tool == command.tool;
  cancel_tool(ui);
  if (!active) ui.tool.tool = command.tool;
}

void CarryOut::operator()(const ProjectSelectedBack&) const {
  SetTaxels set;
  for (const int id : ui.selection.taxels) {
    const Taxel* taxel = find_taxel(input.editing.project->layout, id);
    if (taxel == nullptr) continue;
    const SurfacePlace place = place_near(*input.model->skin, taxel->center);
    TaxelChange change;
    change.id = id;
    change.center = place.position;
    change.normal = place.normal;
    set.changes.push_back(change);
  }
  ui.ask(EditProject{set, {}});
}

void CarryOut::operator()(const RenameSelected&) const {
  ui.saved.panels.taxels = true;
  ui.table.cell = {ui.selection.taxels.back(), TableColumn::name, true, {}};
}

void CarryOut::operator()(const MoveInOrder& command) const {
  const Layout& layout = input.editing.project->layout;
  ui.ask(EditProject{ReorderTaxels{moved_by_one(layout, ui.selection.taxels, command.earlier)}, {}});
}

void CarryOut::operator()(const MirrorSelected&) const {
  const MirrorPlane plane = mirror_plane_of(input.editing.project->layout, input.model->mesh->bounds());
  ui.ask(EditProject{MirrorTaxels{ui.selection.taxels, plane, MirrorTaxels{}.tolerance, input.model->skin}, {}});
}

void CarryOut::operator()(const HideSelected&) const {
  std::vector<int> hidden = input.editing.project->hidden;
  hidden.insert(hidden.end(), ui.selection.taxels.begin(), ui.selection.taxels.end());
  ui.ask(EditProject{SetHidden{hidden}, {}});
  ui.selection.clear();
}

void CarryOut::operator()(const ShowOnlySelected&) const {
  const Project& project = *input.editing.project;
  std::vector<int> hidden;
  for (const Taxel& taxel : project.layout.taxels) {
    if (!ui.selection.contains(taxel.id)) hidden.push_back(taxel.id);
  }
  std::vector<int> ascending = hidden;
  std::sort(ascending.begin(), ascending.end());
  if (ascending == project.hidden) hidden.clear();
  ui.ask(EditProject{SetHidden{hidden}, {}});
}

}  // namespace taxel::ui
