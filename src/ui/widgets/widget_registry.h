// Where each labelled widget stood in the last frame, so that scripts and tests can point at "Run" instead of a pixel.
#pragma once

#include <string>
#include <string_view>
#include <vector>

struct ImGuiWindow;

namespace taxel::ui {

/// Pixels of the window, from its top left corner.
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
    bool field = false;  ///< something is typed or chosen in it
  };

  void begin_frame() { entries_.clear(); }
  void note(std::string_view panel, std::string_view label, const Rect& rect, bool field = false);
  /// Notes ImGui's last item under `label` where any of it is visible.
  void note_item(std::string_view label, bool field = false);

  /// "Run", or "Toolbar/Run" where a label stands in several panels. The one drawn last, hence on top; null: not
  /// visible.
  [[nodiscard]] const Entry* find(std::string_view name) const;
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }

 private:
  std::vector<Entry> entries_;
};

/// Title of the panel that a window, or the child window of one, belongs to: without ImGui's id part.
std::string panel_name(const ImGuiWindow* window);

}  // namespace taxel::ui
