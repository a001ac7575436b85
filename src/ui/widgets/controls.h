// ImGui's basic widgets, each recorded in the registry under its label, a few widgets of our own, and a flow layout.
#pragma once

#include <imgui.h>

#include <string>

#include "core/run/controls.h"
#include "ui/widgets/ui.h"

namespace taxel::ui {

/// Begins the window of a panel and records its tab. ImGui::End() must follow, whatever the function returns.
bool begin_panel(Ui& ui, const char* title, bool* open, ImGuiWindowFlags flags = 0);

/// Sets the place of the next window: in the middle below the bars. Its size is given in heights of text, and limited
/// by the available room.
void place_dialog(float width, float height);

// Widgets return true if the user activates them in this frame. The "##id" part of a label is only an id for ImGui.
bool button(Ui& ui, const char* label, const ImVec2& size = ImVec2(0, 0));
bool checkbox(Ui& ui, const char* label, bool* value);
bool menu_item(Ui& ui, const char* label, const std::string& shortcut, bool checked, bool enabled = true);
bool begin_menu(Ui& ui, const char* label);  ///< begins a menu; ImGui::EndMenu() must follow if it returns true
bool selectable(Ui& ui, const char* label, bool selected, ImGuiSelectableFlags flags = 0);
bool header(Ui& ui, const char* label);                                ///< collapsing header, initially open
bool small_choice(Ui& ui, const char* label, bool chosen);             ///< one of several exclusive buttons
bool toggle(Ui& ui, const char* label, bool on, const char* tooltip);  ///< button with two states

enum class Icon { run, pause, step, reset, step_back, backwards, record };
/// Draws a button with an icon and, if `label` is not empty, text next to it. `fill` is its colour, or null for a plain
/// button.
bool icon_button(Ui& ui, const char* label, Icon icon, const ImVec2& size, const ImVec4* fill, const char* tooltip);

/// Begins a table with a column of names and a column of values. Returns false if the table is not visible; otherwise
/// end_properties() must follow.
bool begin_properties(const char* id);
void end_properties();
void property(const char* name, const std::string& value);
void property(const char* name, const std::string& value, const ImVec4& color);
/// Begins a row whose value the caller draws. `tip` is the tooltip: meaning, unit and origin of the value.
void begin_property(const char* name, const std::string& tip = "");
/// Draws a row with a field, and returns true if the user changes the value. Displays value * shown_per_si; the value
/// itself is in SI.
bool property_field(Ui& ui, const char* name, double* value, double shown_per_si, const char* format, double lo,
                    double hi);

/// Draws a row with a slider that is recorded as `noted`, with its value at its right, and returns true if the user
/// moves it. Displays value * shown_per_si.
bool property_slider(Ui& ui, const std::string& name, const std::string& noted, double* value, double shown_per_si,
                     const char* format, const ControlRange& range);

/// Draws a bar of a fraction, and the percentage to the right of the bar, so that no text crosses the end of the bar.
/// Both together are `width` pixels wide; 0 or less leaves -`width` pixels of the row. A negative fraction animates a
/// bar of unknown length without a percentage. The bar is recorded as "Progress".
void progress_bar(Ui& ui, float fraction, float width);

void tooltip(const std::string& text);  ///< shows a tooltip while the last item is hovered
/// Draws small dim text.
void caption(const char* text);

/// Flow layout of the current ImGui window: places items side by side and starts a new row if the window is too narrow,
/// so nothing is cut off.
class Flow {
 public:
  explicit Flow(float gap);  ///< `gap` is the distance between items [pixels]

  /// Moves the cursor to the place of the next item, which is `width` pixels wide: in this row, or in a new one.
  void next(float width) { place(width, gap_); }
  void next(float width, float gap) { place(width, gap); }
  /// Moves the cursor to the place of the last item, at the right end of the row. The row is chosen so that it has room
  /// for `most`, the largest width that the item may have.
  void last(float width, float most = 0);
  [[nodiscard]] int rows() const { return rows_; }

 private:
  void place(float width, float gap);
  float gap_, right_;
  int rows_ = 0;
};

}  // namespace taxel::ui
