#include "ui/widgets/controls.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "ui/theme.h"
#include "ui/widgets/ui.h"

namespace taxel::ui {
namespace {

/// Draws a button with colours of the caller. ImGui handles hover, focus and activation.
bool colored_button(const char* label, const ImVec2& size, const ImVec4& face, const ImVec4& text) {
  const auto lifted = [&](float t) {
    return ImVec4(face.x + (1 - face.x) * t, face.y + (1 - face.y) * t, face.z + (1 - face.z) * t, 1);
  };
  ImGui::PushStyleColor(ImGuiCol_Button, face);
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, lifted(0.12f));
  ImGui::PushStyleColor(ImGuiCol_ButtonActive, lifted(0.24f));
  ImGui::PushStyleColor(ImGuiCol_Text, text);
  const bool pressed = ImGui::Button(label, size);
  ImGui::PopStyleColor(4);
  return pressed;
}

void draw_icon(ImDrawList& list, Icon icon, ImVec2 c, float r, ImU32 color) {
  switch (icon) {
    case Icon::run:
      list.AddTriangleFilled({c.x - 0.7f * r, c.y - r}, {c.x + r, c.y}, {c.x - 0.7f * r, c.y + r}, color);
      break;
    case Icon::pause:
      list.AddRectFilled({c.x - 0.8f * r, c.y - r}, {c.x - 0.2f * r, c.y + r}, color);
      list.AddRectFilled({c.x + 0.2f * r, c.y - r}, {c.x + 0.8f * r, c.y + r}, color);
      break;
    case Icon::step:
      list.AddTriangleFilled({c.x - 0.9f * r, c.y - r}, {c.x + 0.5f * r, c.y}, {c.x - 0.9f * r, c.y + r}, color);
      list.AddRectFilled({c.x + 0.5f * r, c.y - r}, {c.x + 0.95f * r, c.y + r}, color);
      break;
    case Icon::step_back:
      list.AddTriangleFilled({c.x + 0.9f * r, c.y - r}, {c.x + 0.9f * r, c.y + r}, {c.x - 0.5f * r, c.y}, color);
      list.AddRectFilled({c.x - 0.95f * r, c.y - r}, {c.x - 0.5f * r, c.y + r}, color);
      break;
    case Icon::backwards:
      list.AddTriangleFilled({c.x + 0.7f * r, c.y - r}, {c.x + 0.7f * r, c.y + r}, {c.x - r, c.y}, color);
      break;
    case Icon::record:
      list.AddCircleFilled(c, r, color);
      break;
    case Icon::reset:
      for (const float x : {0.1f, -0.75f})
        list.AddTriangleFilled({c.x + (x + 0.9f) * r, c.y - r}, {c.x + (x + 0.9f) * r, c.y + r}, {c.x + x * r, c.y},
                               color);
      list.AddRectFilled({c.x - r, c.y - r}, {c.x - 0.72f * r, c.y + r}, color);
      break;
  }
}

/// Returns true if a panel is docked in the main window. That window is already cleared to the colour of panels;
/// filling it again would take a software renderer a third of the time of a frame.
bool lies_on_its_color(const char* title) {
  const ImGuiWindow* window = ImGui::FindWindowByName(title);
  return window != nullptr && window->DockNode != nullptr &&
         ImGui::DockNodeGetRootNode(window->DockNode)->IsDockSpace();
}

/// Returns the visible part of a title.
std::string_view shown_part(const char* title) {
  const std::string_view whole(title);
  return whole.substr(0, whole.find("##"));
}

/// Brings the tab of the current panel to the front. The focus alone would do so for only one panel of a frame.
void select_tab() {
  const ImGuiWindow* window = ImGui::GetCurrentWindowRead();
  if (window->DockNode != nullptr && window->DockNode->TabBar != nullptr)
    window->DockNode->TabBar->NextSelectedTabId = window->TabId;
}

/// Records the tab of the current panel as "Title tab", if the panel has a tab.
void note_tab(Ui& ui, const char* title) {
  const ImGuiWindow* window = ImGui::GetCurrentWindowRead();
  if (!window->DockIsActive || window->DockNode->IsNoTabBar() || window->DockNode->IsHiddenTabBar()) return;
  const ImRect& tab = window->DC.DockTabItemRect;
  ui.widgets.note("", std::string(shown_part(title)) + " tab", {tab.Min.x, tab.Min.y, tab.Max.x, tab.Max.y});
}

}  // namespace

