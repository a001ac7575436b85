#include "app/studio/frame/shown.h"

namespace taxel::ui {

std::span<const double> RunView::error_bars(int sensor) const {
  if (!errors || !frame || sensor < 0 || static_cast<std::size_t>(sensor) >= errors->bars.size()) return {};
  const StepId shown = frame->id();
  const bool same_run = errors->id.run == shown.run && errors->id.model_edition == shown.model_edition;
  if (!same_run || (errors->id.step != shown.step && !playing)) return {};
  return errors->bars[static_cast<std::size_t>(sensor)];
}

const SensorStep* Shown::sensor(const Viewer& viewer) const {
  const int selected = viewer.selection.sensor;
  if (!run.frame || selected < 0 || selected >= static_cast<int>(run.frame->sensors.size())) return nullptr;
  return &run.frame->sensors[static_cast<std::size_t>(selected)];
}

const SensorStep* Shown::state(const Viewer& viewer) const {
  if (viewer.mode == Mode::simulate) return sensor(viewer);
  return document.probe && document.probe->problem.empty() ? &document.probe->state : nullptr;
}

SensorModelPtr Shown::model(const Viewer& viewer) const {
  if (viewer.mode == Mode::simulate && sensor(viewer) != nullptr)
    return run.frame->scene->sensors[static_cast<std::size_t>(viewer.selection.sensor)];
  return document.model;
}

const Layout* Shown::layout(const Viewer& viewer) const {
  if (viewer.mode == Mode::layout && document.editing.project) return &document.editing.project->layout;
  const SensorModelPtr shown = model(viewer);
  return shown ? &shown->layout : nullptr;
}

bool can_edit(const Viewer& viewer, const Shown& shown) {
  return viewer.mode == Mode::layout && shown.document.editing.project && shown.document.model;
}

}  // namespace taxel::ui
