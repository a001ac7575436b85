#include "app/studio/nouns/files/sheet_pictures.h"

#include <algorithm>
#include <cmath>

#include "app/studio/host/png.h"
#include "ui/scene/scene_labels.h"

namespace taxel::studio {

namespace {

constexpr int kWidth = 1000, kHeight = 900;
constexpr double kLabelHeight = 30;  // [pixels], of the 86 mm that a picture is wide on paper
constexpr double kSteepest = 89;     // of a camera, which has z up [degrees]

ui::Camera camera_from(const dvec3& direction, const Aabb& box) {
  ui::Camera camera;
  const dvec3 d = glm::normalize(direction);
  camera.elevation_deg = std::clamp(glm::degrees(std::asin(std::clamp(d.z, -1.0, 1.0))), -kSteepest, kSteepest);
  camera.azimuth_deg = std::hypot(d.x, d.y) > 1e-6 ? glm::degrees(std::atan2(d.y, d.x)) : -90;
  camera.frame(box);
  return camera;
}

SheetPicture picture_from(ui::SceneRenderer& renderer, const ui::SceneInput& scene, const ui::Camera& camera,
                          const char* caption) {
  SheetPicture picture{caption, png_bytes(renderer.cut_out(scene, camera, kWidth, kHeight)), {}};
  for (const ui::SceneLabel& label : ui::scene_labels(scene, camera, kWidth, kHeight, kLabelHeight))
    picture.labels.push_back({label.pixel.x / kWidth, label.pixel.y / kHeight, label.text, label.occluded});
  return picture;
}

}  // namespace

std::vector<SheetPicture> sheet_pictures(ui::SceneRenderer& renderer, const SensorModelPtr& model) {
  ui::SceneInput scene;
  scene.document_model = model;
  scene.overlays.sensor_transparent = false;
  scene.overlays.samples = false;
  scene.dark = false;
  const SensorFrame& frame = model->layout.frame;
  const dvec3 side = glm::cross(frame.distal, frame.pad);
  const Aabb box = model->mesh->bounds();
  return {picture_from(renderer, scene, camera_from(frame.pad, box), "Pad side"),
          picture_from(renderer, scene, camera_from(-frame.pad, box), "Back"),
          picture_from(renderer, scene, camera_from(side, box), "One side"),
          picture_from(renderer, scene, camera_from(-side, box), "Other side")};
}

}  // namespace taxel::studio
