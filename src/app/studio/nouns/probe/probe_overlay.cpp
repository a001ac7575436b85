#include "app/studio/nouns/probe/probe_overlay.h"

#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/view_drawing.h"
#include "ui/theme.h"

namespace taxel::ui {

void draw_probe_handle(const WindowUi& ui, const Viewer& viewer, const Shown& shown, const ProbeState& probe,
                       ImDrawList& list) {
  if (!probe.on || probe.held || !probe.at) return;
  const ImVec2 at = on_screen(viewer, shown_pose(viewer, shown) * *probe.at);
  const float radius = 8 * static_cast<float>(ui.pixel_scale);
  const Palette& colors = palette(ui.dark);
  list.AddCircle(at, radius, to_u32(colors.panel, 0.8f), 0, 4.0f);
  list.AddCircle(at, radius, to_u32(colors.accent), 0, 2.0f);
}

const char* probe_hint(const ProbeState& probe) {
  return probe.held ? "Probe: wheel or drag sets the depth, a click puts it down   Esc ends" : "";
}

}  // namespace taxel::ui
