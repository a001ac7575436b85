// The section view of the paper's Figure 1: skin, object, contact surface, receptive field and rays in a plane.
#include "app/studio/nouns/section/section_state.h"

#include <fmt/format.h>
#include <imgui.h>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "ui/scene/color_map.h"
#include "ui/scene/passes/look.h"
#include "ui/scene/section.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {
namespace {

constexpr float kLeastStep = 0.5f;  // [pixel]
constexpr float kContactWidth = 4.0f, kOutlineWidth = 1.5f, kRayWidth = 1.0f;
constexpr double kZoomPerNotch = 1.15, kMostZoom = 50, kLeastZoom = 0.2;
/// No drawn part of a contact piece spans more than one of these steps of the colour map.
constexpr int kColorSteps = 64;
constexpr int kMostParts = 16;

/// The section on the screen: equal scale both ways, y upward.
struct Canvas {
  ImDrawList& list;
  ImVec2 corner, size;
  dvec2 middle;   // middle of the view, in the section's plane [m]
  double pixels;  // pixels per metre
  const SceneInput& input;

  [[nodiscard]] ImVec2 at(const dvec2& p) const {
    return {corner.x + 0.5f * size.x + static_cast<float>(pixels * (p.x - middle.x)),
            corner.y + 0.5f * size.y - static_cast<float>(pixels * (p.y - middle.y))};
  }
  [[nodiscard]] ImU32 pressure_color(double pressure) const {
    const glm::vec3 c = input.range.color(pressure);
    return to_u32({c.x, c.y, c.z, 1});
  }
};

ImU32 color(const glm::vec3& rgb, float alpha) {
  return to_u32({rgb.x, rgb.y, rgb.z, alpha});
}
ImU32 color(const glm::vec4& rgba, float alpha) {
  return to_u32({rgba.x, rgba.y, rgba.z, rgba.w * alpha});
}

/// Draws outlines, filled with `fill`. Cavities have the colour `hole`.
void draw_outlines(const Canvas& canvas, const std::vector<Section::Outline>& outlines, ImU32 fill, ImU32 hole,
                   ImU32 line) {
  std::vector<ImVec2> points;
  for (const Section::Outline& outline : outlines) {
    points.clear();
    for (const dvec2& p : outline.points) {  // slivers break ImGui's triangulation
      const ImVec2 at = canvas.at(p);
      if (points.empty() || std::hypot(at.x - points.back().x, at.y - points.back().y) > kLeastStep)
        points.push_back(at);
    }
    const int count = static_cast<int>(points.size());
    if (count < 2) continue;
    if (outline.area > 0) std::reverse(points.begin(), points.end());  // ImGui fills clockwise polygons
    if (outline.closed && count > 2)
      canvas.list.AddConcavePolyFilled(points.data(), count, outline.area > 0 ? fill : hole);
    canvas.list.AddPolyline(points.data(), count, line, kOutlineWidth, outline.closed ? ImDrawFlags_Closed : 0);
  }
}

void draw_contact(const Canvas& canvas, const Section& section) {
  const double step = (canvas.input.range.hi - canvas.input.range.lo) / kColorSteps;
  for (const Section::ContactPiece& piece : section.contact) {
    const double change = std::abs(piece.pressure_b - piece.pressure_a);
    const int parts = step > 0 ? std::clamp(static_cast<int>(change / step) + 1, 1, kMostParts) : 1;
    for (int i = 0; i < parts; ++i) {
      const double s = static_cast<double>(i) / parts, t = static_cast<double>(i + 1) / parts;
      const double pressure = glm::mix(piece.pressure_a, piece.pressure_b, 0.5 * (s + t));
      canvas.list.AddLine(canvas.at(glm::mix(piece.a, piece.b, s)), canvas.at(glm::mix(piece.a, piece.b, t)),
                          canvas.pressure_color(pressure), kContactWidth);
    }
  }
}

void draw_rays(const Canvas& canvas, const Section& section, const Look& look) {
  for (const Section::RayPiece& ray : section.rays) {
    canvas.list.AddLine(canvas.at(ray.from), canvas.at(ray.to), color(ray.hit ? look.ray_hit : look.ray_miss, 1),
                        kRayWidth);
  }
  const float radius = std::clamp(static_cast<float>(0.4 * section.spacing * canvas.pixels), 0.8f, 2.2f);
  for (const Section::SamplePoint& sample : section.samples) {
    const ImU32 c = sample.color < 0 ? color(look.unused_sample, 1) : color(taxel_color(sample.color), 1);
    canvas.list.AddCircleFilled(canvas.at(sample.at), sample.color < 0 ? 0.6f * radius : radius, c);
  }
}

void draw_dots(const Canvas& canvas, const Section& section, const Look& look) {
  const float radius = std::clamp(static_cast<float>(0.5 * section.spacing * canvas.pixels), 1.0f, 2.4f);
  for (const Section::RayPiece& ray : section.rays) {
    if (!ray.hit) continue;
    canvas.list.AddCircleFilled(canvas.at(ray.to), 1.3f * radius, color(look.mark_outline, 0.6f));
    canvas.list.AddCircleFilled(canvas.at(ray.to), radius, canvas.pressure_color(ray.pressure));
  }
}

void draw_taxel(const Canvas& canvas, const Section& section, const Look& look) {
  if (section.taxel < 0) return;
  const glm::vec3 own = taxel_color(section.color);
  const ImVec2 center = canvas.at(section.center);
  const auto radius = static_cast<float>(canvas.pixels * section.radius);
  canvas.list.AddCircleFilled(center, radius, color(own, 0.07f), 96);
  canvas.list.AddCircle(center, radius, color(own, 0.9f), 96, kOutlineWidth);
  const dvec2 n = glm::length(section.normal) > 0 ? glm::normalize(section.normal) : dvec2(0, 1), side(-n.y, n.x);
  const double length = 0.55 * section.radius, head = 9 / canvas.pixels;
  const dvec2 tip = section.center + length * n;
  canvas.list.AddLine(center, canvas.at(tip - 0.8 * head * n), color(own, 1), 2.5f);
  canvas.list.AddTriangleFilled(canvas.at(tip), canvas.at(tip - head * n + 0.45 * head * side),
                                canvas.at(tip - head * n - 0.45 * head * side), color(own, 1));
  canvas.list.AddCircleFilled(center, 6.0f, color(look.mark_outline, 1));
  canvas.list.AddCircleFilled(center, 4.6f, color(own, 1));
}

/// Draws a scale bar of a round length, about a fifth of the width.
void draw_scale(const Canvas& canvas, const Palette& colors) {
  const double wish = 0.2 * canvas.size.x / canvas.pixels, decade = std::pow(10.0, std::floor(std::log10(wish)));
  const double length = decade * (wish / decade >= 5 ? 5 : wish / decade >= 2 ? 2 : 1);
  const float line = ImGui::GetTextLineHeight();
  const ImVec2 b(canvas.corner.x + canvas.size.x - 0.7f * line, canvas.corner.y + canvas.size.y - 0.7f * line);
  const ImVec2 a(b.x - static_cast<float>(length * canvas.pixels), b.y);
  const ImU32 ink = to_u32(colors.dim);
  canvas.list.AddLine(a, b, ink, 1.5f);
  for (const ImVec2& end : {a, b}) canvas.list.AddLine({end.x, end.y - 3}, {end.x, end.y + 3}, ink, 1.5f);
  const std::string text = fmt::format("{:g} mm", 1000 * length);
  const float width = ImGui::CalcTextSize(text.c_str()).x;
  canvas.list.AddText({0.5f * (a.x + b.x) - 0.5f * width, a.y - 1.25f * line}, ink, text.c_str());
}

/// Handles wheel, drag and double click. `pixels` is the number of pixels per metre.
void handle_mouse(SectionState& state, double pixels) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemHovered() && io.MouseWheel != 0) {
    state.zoom = std::clamp(state.zoom * std::pow(kZoomPerNotch, io.MouseWheel), kLeastZoom, kMostZoom);
  }
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0)) {
    state.pan += dvec2(-io.MouseDelta.x, io.MouseDelta.y) / pixels;
  }
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    state.zoom = 1;
    state.pan = dvec2(0);
  }
}

