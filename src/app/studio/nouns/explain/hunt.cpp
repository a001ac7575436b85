#include "app/studio/nouns/explain/hunt.h"

#include "app/studio/host/run/send.h"
#include "app/studio/nouns/explain/explain_tool.h"

namespace taxel::ui {

namespace {

/// Smallest jump that pauses the example, as a fraction of the taxel's largest reading. The contact itself changes a
/// reading by less than a third of it in one step of the sweep.
constexpr double kJump = 0.04;

}  // namespace

void begin_hunt(WindowUi& ui, HuntState& hunt) {
  Breakpoints breakpoints;
  breakpoints.at_equal_force = true;
  breakpoints.jump = kJump;
  ui.post(BreakpointsCommand{breakpoints});
  hunt.waits_for_jump = true;
}

void follow_hunt(Viewer& viewer, const Shown& shown, HuntState& hunt, ExplainState& explain, bool& panel_is_open) {
  if (!hunt.waits_for_jump || !shown.run.frame || !shown.run.frame->stop) return;
  const Jump* const jump = std::get_if<Jump>(&*shown.run.frame->stop);
  const SensorModelPtr model = shown.model(viewer);
  if (jump == nullptr || !model || jump->taxel >= static_cast<int>(model->layout.taxels.size())) return;
  hunt.waits_for_jump = false;
  viewer.selection.set(model->layout.taxels[static_cast<std::size_t>(jump->taxel)].id);
  explain_reading(viewer, shown, explain, panel_is_open);
}

}  // namespace taxel::ui
