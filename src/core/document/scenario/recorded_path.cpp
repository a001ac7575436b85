#include "core/document/scenario/recorded_path.h"

#include "core/document/paper_setting.h"

namespace taxel {

Scenario path_of_run(Scenario edited, const Scenario& run, std::vector<WayPoint> points) {
  const bool keeps_object = has_object(edited);
  edited = with_kind(edited, kKind<scenarios::Path>);
  if (!keeps_object) {
    edited.shape = run.shape;
    edited.object = run.object;
    edited.box_size = run.box_size;
    edited.edge_radius = run.edge_radius;
  }
  if (run.is<scenarios::Paper>()) {
    edited.shape = ObjectShape::box;
    edited.object.clear();
    edited.box_size = kDemoBox.extent().x;
    const dvec3 to_other_boxes(-kDemoBox.lo.x, -kDemoBox.center().y, -kDemoBox.lo.z);
    for (WayPoint& point : points) point.X_WM.p += to_other_boxes;
  }
  edited.as<scenarios::Path>().points = std::move(points);
  return edited;
}

}  // namespace taxel