void draw_section(const Canvas& canvas, const Section& section) {
  const Look& ink = look(canvas.input.dark);
  const Palette& colors = palette(canvas.input.dark);
  canvas.list.PushClipRect(canvas.corner, {canvas.corner.x + canvas.size.x, canvas.corner.y + canvas.size.y}, true);
  draw_outlines(canvas, section.objects, to_u32(colors.dim, 0.22f), to_u32(colors.panel), to_u32(colors.dim));
  for (std::size_t i = 1; canvas.input.overlays.path && i < section.path.size(); ++i) {
    canvas.list.AddLine(canvas.at(section.path[i - 1]), canvas.at(section.path[i]), color(ink.path, 0.9f), 1.5f);
  }
  draw_outlines(canvas, section.skin, color(ink.skin_fill, 1), to_u32(colors.panel), color(ink.skin_outline, 1));
  if (canvas.input.overlays.rays) draw_rays(canvas, section, ink);
  draw_contact(canvas, section);
  if (canvas.input.overlays.rays) draw_dots(canvas, section, ink);
  draw_taxel(canvas, section, ink);
  draw_scale(canvas, colors);
  const float line = ImGui::GetTextLineHeight();
  const ImVec2 at(canvas.corner.x + 0.5f * line, canvas.corner.y + 0.4f * line);
  const ImVec2 extent = ImGui::CalcTextSize(section.title.c_str());
  canvas.list.AddRectFilled({at.x - 4, at.y - 2}, {at.x + extent.x + 4, at.y + extent.y + 2},
                            to_u32(colors.panel, 0.8f), 3);
  canvas.list.AddText(at, to_u32(colors.dim), section.title.c_str());
  canvas.list.PopClipRect();
}

}  // namespace

