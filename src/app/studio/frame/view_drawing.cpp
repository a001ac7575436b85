#include "app/studio/frame/view_drawing.h"

#include <cmath>

#include "ui/scene/pick/gizmo.h"
#include "ui/theme.h"

namespace taxel::ui {

ImVec2 on_screen(const Viewer& viewer, const dvec3& p_W) {
  const dvec3 pixel = viewer.project(p_W);
  return {viewer.view.rect.x0 + static_cast<float>(pixel.x), viewer.view.rect.y0 + static_cast<float>(pixel.y)};
}

float view_line_top(const ViewPlace& place, int row) {
  const float line = ImGui::GetFontSize();
  return std::round(place.rect.y0 + 2.9f * line + 1.7f * line * static_cast<float>(row));
}

void draw_view_line(const WindowUi& ui, const ViewPlace& place, ImDrawList& list, int row, const std::string& text,
                    const ImVec4& color) {
  const float line = ImGui::GetFontSize();
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const ImVec2 at(place.rect.x0 + place.strip + 0.8f * line, view_line_top(place, row));
  list.AddRectFilled({at.x - 6, at.y - 3}, {at.x + size.x + 6, at.y + size.y + 3},
                     to_u32(palette(ui.dark).panel, 0.85f), 3);
  list.AddText(at, to_u32(color), text.c_str());
}

int draw_view_name(const WindowUi& ui, const Viewer& viewer, ImDrawList& list, int row) {
  std::string name = standard_view_name(viewer.camera());
  if (viewer.camera().orthographic) name += name.empty() ? "Orthographic" : ", orthographic";
  if (name.empty()) return row;
  draw_view_line(ui, viewer.view, list, row, name, palette(ui.dark).text);
  return row + 1;
}

}  // namespace taxel::ui
