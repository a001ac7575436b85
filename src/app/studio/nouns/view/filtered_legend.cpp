#include "app/studio/nouns/view/filtered_legend.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "ui/scene/color_map.h"
#include "ui/theme.h"
#include "ui/widgets/format.h"

namespace taxel::ui {
namespace {

/// Returns an explanation of a reason of rejection.
const char* explain(Rejection reason) {
  switch (reason) {
    case Rejection::sliver:
      return "slivers, too thin to have a normal";
    case Rejection::touching:
      return "touching, in the skin without pressure";
    case Rejection::back_face:
      return "back faces, against the pressure's gradient";
    default:
      return "beyond the tets of a field that ends there (not drawn)";
  }
}

}  // namespace

std::array<RejectedPolygons, kRejections> left_out(const SensorStep& sensor) {
  std::array<RejectedPolygons, kRejections> sums{};
  for (const ContactSurface& surface : sensor.surfaces) {
    for (std::size_t r = 0; r < kRejections; ++r) {
      sums[r].count += surface.rejected[r].count;
      sums[r].area += surface.rejected[r].area;
      sums[r].force += surface.rejected[r].force;
    }
  }
  return sums;
}

float draw_filtered_legend(const WindowUi& ui, const ViewPlace& place, const SensorStep& sensor) {
  const Palette& colors = palette(ui.dark);
  const std::array<RejectedPolygons, kRejections> sums = left_out(sensor);
  std::array<std::string, kRejections> rows;
  const std::string title = "Left out of the contact surface";
  float width = ImGui::CalcTextSize(title.c_str()).x;
  for (std::size_t r = 0; r < kRejections; ++r) {
    rows[r] = fmt::format("{}: {}, {}, {:.3g} N", explain(static_cast<Rejection>(r)), grouped(sums[r].count),
                          in_mm2(sums[r].area), sums[r].force);
    width = std::max(width, ImGui::CalcTextSize(rows[r].c_str()).x + ImGui::GetFontSize());
  }
  const float line = ImGui::GetFontSize(), pad = 0.5f * line, step = 1.3f * line;
  const float height = step * static_cast<float>(kRejections + 1) + pad;
  const ImVec2 corner(place.rect.x1 - 0.7f * line - width - 2 * pad, place.rect.y1 - 0.7f * line - height);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + width + 2 * pad, corner.y + height}, to_u32(colors.panel, 0.85f), 3);
  list.AddText({corner.x + pad, corner.y + pad}, to_u32(colors.text), title.c_str());
  for (std::size_t r = 0; r < kRejections; ++r) {
    const float y = corner.y + pad + step * static_cast<float>(r + 1);
    const glm::vec3 c = rejection_color(static_cast<Rejection>(r));
    list.AddCircleFilled({corner.x + pad + 0.35f * line, y + 0.5f * line}, 0.3f * line,
                         to_u32(ImVec4(c.x, c.y, c.z, 1)));
    list.AddText({corner.x + pad + line, y}, to_u32(sums[r].count > 0 ? colors.text : colors.dim), rows[r].c_str());
  }
  return corner.y;
}

}  // namespace taxel::ui
