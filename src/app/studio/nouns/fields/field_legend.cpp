// Legends of the overlays of receptive fields and repair: the meaning of their colours, with numbers.
#include "app/studio/nouns/fields/fields.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <numeric>

#include "app/studio/frame/feature.h"
#include "ui/scene/marks/marks.h"
#include "ui/scene/passes/look.h"
#include "ui/theme.h"
#include "ui/widgets/format.h"

namespace taxel::ui {
namespace {

struct Row {
  std::optional<glm::vec3> color;
  std::string text, value;  ///< texts at the left and at the right
};
struct Legend {
  std::string title;
  std::vector<Row> rows;
};

std::string per_cent(double part, double whole) {
  return fmt::format("{:.1f} %", whole > 0 ? 100 * part / whole : 0.0);
}

/// The title has the number that a layout is judged by, and the rows have the areas behind it.
Legend coverage_legend(const CoverageNumbers& numbers) {
  const std::vector<double>& areas = numbers.area_of_overlap;
  const auto sum_from = [&](std::size_t first) {
    return std::accumulate(areas.begin() + static_cast<std::ptrdiff_t>(std::min(first, areas.size())), areas.end(),
                           0.0);
  };
  const auto area_row = [&](std::optional<glm::vec3> color, std::string name, double area) {
    return Row{color, std::move(name), fmt::format("{}   {}", in_mm2(area), per_cent(area, numbers.area))};
  };
  Legend legend{"Covered: " + per_cent(sum_from(1), numbers.area) + " of the skin", {}};
  const int most = std::min(kMostOverlap, static_cast<int>(areas.size()) - 1);
  for (int n = 0; n <= most; ++n) {
    const bool last = n == kMostOverlap;
    const double area = last ? sum_from(static_cast<std::size_t>(n)) : areas[static_cast<std::size_t>(n)];
    const std::string name =
        n == 0 ? "no taxel" : fmt::format("{} taxel{}{}", n, n == 1 ? "" : "s", last ? " or more" : "");
    legend.rows.push_back(area_row(overlap_color(n), name, area));
  }
  legend.rows.push_back(area_row(std::nullopt, "two or more", sum_from(2)));
  legend.rows.push_back({std::nullopt, "mean where covered", fmt::format("{:.2f}", numbers.overlap)});
  return legend;
}

Legend comparison_legend(const FieldComparison& numbers) {
  Legend legend{"Euclidean vs. geodesic distance", {}};
  const double all = numbers.geodesic + numbers.euclidean_only;
  legend.rows.push_back(
      {euclidean_only_color(), "Euclidean only",
       fmt::format("{}   {}", in_mm2(numbers.euclidean_only), per_cent(numbers.euclidean_only, all))});
  legend.rows.push_back({std::nullopt, "sum of Euclidean fields", in_mm2(numbers.euclidean)});
  legend.rows.push_back({std::nullopt, "sum of geodesic fields", in_mm2(numbers.geodesic)});
  legend.rows.push_back({std::nullopt, "fields that differ by over 1 %", fmt::format("{}", numbers.differing)});
  return legend;
}

Legend normals_legend(const NormalNumbers& numbers, const SensorModel& model) {
  Legend legend{"Normal deviation", {}};
  for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const double angle = part * numbers.limit_deg;
    legend.rows.push_back({normal_color(angle, numbers.limit_deg), fmt::format("{:.4g}°", angle), ""});
  }
  legend.rows.push_back({normal_color(1, 0), "beyond the layout's limit", ""});
  legend.rows.push_back({std::nullopt, "mean", fmt::format("{:.1f}°", numbers.mean_deg)});
  if (numbers.largest_taxel >= 0) {
    const int id = model.layout.taxels[static_cast<std::size_t>(numbers.largest_taxel)].id;
    legend.rows.push_back({std::nullopt, "largest", fmt::format("{:.1f}° (taxel {})", numbers.largest_deg, id)});
  }
  return legend;
}

Legend tractions_legend(const TractionNumbers& numbers, const Look& colors) {
  Legend legend{fmt::format("Traction of {} polygons", grouped(numbers.polygons)), {}};
  legend.rows.push_back({glm::vec3(colors.force), "pressure, up to", in_kpa(numbers.largest_pressure)});
  legend.rows.push_back({glm::vec3(colors.friction), "friction, up to",
                         numbers.friction_known ? in_kpa(numbers.largest_friction) : "not known here"});
  if (numbers.metres_per_pascal > 0)
    legend.rows.push_back({std::nullopt, "an arrow of 1 mm", in_kpa(1e-3 / numbers.metres_per_pascal)});
  return legend;
}

Legend repair_legend(const RepairedMesh& repaired) {
  const RepairChanges& changes = repaired.changes;
  Legend legend{"Changed by the repair", {}};
  const auto add = [&](const glm::vec3& color, const char* text, std::size_t count) {
    if (count > 0) legend.rows.push_back({color, text, grouped(static_cast<long long>(count))});
  };
  add(kFilledColor, "filled faces", changes.filled_faces.size());
  const double largest = largest_distance(changes);
  if (!(largest > 0)) add(kRemovedColor, "removed faces", changes.removed_faces.size());
  add(kPartedColor, "parted edges", changes.parted_edges.size());
  for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    if (largest > 0)
      legend.rows.push_back(
          {distance_color(part, 1), part == 0 ? "distance of the wrap" : "", in_mm(part * largest, 3)});
  }
  if (legend.rows.empty()) legend.rows.push_back({std::nullopt, "nothing that can be seen", ""});
  return legend;
}

