// ImGui's basic widgets, each noted in the registry under its label; and a few of our own look.
#pragma once

#include <imgui.h>

#include <string>

#include "core/run/controls.h"
#include "ui/widgets/ui.h"

namespace taxel::ui {

/// Opens the window of a panel and notes its tab. Then ImGui::End(), whatever it returns.
bool begin_panel(Ui& ui, const char* title, bool* open, ImGuiWindowFlags flags = 0);

/// Where the next window comes up: in the middle below the bars, of so many heights of text, or as large as there is
/// room.
void place_dialog(float width, float height);

/// The "##id" part of a label is an id for ImGui only.
bool button(Ui& ui, const char* label, const ImVec2& size = ImVec2(0, 0));
bool checkbox(Ui& ui, const char* label, bool* value);
bool menu_item(Ui& ui, const char* label, const std::string& shortcut, bool checked, bool enabled = true);
bool begin_menu(Ui& ui, const char* label);  ///< then ImGui::EndMenu()
bool selectable(Ui& ui, const char* label, bool selected, ImGuiSelectableFlags flags = 0);
bool header(Ui& ui, const char* label);                                ///< collapsing, open at first
bool small_choice(Ui& ui, const char* label, bool chosen);             ///< one of several exclusive buttons
bool toggle(Ui& ui, const char* label, bool on, const char* tooltip);  ///< a button that stays down

enum class Icon { run, pause, step, reset, step_back, backwards, record };
/// A button with a drawn icon and, if not empty, text beside it. `fill`: its colour; null: a plain button.
bool icon_button(Ui& ui, const char* label, Icon icon, const ImVec2& size, const ImVec4* fill, const char* tooltip);

/// Two columns of names and values, as the inspector has them.
bool begin_properties(const char* id);
void end_properties();
void property(const char* name, const std::string& value);
void property(const char* name, const std::string& value, const ImVec4& color);
/// A row whose value is drawn by the caller; `tip`: what it is, in which unit, from where.
void begin_property(const char* name, const std::string& tip = "");
/// A row whose value is a field; true when it was changed. Shown as value * shown_per_si, stored in SI.
bool property_field(Ui& ui, const char* name, double* value, double shown_per_si, const char* format, double lo,
                    double hi);

/// A row whose value is a slider, noted as `noted`; true when it was moved. Shown as value * shown_per_si.
bool property_slider(Ui& ui, const std::string& name, const std::string& noted, double* value, double shown_per_si,
                     const char* format, const ControlRange& range);

void tooltip(const std::string& text);  ///< for the last item, when hovered
/// Small dim text.
void caption(const char* text);

}  // namespace taxel::ui
