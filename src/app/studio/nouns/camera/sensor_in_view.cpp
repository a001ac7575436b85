#include "app/studio/nouns/camera/sensor_in_view.h"

#include <algorithm>
#include <cmath>

#include "app/studio/frame/shown_scene.h"

namespace taxel::ui {

namespace {

BoxCorners corners_of(const Aabb& box_M, const Pose& X_WM) {
  BoxCorners corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const dvec3 p_M((i & 1U) != 0 ? box_M.hi.x : box_M.lo.x, (i & 2U) != 0 ? box_M.hi.y : box_M.lo.y,
                    (i & 4U) != 0 ? box_M.hi.z : box_M.lo.z);
    corners[i] = X_WM * p_M;
  }
  return corners;
}

}  // namespace

std::vector<BoxCorners> sensor_boxes(const Viewer& viewer, const Shown& shown) {
  std::vector<BoxCorners> boxes;
  if (viewer.mode == Mode::simulate && shown.run.frame && shown.run.frame->scene) {
    const auto& sensors = shown.run.frame->scene->sensors;
    for (std::size_t i = 0; i < sensors.size() && i < shown.run.frame->sensors.size(); ++i)
      boxes.push_back(corners_of(sensors[i]->mesh->bounds(), shown.run.frame->sensors[i].X_WM));
  } else if (shown.document.model && !shown.document.model->mesh->bounds().empty()) {
    boxes.push_back(corners_of(shown.document.model->mesh->bounds(), shown_pose(viewer, shown)));
  }
  return boxes;
}

bool is_inside_view(const BoxCorners& box_W, const Camera& camera, int width, int height) {
  return std::all_of(box_W.begin(), box_W.end(), [&](const dvec3& p_W) {
    const dvec3 pixel = camera.project(p_W, width, height);
    return pixel.z > camera.near_plane() && pixel.x >= 0 && pixel.y >= 0 && pixel.x <= width && pixel.y <= height;
  });
}

bool is_outside_view(const BoxCorners& box_W, const Camera& camera, int width, int height) {
  const glm::dmat4 view = camera.view();
  const double slope_y = std::tan(0.5 * glm::radians(camera.fov_deg)), slope_x = slope_y * width / height;
  // A corner is beyond a side if it is farther from the axis of the view than the side is at the corner's depth.
  std::array<bool, 5> beyond{true, true, true, true, true};  // left, right, bottom, top, behind
  for (const dvec3& p_W : box_W) {
    const dvec3 p_C(view * glm::dvec4(p_W, 1));
    const double depth = -p_C.z;
    const double scale = camera.depth_scale(depth);
    const std::array<bool, 5> here{p_C.x<-slope_x * scale, p_C.x> slope_x * scale,
                                   p_C.y<-slope_y * scale, p_C.y> slope_y * scale, depth < camera.near_plane()};
    for (std::size_t i = 0; i < beyond.size(); ++i) beyond[i] = beyond[i] && here[i];
  }
  return std::any_of(beyond.begin(), beyond.end(), [](bool all) { return all; });
}

bool sensors_are_outside_view(const Viewer& viewer, const Shown& shown) {
  if (viewer.view.width <= 0 || viewer.view.height <= 0) return false;
  const std::vector<BoxCorners> boxes = sensor_boxes(viewer, shown);
  return !boxes.empty() && std::all_of(boxes.begin(), boxes.end(), [&](const BoxCorners& box) {
    return is_outside_view(box, viewer.camera(), viewer.view.width, viewer.view.height);
  });
}

}  // namespace taxel::ui
