// The state that every widget of the interface needs: the labelled widgets of the last frame, the input in fields, and
// whether a key press belongs to a widget or to the table of key bindings.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

struct ImGuiWindow;

namespace taxel::ui {

/// Input of the user in one field.
struct FieldInput {
  std::string field;  ///< name of the field in the registry of widgets
  std::string typed;  ///< typed text; empty for a choice
};

/// Typed text that is not valid. The field keeps the text and displays the reason, and the document does not change.
struct Refusal {
  FieldInput input;
  std::string words;           ///< reason, displayed below the field
  std::vector<int> selection;  ///< ids of the taxels that were being edited
};

/// State of all fields.
struct FieldState {
  FieldInput last;                 ///< last accepted input
  std::vector<int> selection;      ///< ids of the taxels that the fields edit
  std::optional<Refusal> refused;  ///< last refused input
  bool in_menus = false;           ///< whether the menu bar has the keyboard
  bool had_keys = false;           ///< a field, a popup or the menu bar had the keyboard at the end of the last frame
  int popups = 0;                  ///< number of popups that were open at the end of the last frame
  std::string keyboard_panel;      ///< title of the panel with keyboard navigation; empty if there is none
  std::string entered_panel;       ///< title of the panel that gets keyboard navigation in the next frame
  int entering = 0;                ///< frames until that panel has the keyboard
};

/// Rectangle in pixels of the window, from its top left corner.
struct Rect {
  float x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  [[nodiscard]] float width() const { return x1 - x0; }
  [[nodiscard]] float height() const { return y1 - y0; }
  [[nodiscard]] float center_x() const { return 0.5f * (x0 + x1); }
  [[nodiscard]] float center_y() const { return 0.5f * (y0 + y1); }
  [[nodiscard]] bool empty() const { return x1 <= x0 || y1 <= y0; }
};

/// A widget that is scrolled into view and gets the keyboard as soon as it is drawn.
struct SoughtWidget {
  std::string panel;    ///< title of its panel
  std::string section;  ///< header above the widget, which opens; empty if there is none
  std::string label;    ///< label in the registry
  std::string instead;  ///< label of the widget to focus if the first is not drawn, or empty
  int frames = 0;       ///< frames until the search for the label ends
};

/// The labelled widgets of the last frame and their places. Scripts and tests use it to click "Run" instead of a pixel.
class WidgetRegistry {
 public:
  struct Entry {
    std::string panel, label;
    Rect rect;
    bool field = false;  ///< true for a field in which the user types or chooses a value
  };

  /// Also ends a search for a widget that was not drawn.
  void begin_frame();
  void note(std::string_view panel, std::string_view label, const Rect& rect, bool field = false);
  /// Records ImGui's last item under `label` if any part of the item is visible.
  void note_item(std::string_view label, bool field = false);

  /// Returns the widget with a label such as "Run", or "Toolbar/Run" if several panels have the label. If there are
  /// several, returns the one drawn last, which is on top. Returns null if no such widget is visible.
  [[nodiscard]] const Entry* find(std::string_view name) const;
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }

  /// Records that the content of a panel is visible.
  void note_panel(std::string_view panel) { panels_.emplace_back(panel); }
  /// Returns whether the content of a panel is visible in this frame, or was in the last one.
  [[nodiscard]] bool shows_panel(std::string_view panel) const;

  /// Begins the search for a widget. Its panel comes to the front and its section opens until the widget is drawn.
  void seek(SoughtWidget widget);
  /// Returns whether a widget of the panel is sought.
  [[nodiscard]] bool seeks_in(std::string_view panel) const { return !sought_.label.empty() && sought_.panel == panel; }
  /// Returns whether a widget below this header of the panel is sought.
  [[nodiscard]] bool seeks_below(std::string_view panel, std::string_view header) const {
    return seeks_in(panel) && !sought_.section.empty() && header.starts_with(sought_.section);
  }

 private:
  /// Gives the keyboard to ImGui's last item if it is the sought widget.
  void focus_if_sought(std::string_view label);

  std::vector<Entry> entries_;
  std::vector<std::string> panels_, panels_before_;  ///< visible panels of this frame and of the last one
  SoughtWidget sought_;
};

/// Returns the title, without ImGui's id part, of the panel to which a window or child window belongs.
std::string panel_name(const ImGuiWindow* window);

/// State of the widgets, passed to every function that draws one.
struct Ui {
  WidgetRegistry widgets;
  FieldState fields;
  bool dark = true;                 ///< theme of this frame
  double pixel_scale = 1;           ///< scale of the interface: the user's scale times the screen's
  std::vector<const bool*> opened;  ///< open flags of the panels that get to the front when they are drawn next

  std::vector<const char*> fixed;  ///< titles of the panels that have no button to close them

  /// Brings a panel to the front when it is drawn next, by its open flag. A closed panel is opened.
  void open_in_front(bool& open);
};

/// Records at the end of a frame which widget has the keyboard, because ImGui closes popups and leaves fields before
/// the next frame can inspect them. `selection` has the ids of the selected taxels; a change of the selection clears a
/// refused input.
void record_keyboard(Ui& ui, const std::vector<int>& selection);

/// Returns true if keyboard navigation in a panel uses this key. The key then has no effect in the table of bindings.
bool widgets_take(const Ui& ui, int chord);

/// Returns whether a modal dialog is open: the user can do nothing else.
[[nodiscard]] bool is_modal_open();
/// Returns whether Esc leaves the modal dialog that is being drawn. While a list of the dialog is open, Esc closes the
/// list and leaves the dialog open. To be called after the lists were drawn.
[[nodiscard]] bool escapes_dialog(const Ui& ui);

/// Starts keyboard navigation in a panel, at its first widget. Esc ends it.
void enter_panel(Ui& ui, const char* title);
/// Keeps keyboard navigation in a panel until ImGui has carried out a request for the focus.
void keep_keyboard(Ui& ui, std::string_view panel);
/// Completes enter_panel(). Called by begin_panel().
void focus_if_entered(Ui& ui, const char* title);

}  // namespace taxel::ui
