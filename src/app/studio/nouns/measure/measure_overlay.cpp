#include "app/studio/nouns/measure/measure_overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/view_drawing.h"
#include "ui/theme.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

void draw_measure_label(const WindowUi& ui, const Viewer& viewer, const Shown& shown, const MeasureState& measure,
                        ImDrawList& list) {
  const Measured* measured = shown.document.measured.get();
  if (!measure.on || measured == nullptr) return;
  const dvec3 middle = measured->path.empty() ? 0.5 * (measured->request.a + measured->request.b)
                                              : measured->path[measured->path.size() / 2];
  const ImVec2 at = on_screen(viewer, shown_pose(viewer, shown) * middle);
  const std::string along =
      std::isfinite(measured->along) ? in_mm(measured->along) + " along the surface" : "no way along the surface";
  const std::string text = in_mm(measured->straight) + " straight\n" + along;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const Palette& colors = palette(ui.dark);
  const float gap = ImGui::GetFontSize();
  const ImVec2 corner(std::round(std::clamp(at.x + gap, viewer.view.rect.x0 + 8, viewer.view.rect.x1 - size.x - 8)),
                      std::round(std::clamp(at.y + gap, viewer.view.rect.y0 + 8, viewer.view.rect.y1 - size.y - 8)));
  list.AddRectFilled({corner.x - 6, corner.y - 4}, {corner.x + size.x + 6, corner.y + size.y + 4},
                     to_u32(colors.panel, 0.9f), 3);
  list.AddText(corner, to_u32(colors.text), text.c_str());
}

std::string measure_hint(const MeasureState& measure) {
  if (!measure.on) return "";
  return fmt::format("Measure: click on the {} point   Esc ends", measure.points.size() == 1 ? "second" : "first");
}

}  // namespace taxel::ui
