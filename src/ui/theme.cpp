#include "ui/theme.h"

#include <implot.h>

#include <algorithm>

#include "ui/scene/passes/look.h"

namespace taxel::ui {
namespace {

// Rows of the matrices of Machado, Oliveira and Fernandes (2009) for linear RGB at severity 1.
const glm::mat3 kProtanopia = glm::transpose(glm::mat3(0.152286f, 1.052583f, -0.204868f,  //
                                                       0.114503f, 0.786281f, 0.099216f,   //
                                                       -0.003882f, -0.048116f, 1.051998f));
const glm::mat3 kDeuteranopia = glm::transpose(glm::mat3(0.367322f, 0.860646f, -0.227968f,  //
                                                         0.280085f, 0.672501f, 0.047413f,   //
                                                         -0.011820f, 0.042940f, 0.968881f));

/// Returns the relative luminance of an sRGB colour, 0 to 1 (WCAG 2.2).
double luminance(const glm::vec3& srgb) {
  const glm::dvec3 linear(linear_from_srgb(srgb));
  return 0.2126 * linear.r + 0.7152 * linear.g + 0.0722 * linear.b;
}

}  // namespace

glm::vec3 as_seen(const glm::vec3& srgb, Sight sight) {
  if (sight == Sight::usual) return srgb;
  const glm::mat3& cones = sight == Sight::protanopia ? kProtanopia : kDeuteranopia;
  return srgb_from_linear(glm::clamp(cones * linear_from_srgb(srgb), 0.0f, 1.0f));
}

double contrast(const glm::vec3& a, const glm::vec3& b) {
  constexpr double kFlare = 0.05;  // light that every screen reflects
  const double first = luminance(a), second = luminance(b);
  return (std::max(first, second) + kFlare) / (std::min(first, second) + kFlare);
}

double least_contrast(const glm::vec3& a, const glm::vec3& b) {
  double least = contrast(a, b);
  for (const Sight sight : {Sight::protanopia, Sight::deuteranopia})
    least = std::min(least, contrast(as_seen(a, sight), as_seen(b, sight)));
  return least;
}

glm::vec3 with_contrast(const glm::vec3& color, const glm::vec3& background, double least) {
  constexpr int kSteps = 32;
  const glm::vec3 end = ink_on(background);
  for (int i = 0; i < kSteps; ++i) {
    const glm::vec3 mixed = glm::mix(color, end, static_cast<float>(i) / kSteps);
    if (least_contrast(mixed, background) >= least) return mixed;
  }
  return end;
}

glm::vec3 ink_on(const glm::vec3& background) {
  const glm::vec3 black(0), white(1);
  return contrast(black, background) > contrast(white, background) ? black : white;
}

namespace {

constexpr ImVec4 rgb(unsigned hex, float alpha = 1.0f) {
  return {static_cast<float>((hex >> 16) & 255u) / 255.0f, static_cast<float>((hex >> 8) & 255u) / 255.0f,
          static_cast<float>(hex & 255u) / 255.0f, alpha};
}

constexpr Palette kDark{.background = rgb(0x15181c),
                        .panel = rgb(0x1c2026),
                        .raised = rgb(0x2a3038),
                        .field = rgb(0x252a32),
                        .line = rgb(0x363d47),
                        .text = rgb(0xe3e7ec),
                        .dim = rgb(0x98a2ae),
                        .accent = rgb(0x59a2ea),
                        .run = rgb(0x2f9e58),
                        .pause = rgb(0xe0b13a),
                        .error = rgb(0xec8b89),
                        .warning = rgb(0xe0a13a),
                        .note = rgb(0x5aa9e6),
                        .layout_mode = rgb(0x59a2ea),
                        .simulate_mode = rgb(0x2f9e58),
                        .analyse_mode = rgb(0xa67bd6),
                        .path = rgb(0xe45b53)};

constexpr Palette kLight{.background = rgb(0xdde1e6),
                         .panel = rgb(0xf4f5f7),
                         .raised = rgb(0xdfe4ea),
                         .field = rgb(0xe6eaef),
                         .line = rgb(0xc3cad2),
                         .text = rgb(0x1d232a),
                         .dim = rgb(0x57626d),
                         .accent = rgb(0x1a5ca1),
                         .run = rgb(0x237d44),
                         .pause = rgb(0xd9a521),
                         .error = rgb(0xa52b29),
                         .warning = rgb(0x815400),
                         .note = rgb(0x1a5ca1),
                         .layout_mode = rgb(0x1a5ca1),
                         .simulate_mode = rgb(0x237d44),
                         .analyse_mode = rgb(0x7040a8),
                         .path = rgb(0xcc2a22)};

ImVec4 mix(const ImVec4& a, const ImVec4& b, float t) {
  return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.z + (b.z - a.z) * t, a.w + (b.w - a.w) * t};
}

ImVec4 faded(const ImVec4& color, float alpha) {
  return {color.x, color.y, color.z, alpha};
}

void set_surfaces(const Palette& p, ImVec4* c) {
  c[ImGuiCol_Text] = p.text;
  c[ImGuiCol_TextDisabled] = p.dim;
  c[ImGuiCol_WindowBg] = p.panel;
  c[ImGuiCol_ChildBg] = faded(p.panel, 0);
  c[ImGuiCol_PopupBg] = mix(p.panel, p.raised, 0.35f);
  c[ImGuiCol_Border] = p.line;
  c[ImGuiCol_FrameBg] = p.field;
  c[ImGuiCol_FrameBgHovered] = mix(p.field, p.accent, 0.18f);
  c[ImGuiCol_FrameBgActive] = mix(p.field, p.accent, 0.30f);
  c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = c[ImGuiCol_TitleBgCollapsed] = p.background;
  c[ImGuiCol_MenuBarBg] = p.background;
  c[ImGuiCol_ScrollbarBg] = faded(p.panel, 0);
  c[ImGuiCol_ScrollbarGrab] = p.line;
  c[ImGuiCol_ScrollbarGrabHovered] = mix(p.line, p.text, 0.2f);
  c[ImGuiCol_ScrollbarGrabActive] = mix(p.line, p.text, 0.35f);
  c[ImGuiCol_Separator] = p.line;
  c[ImGuiCol_ResizeGrip] = faded(p.line, 0);
  c[ImGuiCol_DockingEmptyBg] = p.background;
  c[ImGuiCol_TableHeaderBg] = p.field;
  c[ImGuiCol_TableBorderStrong] = c[ImGuiCol_TableBorderLight] = mix(p.panel, p.line, 0.6f);
  c[ImGuiCol_TableRowBg] = faded(p.panel, 0);
  c[ImGuiCol_TableRowBgAlt] = faded(p.text, 0.025f);
  c[ImGuiCol_ModalWindowDimBg] = ImVec4(0, 0, 0, 0.45f);
}

void set_controls(const Palette& p, ImVec4* c) {
  c[ImGuiCol_CheckMark] = c[ImGuiCol_SliderGrab] = p.accent;
  c[ImGuiCol_CheckboxSelectedBg] = p.field;
  c[ImGuiCol_SliderGrabActive] = mix(p.accent, p.text, 0.2f);
  c[ImGuiCol_Button] = p.raised;
  c[ImGuiCol_ButtonHovered] = mix(p.raised, p.accent, 0.30f);
  c[ImGuiCol_ButtonActive] = mix(p.raised, p.accent, 0.55f);
  c[ImGuiCol_Header] = faded(p.accent, 0.28f);
  c[ImGuiCol_HeaderHovered] = faded(p.accent, 0.20f);
  c[ImGuiCol_HeaderActive] = faded(p.accent, 0.38f);
  c[ImGuiCol_SeparatorHovered] = c[ImGuiCol_SeparatorActive] = p.accent;
  c[ImGuiCol_ResizeGripHovered] = c[ImGuiCol_ResizeGripActive] = p.accent;
  c[ImGuiCol_Tab] = c[ImGuiCol_TabDimmed] = p.background;
  c[ImGuiCol_TabHovered] = mix(p.panel, p.accent, 0.25f);
  c[ImGuiCol_TabSelected] = c[ImGuiCol_TabDimmedSelected] = p.panel;
  c[ImGuiCol_TabSelectedOverline] = p.accent;
  c[ImGuiCol_TabDimmedSelectedOverline] = faded(p.accent, 0);
  c[ImGuiCol_DockingPreview] = faded(p.accent, 0.5f);
  c[ImGuiCol_TextLink] = p.accent;
  c[ImGuiCol_TextSelectedBg] = faded(p.accent, 0.4f);
  c[ImGuiCol_InputTextCursor] = p.text;
  c[ImGuiCol_NavCursor] = p.accent;
  c[ImGuiCol_DragDropTarget] = p.accent;
}

void set_spacing(ImGuiStyle& style, float scale) {
  style.FontSizeBase = kTextHeight;
  style.WindowPadding = ImVec2(10, 8);
  style.FramePadding = ImVec2(8, 4);
  style.ItemSpacing = ImVec2(8, 5);
  style.ItemInnerSpacing = ImVec2(6, 4);
  style.CellPadding = ImVec2(6, 2);
  style.IndentSpacing = 16;
  style.ScrollbarSize = 11;
  style.WindowRounding = style.PopupRounding = 5;
  style.FrameRounding = style.GrabRounding = style.ChildRounding = 4;
  style.TabRounding = 4;
  style.ScrollbarRounding = 6;
  style.WindowBorderSize = style.PopupBorderSize = 1;
  style.FrameBorderSize = style.TabBorderSize = 0;
  style.TabBarBorderSize = 0;
  style.TabBarOverlineSize = 2;
  style.DockingSeparatorSize = 3;
  style.DockingNodeHasCloseButton = false;
  style.WindowMenuButtonPosition = ImGuiDir_None;
  style.WindowTitleAlign = ImVec2(0.0f, 0.5f);
  style.ScaleAllSizes(scale);
  style.FontScaleMain = scale;
}

void set_plot_style(const Palette& p, float scale) {
  ImPlotStyle& style = ImPlot::GetStyle();
  style = ImPlotStyle();
  style.Colors[ImPlotCol_FrameBg] = faded(p.panel, 0);
  style.Colors[ImPlotCol_PlotBg] = p.background;
  style.Colors[ImPlotCol_PlotBorder] = p.line;
  style.Colors[ImPlotCol_LegendBg] = faded(p.panel, 0);
  style.Colors[ImPlotCol_LegendBorder] = faded(p.panel, 0);
  style.Colors[ImPlotCol_LegendText] = style.Colors[ImPlotCol_TitleText] = style.Colors[ImPlotCol_InlayText] = p.text;
  style.Colors[ImPlotCol_AxisText] = p.dim;
  style.Colors[ImPlotCol_AxisGrid] = p.line;
  style.Colors[ImPlotCol_AxisTick] = p.line;
  style.PlotPadding = ImVec2(6 * scale, 6 * scale);
  style.LabelPadding = ImVec2(4 * scale, 3 * scale);
  style.LegendInnerPadding = ImVec2(4 * scale, 2 * scale);
  style.LegendPadding = ImVec2(6 * scale, 6 * scale);
  style.MajorTickLen = style.MinorTickLen = ImVec2(0, 0);
  style.PlotMinSize = ImVec2(80 * scale, 60 * scale);
  style.MinorAlpha = 0;
}

}  // namespace

const Palette& palette(bool dark) {
  return dark ? kDark : kLight;
}

void apply_theme(bool dark, float scale) {
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  if (dark) {
    ImGui::StyleColorsDark(&style);
  } else {
    ImGui::StyleColorsLight(&style);
  }
  set_surfaces(palette(dark), style.Colors);
  set_controls(palette(dark), style.Colors);
  set_spacing(style, scale);
  set_plot_style(palette(dark), scale);
}

ImVec4 text_on(const ImVec4& fill) {
  const glm::vec3 ink = ink_on({fill.x, fill.y, fill.z});
  return {ink.x, ink.y, ink.z, 1};
}

ImU32 to_u32(const ImVec4& color, float alpha) {
  return ImGui::ColorConvertFloat4ToU32(faded(color, color.w * alpha));
}

const ImVec4& severity_color(const Palette& colors, Severity severity) {
  switch (severity) {
    case Severity::error:
      return colors.error;
    case Severity::warning:
      return colors.warning;
    case Severity::note:
      break;
  }
  return colors.note;
}

}  // namespace taxel::ui
