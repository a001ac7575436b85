#include "app/studio/app/reset.h"

#include "app/studio/app/app.h"
#include "app/studio/features/measure/measure_tool.h"
#include "app/studio/features/probe/probe_tool.h"
#include "app/studio/features/scenario/path_recorder.h"

namespace taxel::ui {

void forget_document(App& app) {
  app.ui.fields.refused.reset();
  app.viewer.selection = {};
  app.viewer.clip.reset();
  app.layout.tool = {};
  app.layout.generate = {};
  leave_probe(app.layout.probe);
  app.layout.probe.sized = false;
  leave_measure(app.layout.measure);
  app.layout.mesh = {};
  app.simulate.perturb = {};
  app.simulate.real = {};
  app.simulate.controls = {};
  app.simulate.study = {};
  leave_path(app.simulate.path);
}

}  // namespace taxel::ui