void section_panel(const SceneInput& input, SectionState& state) {
  const ImVec2 corner = ImGui::GetCursorScreenPos(), size = ImGui::GetContentRegionAvail();
  if (size.x < 1 || size.y < 1) return;
  ImGui::InvisibleButton("##section", size);
  const SensorView* chosen = nullptr;
  const std::vector<SensorView> views = sensor_views(input);
  for (const SensorView& view : views) {
    if (view.index == input.selected_sensor) chosen = &view;
  }
  if (chosen == nullptr) {
    const char* text = "No sensor";
    const ImVec2 extent = ImGui::CalcTextSize(text);
    ImGui::GetWindowDrawList()->AddText({corner.x + 0.5f * (size.x - extent.x), corner.y + 0.5f * (size.y - extent.y)},
                                        to_u32(palette(input.dark).dim), text);
    return;
  }
  const Section section = make_section(input, *chosen, state.slab);
  const double pixels = 0.5 * std::min(size.x, size.y) / section.size * state.zoom;
  handle_mouse(state, pixels);
  draw_section({*ImGui::GetWindowDrawList(), corner, size, section.focus + state.pan, pixels, input}, section);
}

constinit const Feature kSection{
    .title = "Section",
    .dock = Dock::bottom,
    .opens = Opens::by_user,
    .open = true,
    .key = "panel_section",
    .label = "Section",
    .of_readings = true,
    .draw =
        [](App& app) {
          if (begin_panel(*app.ui, kSection.title, &app.get<PanelsShown>()[kSection]))
            section_panel(scene_input(app), app.get<SectionState>());
          ImGui::End();
        },
    .guide = "Press a probe",
};

}  // namespace taxel::ui
