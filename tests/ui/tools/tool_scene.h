// A ball with taxels, as tools see it, without a window.
#pragma once

#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "core/mesh/make/primitives.h"
#include "core/sensor/sensor_model.h"

namespace taxel::ui::test {

inline constexpr double kBallRadius = 0.01;  // [m]

/// A ball about the origin, seen along -x from 80 mm away, z up: y points to the right of the view.
struct ToolScene {
  App app;
  Project project;

  explicit ToolScene(const std::vector<dvec3>& directions) {
    const auto mesh = std::make_shared<const TriMesh>(make_sphere(kBallRadius, 0.001));
    const MeshIndex skin(mesh);
    Layout& layout = project.layout;
    layout.mesh.file = "ball.obj";
    layout.sampling.density = 1e5;
    for (const dvec3& direction : directions) {
      const SurfacePoint on_skin = skin.closest_point(kBallRadius * glm::normalize(direction));
      Taxel taxel;
      taxel.id = static_cast<int>(layout.taxels.size()) + 1;
      taxel.center = on_skin.position;
      taxel.normal = glm::normalize(direction);
      taxel.radius = 0.002;
      layout.taxels.push_back(taxel);
    }
    app.shown->document.model = build_sensor_model(layout, mesh, "", "ball.taxels.json");
    app.viewer->mode = Mode::layout;
    for (Overlays& overlays : app.viewer->mode_overlays) overlays.sensor_transparent = false;
    app.viewer->view.rect = {0, 0, 800, 600};
    app.viewer->view.width = 800, app.viewer->view.height = 600;
    for (Camera& camera : app.viewer->cameras) {
      camera = Camera{};
      camera.azimuth_deg = 0, camera.elevation_deg = 0, camera.distance = 0.08;
    }
    publish();
  }
  /// Makes the present project the edited one.
  void publish() { app.shown->document.editing.project = std::make_shared<const Project>(project); }
  [[nodiscard]] dvec2 pixel(const dvec3& p) const { return dvec2(app.viewer->project(p)); }
  /// Returns the newest command of a kind that was posted, or null.
  template <class Kind>
  [[nodiscard]] const Kind* asked() const {
    for (auto command = app.ui->commands.rbegin(); command != app.ui->commands.rend(); ++command)
      if (const Kind* kind = command->get_if<Kind>()) return kind;
    return nullptr;
  }
};

}  // namespace taxel::ui::test
