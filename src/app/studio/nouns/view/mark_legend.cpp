#include "app/studio/nouns/view/mark_legend.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/scene/marks/force_marks.h"
#include "ui/scene/marks/ghost_marks.h"
#include "ui/scene/marks/model_marks.h"
#include "ui/scene/marks/path_marks.h"
#include "ui/theme.h"

namespace taxel::ui {
namespace {

using MarkRows = std::vector<MarkRow>;

constexpr const char* kFolded = "Legend";
constexpr float kLegendPlate = 0.92f;  // opacity

double length_of(const std::vector<dvec3>& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += glm::distance(line[i - 1], line[i]);
  return length;
}

/// Returns the colour of the first taxel that there is.
glm::vec4 color_of_taxels(const std::vector<SensorView>& views) {
  for (const SensorView& view : views)
    if (view.model->taxel_count() > 0) return glm::vec4(taxel_color(view.model->color(0)), 1);
  return glm::vec4(1);
}

void add_contact_rows(const SceneInput& input, const std::vector<SensorView>& views, const Look& look, MarkRows& rows) {
  const Overlays& show = input.overlays;
  bool touches = false, reads = false, sticks = false;
  for (const SensorView& view : views) {
    touches = touches || (view.state != nullptr && !view.state->surfaces.empty());
    sticks = sticks || (view.state != nullptr && !view.state->sticking.empty());
    reads = reads || (view.state != nullptr && view.model->taxel_count() > 0);
  }
  if (!force_marks(input, views).empty())
    rows.push_back({Glyph::arrow, look.force, "Net force",
                    fmt::format("{:g} mm = {:g} N", 1e3 * kNamedArrow, force_of_named_arrow(views))});
  if (show.rays && reads) {
    rows.push_back({Glyph::line, glm::vec4(glm::vec3(look.ray_hit), 1), "Rays to the contact", "true length, mm"});
    rows.push_back({Glyph::dot, glm::vec4(input.range.color(0.5 * (input.range.lo + input.range.hi)), 1),
                    "Pressure at their ends", "kPa"});
  }
  if (show.slip_map && show.contact_surface && sticks) {
    rows.push_back({Glyph::disc, glm::vec4(kSlipRange.color(0), 1), "Contact that sticks", "slip 0"});
    rows.push_back({Glyph::disc, glm::vec4(kSlipRange.color(1), 1), "Contact that slips", "slip 1"});
  } else if (show.slip_map && show.contact_surface && touches) {
    rows.push_back({Glyph::disc, glm::vec4(input.range.color(input.range.hi), 1), "No slip map: friction has no memory",
                    "pressure, kPa"});
  }
  if (show.contact_edges && touches) rows.push_back({Glyph::line, {0, 0, 0, 1}, "Edges of polygons", "true size, mm"});
  if (input.before)
    rows.push_back({Glyph::line, glm::vec4(glm::vec3(look.ghost), 1), "Previous step", "true size, mm"});
}

void add_taxel_rows(const SceneInput& input, const FieldNumbers& numbers, const std::vector<SensorView>& views,
                    const ReadingUnit& unit, MarkRows& rows) {
  const MarkCounts& marks = numbers.marks;
  const glm::vec4 color = color_of_taxels(views);
  if (marks.discs > 0)
    rows.push_back({Glyph::disc, glm::vec4(input.reading_range.color(0.5 * input.reading_range.hi), 1),
                    "Readings of fields", unit.text});
  if (marks.arrows > 0)
    rows.push_back({Glyph::arrow, color, "Normals of taxels",
                    views.size() == 1 ? in_mm(taxel_arrow_length(*views[0].model), 1) + " long" : "no unit"});
  if (marks.rings > 0 && input.overlays.receptive_fields)
    rows.push_back({Glyph::line, color, "Receptive fields", "true size, mm"});
  if (input.ghosts && input.frame) rows.push_back({Glyph::line, kGhostColor, "Fields of layout B", "true size, mm"});
  if (marks.samples > 0) rows.push_back({Glyph::dot, color, "Samples", grouped(marks.samples)});
  if (input.overlays.sample_normals) rows.push_back({Glyph::line, color, "Normals of samples", "no unit"});
}

void add_scene_rows(const SceneInput& input, const Look& look, MarkRows& rows) {
  if (const std::vector<dvec3> path = drawn_path(input); path.size() > 1)
    rows.push_back({Glyph::line, look.path, "Path of the finger", in_mm(length_of(path), 1)});
  if (!input.measure_points.empty())
    rows.push_back({Glyph::line, look.measure, "Measured distance",
                    input.measured ? in_mm(length_of(input.measured->path)) : "mm"});
  if (!input.frame) return;
  if (input.frame->perturbed) rows.push_back({Glyph::arrow, look.hand, "Pull on the body", "true length, mm"});
  if (!input.overlays.constraints) return;
  const std::vector<ConstraintPoints>& points = input.frame->constraint_points;
  const auto has = [&](bool weld) {
    return std::any_of(points.begin(), points.end(), [&](const ConstraintPoints& held) { return held.weld == weld; });
  };
  if (has(true)) rows.push_back({Glyph::line, look.weld, "Weld", "gap, mm"});
  if (has(false)) rows.push_back({Glyph::line, look.connection, "Connection", "gap, mm"});
}

void draw_glyph(ImDrawList& list, const MarkRow& row, ImVec2 middle, float size, const Palette& colors) {
  const ImU32 color = to_u32({row.color.x, row.color.y, row.color.z, 1}), rim = to_u32(colors.dim);
  const float half = 0.5f * size;
  switch (row.glyph) {
    case Glyph::arrow:
      list.AddLine({middle.x - half, middle.y + 0.5f * half}, {middle.x + 0.4f * half, middle.y - 0.2f * half}, rim, 4);
      list.AddLine({middle.x - half, middle.y + 0.5f * half}, {middle.x + 0.4f * half, middle.y - 0.2f * half}, color,
                   2.5f);
      list.AddTriangleFilled({middle.x + half, middle.y - 0.5f * half}, {middle.x, middle.y - 0.6f * half},
                             {middle.x + 0.4f * half, middle.y + 0.4f * half}, color);
      break;
    case Glyph::line:
      list.AddLine({middle.x - half, middle.y}, {middle.x + half, middle.y}, rim, 4);
      list.AddLine({middle.x - half, middle.y}, {middle.x + half, middle.y}, color, 2.5f);
      break;
    case Glyph::dot:
      list.AddCircleFilled(middle, 0.35f * half, color);
      list.AddCircle(middle, 0.35f * half + 1, rim);
      break;
    case Glyph::disc:
      list.AddCircleFilled(middle, 0.8f * half, color);
      list.AddCircle(middle, 0.8f * half, rim);
      break;
  }
}

}  // namespace

std::vector<MarkRow> mark_rows(const SceneInput& input, const FieldNumbers& numbers, const ReadingUnit& unit) {
  const std::vector<SensorView> views = sensor_views(input);
  const Look& colors = look(input.dark);
  MarkRows rows;
  add_contact_rows(input, views, colors, rows);
  add_taxel_rows(input, numbers, views, unit, rows);
  add_scene_rows(input, colors, rows);
  return rows;
}

void draw_mark_legend(WindowUi& ui, const ViewPlace& place, const std::vector<MarkRow>& rows, float top) {
  constexpr float kMaxWidth = 0.45f, kMaxHeight = 0.6f;  // largest part of the view that the legend may cover
  if (rows.empty()) return;
  const Palette& colors = palette(ui.dark);
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  const float line = ImGui::GetFontSize(), pad = 0.5f * line, step = 1.25f * line, glyph = 1.6f * line;
  const auto wide = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
  float name = 0, value = 0;
  for (const MarkRow& row : rows) {
    name = std::max(name, wide(row.name));
    value = std::max(value, wide(row.value));
  }
  const ImVec2 corner(std::floor(place.rect.x0 + place.strip + 0.9f * line), std::floor(top));
  const ImVec2 size(glyph + name + line + value + 2 * pad, step * static_cast<float>(rows.size()) + pad);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto text = [&](ImVec2 at, const ImVec4& color, const std::string& words) {
    list.AddText(at, to_u32(color), words.c_str());
    ui.widgets.note("Marks", words, {at.x, at.y, at.x + wide(words), at.y + line});
  };
  const ImVec2 folded(corner.x + wide(kFolded) + 2 * pad, corner.y + step + pad);
  const bool fits = size.x <= kMaxWidth * place.rect.width() && size.y <= kMaxHeight * place.rect.height();
  if (!fits && !ImGui::IsMouseHoveringRect(corner, folded)) {
    list.AddRectFilled(corner, folded, to_u32(colors.panel, kLegendPlate), 3);
    text({corner.x + pad, corner.y + 0.5f * pad}, colors.text, kFolded);
  } else {
    list.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, to_u32(colors.panel, kLegendPlate), 3);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const ImVec2 at(corner.x + pad, std::round(corner.y + 0.5f * pad + step * static_cast<float>(i)));
      draw_glyph(list, rows[i], {at.x + 0.5f * line, at.y + 0.5f * line}, line, colors);
      text({at.x + glyph, at.y}, colors.text, rows[i].name);
      text({corner.x + size.x - pad - wide(rows[i].value), at.y}, colors.dim, rows[i].value);
    }
  }
  ImGui::PopFont();
}

}  // namespace taxel::ui