bool begin_panel(Ui& ui, const char* title, bool* open, ImGuiWindowFlags flags) {
  if (lies_on_its_color(title)) ImGui::SetNextWindowBgAlpha(0);
  if (ui.widgets.seeks_in(shown_part(title))) keep_keyboard(ui, shown_part(title));
  // Keys belong to the table of bindings: Space plays and arrows step, wherever the last click was. Exceptions are a
  // field with text input and a panel with keyboard navigation, where Tab goes to the next widget.
  if (ui.fields.keyboard_panel != shown_part(title)) flags |= ImGuiWindowFlags_NoNavInputs;
  const bool is_opened = std::erase(ui.opened, open) > 0;
  if (is_opened) ImGui::SetNextWindowFocus();  // a new tab would otherwise be behind another
  const bool is_sought = ui.widgets.seeks_in(shown_part(title));
  // Its tab may be behind another tab.
  if (is_sought || ui.fields.entered_panel == title) ImGui::SetNextWindowFocus();
  const bool is_fixed = std::ranges::any_of(
      ui.fixed, [&](const char* each) { return std::string_view(each) == std::string_view(title); });
  const bool visible = ImGui::Begin(title, is_fixed ? nullptr : open, flags | ImGuiWindowFlags_NoFocusOnAppearing);
  if (is_opened) select_tab();
  ui.widgets.note_item(title);
  note_tab(ui, title);
  if (!visible) return false;
  ui.widgets.note_panel(shown_part(title));
  focus_if_entered(ui, title);
  return true;
}

bool button(Ui& ui, const char* label, const ImVec2& size) {
  const bool pressed = ImGui::Button(label, size);
  ui.widgets.note_item(label);
  return pressed;
}

bool checkbox(Ui& ui, const char* label, bool* value) {
  const bool changed = ImGui::Checkbox(label, value);
  ui.widgets.note_item(label);
  return changed;
}

void place_dialog(float width, float height) {
  constexpr float kMost = 0.95f;  // largest fraction of the available room
  const ImGuiViewport* viewport = ImGui::GetMainViewport();
  const ImVec2 room = viewport->WorkSize;
  const float line = ImGui::GetFontSize();
  ImGui::SetNextWindowSize({std::min(width * line, kMost * room.x), std::min(height * line, kMost * room.y)},
                           ImGuiCond_Appearing);
  ImGui::SetNextWindowPos(viewport->GetWorkCenter(), ImGuiCond_Appearing, ImVec2(0.5f, 0.5f));
}

bool menu_item(Ui& ui, const char* label, const std::string& shortcut, bool checked, bool enabled) {
  const bool chosen = ImGui::MenuItem(label, shortcut.empty() ? nullptr : shortcut.c_str(), checked, enabled);
  ui.widgets.note_item(label);
  return chosen;
}

bool begin_menu(Ui& ui, const char* label) {
  const bool open = ImGui::BeginMenu(label);
  if (!open) ui.widgets.note_item(label);  // while the menu is open, the last item is inside it
  return open;
}

bool selectable(Ui& ui, const char* label, bool selected, ImGuiSelectableFlags flags) {
  const bool chosen = ImGui::Selectable(label, selected, flags);
  ui.widgets.note_item(label);
  return chosen;
}

bool header(Ui& ui, const char* label) {
  if (ui.widgets.seeks_below(panel_name(ImGui::GetCurrentWindowRead()), shown_part(label)))
    ImGui::SetNextItemOpen(true);
  ImGui::PushStyleColor(ImGuiCol_Header, ImGui::GetStyleColorVec4(ImGuiCol_FrameBg));
  const bool open = ImGui::CollapsingHeader(label, ImGuiTreeNodeFlags_DefaultOpen);
  ImGui::PopStyleColor();
  ui.widgets.note_item(label);
  return open;
}

