// Fills the window with the interface that was laid out. A software renderer takes longer for a whole window than for
// the 3-D view in it, so it redraws only the regions that have changed since the last frame.
#pragma once

#include <imgui.h>

#include <optional>
#include <vector>

#include "app/studio/shell/window/window.h"
#include "ui/gl/framebuffer.h"

namespace taxel::studio {

class WindowPainter {
 public:
  /// Creates a painter that redraws everything in each frame if `whole` is true.
  explicit WindowPainter(bool whole) : whole_(whole) {}

  /// Draws `data`. Only changed regions are redrawn; the result is identical, pixel for pixel, to a full redraw.
  /// `scene` is a texture whose content changes, and `scene_draws` a number that changes with the content.
  void paint(Window& window, ImDrawData& data, const ImVec4& background, ImTextureID scene, int scene_draws);
  /// Draws nothing, but sends new glyphs to the graphics card, as ImGui expects after each frame.
  static void send_glyphs(ImDrawData& data);
  /// Makes the next frame a full redraw.
  void forget() { shown_.clear(); }
  /// Returns the number of pixels drawn for the last frame.
  [[nodiscard]] long long painted_pixels() const { return painted_; }

 private:
  /// Rectangle in pixels of the window, y downward.
  struct Area {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    [[nodiscard]] bool empty() const { return x0 >= x1 || y0 >= y1; }
    [[nodiscard]] bool meets(const Area& b) const { return x0 < b.x1 && b.x0 < x1 && y0 < b.y1 && b.y0 < y1; }
    [[nodiscard]] long long pixels() const { return static_cast<long long>(x1 - x0) * (y1 - y0); }
  };
  /// Copy of a draw list as it was drawn.
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
