// Fills the window with what the interface laid out. A software renderer takes longer for a whole window than for the
// 3-D view in it: there, only what changed since the last picture is drawn anew.
#pragma once

#include <imgui.h>

#include <optional>
#include <vector>

#include "app/studio/shell/window/window.h"
#include "ui/gl/back_buffer.h"

namespace taxel::studio {

class WindowPainter {
 public:
  /// `whole`: everything, each time.
  explicit WindowPainter(bool whole) : whole_(whole) {}

  /// Draws `data`, which every pixel of the window is the same by as if all of it was drawn. `scene`: a texture whose
  /// content changes, and a number that tells when it did.
  void paint(Window& window, ImDrawData& data, const ImVec4& background, ImTextureID scene, int scene_draws);
  /// The next picture is drawn as a whole.
  void forget() { shown_.clear(); }
  /// Pixels drawn for the last picture.
  [[nodiscard]] long long painted_pixels() const { return painted_; }

 private:
  /// In pixels of the window, y downward.
  struct Area {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    [[nodiscard]] bool empty() const { return x0 >= x1 || y0 >= y1; }
    [[nodiscard]] bool meets(const Area& b) const { return x0 < b.x1 && b.x0 < x1 && y0 < b.y1 && b.y0 < y1; }
    [[nodiscard]] long long pixels() const { return static_cast<long long>(x1 - x0) * (y1 - y0); }
  };
  /// A draw list as it was drawn.
  struct Shown {
    std::vector<ImDrawVert> vertices;
    std::vector<ImDrawIdx> indices;
    std::vector<ImDrawCmd> commands;
    Area bounds;
    [[nodiscard]] bool is(const ImDrawList& list) const;
  };
  static Area bounds_of(const ImDrawList& list, const Area& window);
  static Shown copy_of(const ImDrawList& list, const Area& window);
  static void include(std::vector<Area>& areas, Area area);
  static void paint_area(ImDrawData& data, const Area& area);
  std::vector<Area> changed_areas(const ImDrawData& data, const Area& window, ImTextureID scene, bool scene_changed);

  bool whole_;
  std::optional<gl::BackBuffer> picture_;
  std::vector<Shown> shown_;
  ImVec4 background_;
  int scene_draws_ = -1;
  long long painted_ = 0;
};

}  // namespace taxel::studio