bool small_choice(Ui& ui, const char* label, bool chosen) {
  const Palette& colors = palette(ui.dark);
  const bool pressed =
      chosen ? colored_button(label, ImVec2(0, 0), colors.accent, text_on(colors.accent)) : ImGui::Button(label);
  ui.widgets.note_item(label);
  return pressed;
}

bool toggle(Ui& ui, const char* label, bool on, const char* tooltip_text) {
  const Palette& colors = palette(ui.dark);
  const ImVec4 face = on ? ImGui::GetStyleColorVec4(ImGuiCol_HeaderActive) : colors.panel;
  ImGui::PushStyleColor(ImGuiCol_Button, face);
  ImGui::PushStyleColor(ImGuiCol_Text, on ? colors.text : colors.dim);
  ImGui::PushStyleColor(ImGuiCol_Border, on ? face : colors.dim);
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1);  // a switch that is off has an outline
  const bool pressed = ImGui::Button(label);
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(3);
  ui.widgets.note_item(label);
  tooltip(tooltip_text);
  return pressed;
}

bool icon_button(Ui& ui, const char* label, Icon icon, const ImVec2& size, const ImVec4* fill,
                 const char* tooltip_text) {
  const Palette& colors = palette(ui.dark);
  const std::string name = label;
  const std::string text = name.substr(0, name.find("##"));
  const std::string id = "##" + name;
  const ImVec4 ink = fill != nullptr ? text_on(*fill) : (icon == Icon::record ? colors.error : colors.text);
  const bool pressed = fill != nullptr ? colored_button(id.c_str(), size, *fill, ink) : ImGui::Button(id.c_str(), size);
  const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
  const bool with_text = fill != nullptr && icon != Icon::record;
  const float r = 0.34f * ImGui::GetFontSize();
  const float text_width = with_text ? ImGui::CalcTextSize(text.c_str()).x + 0.6f * ImGui::GetFontSize() : 0.0f;
  const ImVec2 center(0.5f * (lo.x + hi.x) - 0.5f * text_width, 0.5f * (lo.y + hi.y));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_icon(list, icon, center, r, ImGui::GetColorU32(ink));
  if (with_text) {
    const float y = std::round(0.5f * (lo.y + hi.y) - 0.5f * ImGui::GetFontSize());
    list.AddText(ImVec2(std::round(center.x + r + 0.45f * ImGui::GetFontSize()), y), ImGui::GetColorU32(ink),
                 text.c_str());
  }
  ui.widgets.note_item(text);
  tooltip(tooltip_text);
  return pressed;
}

bool begin_properties(const char* id) {
  if (!ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingStretchProp)) return false;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, 0.46f);
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch, 0.54f);
  return true;
}

void end_properties() {
  ImGui::EndTable();
}

void property(const char* name, const std::string& value) {
  property(name, value, ImGui::GetStyleColorVec4(ImGuiCol_Text));
}

void property(const char* name, const std::string& value, const ImVec4& color) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushTextWrapPos(0);
  ImGui::TextDisabled("%s", name);
  ImGui::PopTextWrapPos();
  ImGui::TableNextColumn();
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  const float room = ImGui::GetContentRegionAvail().x;
  const bool fits = ImGui::CalcTextSize(value.c_str()).x <= room;
  if (fits) {
    ImGui::TextUnformatted(value.c_str());
  } else {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(value.c_str());
    ImGui::PopTextWrapPos();
  }
  ImGui::PopStyleColor();
}

void begin_property(const char* name, const std::string& tip) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::PushTextWrapPos(0);
  ImGui::TextDisabled("%s", name);
  ImGui::PopTextWrapPos();
  tooltip(tip);
  ImGui::TableNextColumn();
}

