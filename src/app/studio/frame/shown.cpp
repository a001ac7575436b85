#include "app/studio/frame/shown.h"

#include <algorithm>

namespace taxel::ui {

std::span<const double> RunView::error_bars(int sensor) const {
  if (!errors || !frame || sensor < 0 || static_cast<std::size_t>(sensor) >= errors->bars.size()) return {};
  const StepId shown = frame->id();
  const bool same_run = errors->id.run == shown.run && errors->id.model_edition == shown.model_edition;
  if (!same_run || (errors->id.step != shown.step && !playing)) return {};
  return errors->bars[static_cast<std::size_t>(sensor)];
}

const char* Shown::empty_text() const {
  if (document.loading.active) return "Loading ...";
  return document.name.empty() ? "Nothing is open." : "The document has nothing to display here.";
}

bool Shown::shows_scene(const Viewer& viewer) const {
  return shows_run(viewer.mode) || (document.is_scene && !document.editing.project);
}

bool Shown::shows_edited(const Viewer& viewer) const {
  if (!document.editing.project || viewer.mode == Mode::layout) return document.editing.project != nullptr;
  if (!document.scene_layout || !run.frame || !run.frame->scene) return false;
  const std::vector<std::string>& geoms = document.scene_layout->geoms;
  return std::any_of(geoms.begin(), geoms.end(), [&](const std::string& geom) {
    return sensor_on(*run.frame->scene, geom) == viewer.selection.sensor;
  });
}

const SensorStep* Shown::sensor(const Viewer& viewer) const {
  const int selected = viewer.selection.sensor;
  if (!run.frame || selected < 0 || selected >= static_cast<int>(run.frame->sensors.size())) return nullptr;
  return &run.frame->sensors[static_cast<std::size_t>(selected)];
}

const SensorStep* Shown::state(const Viewer& viewer) const {
  if (shows_scene(viewer)) return sensor(viewer);
  return document.probe && document.probe->problem.empty() ? &document.probe->state : nullptr;
}

SensorModelPtr Shown::model(const Viewer& viewer) const {
  if (shows_scene(viewer) && sensor(viewer) != nullptr)
    return run.frame->scene->sensors[static_cast<std::size_t>(viewer.selection.sensor)];
  return document.model;
}

const Layout* Shown::layout(const Viewer& viewer) const {
  if (viewer.mode == Mode::layout && document.editing.project) return &document.editing.project->layout;
  const SensorModelPtr shown = model(viewer);
  return shown ? &shown->layout : nullptr;
}

int sensor_on(const SimScene& scene, const std::string& geom) {
  const auto found = std::find(scene.sensor_geoms.begin(), scene.sensor_geoms.end(), geom);
  return found == scene.sensor_geoms.end() ? -1 : static_cast<int>(found - scene.sensor_geoms.begin());
}

bool can_edit(const Viewer& viewer, const Shown& shown) {
  return viewer.mode == Mode::layout && shown.document.editing.project && shown.document.model;
}

}  // namespace taxel::ui