float legend_height(const Legend& legend) {
  const float line = ImGui::GetFontSize();
  return 1.3f * line * static_cast<float>(legend.rows.size() + 1) + 0.75f * line;
}

/// Draws a legend and returns its upper edge.
float draw_legend(const WindowUi& ui, const ViewPlace& place, const Legend& legend, float bottom) {
  const Palette& colors = palette(ui.dark);
  const float line = ImGui::GetFontSize(), pad = 0.5f * line, step = 1.3f * line;
  const auto wide = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
  float width = wide(legend.title);
  for (const Row& row : legend.rows) width = std::max(width, wide(row.text) + wide(row.value) + 2.4f * line);
  const float height = legend_height(legend);
  const ImVec2 corner(place.rect.x1 - 0.7f * line - width - 2 * pad, bottom - height);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + width + 2 * pad, bottom}, to_u32(colors.panel, 0.88f), 3);
  list.AddText({corner.x + pad, corner.y + pad}, to_u32(colors.text), legend.title.c_str());
  float y = corner.y + pad + step;
  for (const Row& row : legend.rows) {
    if (row.color) {
      const ImVec4 c(row.color->x, row.color->y, row.color->z, 1);
      list.AddRectFilled({corner.x + pad, y + 0.15f * line}, {corner.x + pad + 0.8f * line, y + 0.85f * line},
                         to_u32(c), 2);
    }
    list.AddText({corner.x + pad + (row.color ? 1.3f * line : 0), y}, to_u32(colors.text), row.text.c_str());
    list.AddText({corner.x + pad + width - wide(row.value), y}, to_u32(colors.text), row.value.c_str());
    y += step;
  }
  return corner.y;
}

}  // namespace

void draw_field_legends(const WindowUi& ui, const ViewPlace& place, const FieldNumbers& numbers,
                        const SensorModel& model, float bottom) {
  const float gap = 0.5f * ImGui::GetFontSize();
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  if (numbers.due) bottom = draw_legend(ui, place, {"Working out the receptive fields ...", {}}, bottom) - gap;
  if (numbers.tractions)
    bottom = draw_legend(ui, place, tractions_legend(*numbers.tractions, look(ui.dark)), bottom) - gap;
  if (numbers.coverage) bottom = draw_legend(ui, place, coverage_legend(*numbers.coverage), bottom) - gap;
  if (numbers.comparison) bottom = draw_legend(ui, place, comparison_legend(*numbers.comparison), bottom) - gap;
  if (numbers.normals) draw_legend(ui, place, normals_legend(*numbers.normals, model), bottom);
  ImGui::PopFont();
}

void draw_repair_legend(const WindowUi& ui, const Viewer& viewer, const MeshState& mesh, const SensorModel& model,
                        float top) {
  if (viewer.mode != Mode::layout || !mesh.shows_changes || model.mesh == model.loaded) return;
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  const Legend legend = repair_legend(*model.repaired);
  draw_legend(ui, viewer.view, legend, top + legend_height(legend));
  ImGui::PopFont();
}

constinit const Feature kFields{.make_job = studio::make_fields_job};

}  // namespace taxel::ui
