// A registry of the labelled widgets of the last frame and their places. Scripts and tests use it to click "Run"
// instead of a pixel.
#pragma once

#include <string>
#include <string_view>
#include <vector>

struct ImGuiWindow;

namespace taxel::ui {

/// Rectangle in pixels of the window, from its top left corner.
struct Rect {
  float x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  [[nodiscard]] float width() const { return x1 - x0; }
  [[nodiscard]] float height() const { return y1 - y0; }
  [[nodiscard]] float center_x() const { return 0.5f * (x0 + x1); }
  [[nodiscard]] float center_y() const { return 0.5f * (y0 + y1); }
  [[nodiscard]] bool empty() const { return x1 <= x0 || y1 <= y0; }
};

class WidgetRegistry {
 public:
  struct Entry {
    std::string panel, label;
    Rect rect;
    bool field = false;  ///< true for a field in which the user types or chooses a value
  };

  void begin_frame() { entries_.clear(); }
  void note(std::string_view panel, std::string_view label, const Rect& rect, bool field = false);
  /// Records ImGui's last item under `label` if any part of the item is visible.
  void note_item(std::string_view label, bool field = false);

  /// Returns the widget with a label such as "Run", or "Toolbar/Run" if several panels have the label. If there are
  /// several, returns the one drawn last, which is on top. Returns null if no such widget is visible.
  [[nodiscard]] const Entry* find(std::string_view name) const;
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }

 private:
  std::vector<Entry> entries_;
};

/// Returns the title, without ImGui's id part, of the panel to which a window or child window belongs.
std::string panel_name(const ImGuiWindow* window);

}  // namespace taxel::ui