bool property_field(Ui& ui, const char* name, double* value, double shown_per_si, const char* format, double lo,
                    double hi) {
  begin_property(name);
  ImGui::SetNextItemWidth(-1);
  const std::string id = std::string("##") + name;
  auto shown = static_cast<float>(*value * shown_per_si);
  const auto shown_lo = static_cast<float>(lo * shown_per_si), shown_hi = static_cast<float>(hi * shown_per_si);
  const bool changed = ImGui::DragFloat(id.c_str(), &shown, 0.005f * (shown_hi - shown_lo), shown_lo, shown_hi, format,
                                        ImGuiSliderFlags_AlwaysClamp);
  ui.widgets.note_item(name, true);
  if (changed) *value = static_cast<double>(shown) / shown_per_si;
  return changed;
}

namespace {

/// Returns a number in a format of printf().
std::string number_text(const char* format, double number) {
  std::array<char, 64> text{};
  ImFormatString(text.data(), text.size(), format, number);
  return text.data();
}

float text_width(const std::string& text) {
  return ImGui::CalcTextSize(text.c_str()).x;
}

}  // namespace

bool property_slider(Ui& ui, const std::string& name, const std::string& noted, double* value, double shown_per_si,
                     const char* format, const ControlRange& range) {
  begin_property(name.c_str());
  double shown = *value * shown_per_si;
  const double lo = range[0] * shown_per_si, hi = range[1] * shown_per_si;
  const std::string text = number_text(format, shown);
  // The room does not change while the value does.
  const float room =
      std::max({text_width(text), text_width(number_text(format, lo)), text_width(number_text(format, hi))});
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float width = ImGui::GetContentRegionAvail().x - room - gap;
  ImGui::SetNextItemWidth(std::max(3 * ImGui::GetFontSize(), width));
  const std::string label = "##" + noted;
  // ImGui writes the value into the slider, under the knob: only a value that is typed is visible there.
  const bool is_typed = ImGui::TempInputIsActive(ImGui::GetID(label.c_str()));
  if (!is_typed) ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32_BLACK_TRANS);
  const bool changed = ImGui::SliderScalar(label.c_str(), ImGuiDataType_Double, &shown, &lo, &hi, format);
  if (!is_typed) ImGui::PopStyleColor();
  ui.widgets.note_item(noted, true);
  ImGui::SameLine(0, gap);
  ImGui::TextUnformatted(number_text(format, shown).c_str());
  ui.widgets.note_item("Value of " + noted);
  if (changed) *value = shown / shown_per_si;
  return changed;
}

void progress_bar(Ui& ui, float fraction, float width) {
  if (width <= 0) width += ImGui::GetContentRegionAvail().x;
  const float room = fraction < 0 ? 0 : ImGui::CalcTextSize("100 %").x + ImGui::GetStyle().ItemInnerSpacing.x;
  ImGui::ProgressBar(fraction, ImVec2(std::max(1.0f, width - room), 0), "");
  ui.widgets.note_item("Progress");
  if (fraction < 0) return;
  const std::string percent = fmt::format("{:.0f} %", 100 * std::min(1.0f, fraction));
  ImGui::SameLine(0, room - ImGui::CalcTextSize(percent.c_str()).x);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(percent.c_str());
  ui.widgets.note_item(percent);
}

void tooltip(const std::string& text) {
  if (!text.empty() && ImGui::IsItemHovered(ImGuiHoveredFlags_ForTooltip)) ImGui::SetTooltip("%s", text.c_str());
}

void caption(const char* text) {
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  ImGui::PushTextWrapPos();
  ImGui::TextDisabled("%s", text);
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
}

Flow::Flow(float gap) : gap_(gap), right_(ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x) {}

void Flow::place(float width, float gap) {
  if (rows_ == 0) {
    rows_ = 1;
    return;
  }
  ImGui::SameLine(0, gap);
  if (ImGui::GetCursorScreenPos().x + width <= right_ + 0.5f) return;
  ImGui::NewLine();
  ++rows_;
}

void Flow::last(float width, float most) {
  place(std::max(width, most), gap_);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({std::max(at.x, right_ - width), at.y});
}

}  // namespace taxel::ui
