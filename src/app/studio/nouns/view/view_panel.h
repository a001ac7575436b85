// The 3-D view: draws the scene when something changed, the text that floats over it, and the legends of the marks and
// of the polygons that the contact surface left out.
#pragma once

#include <imgui.h>

#include <array>
#include <string>
#include <vector>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/profiler/profiler_state.h"
#include "app/studio/nouns/view/view_state.h"
#include "ui/scene/geometry/shown_fields.h"
#include "ui/scene/scene_renderer.h"
#include "ui/widgets/format.h"
#include "ui/widgets/pressure_legend.h"

namespace taxel::ui {

/// Draws the scene into the renderer's texture if something visible has changed.
void render_if_changed(Viewer& viewer, ProfileState& profile, ViewShown& view, SceneInput scene,
                       SceneRenderer& renderer, int width, int height);
/// The boxes of the view in which something is drawn over the scene, so that labels avoid them. The boxes follow from
/// the vertices of the list: a drawing needs not know its own size.
class CoveredBoxes {
 public:
  CoveredBoxes(const ImDrawList& list, const ViewPlace& place)
      : list_(list),
        corner_(static_cast<double>(place.rect.x0), static_cast<double>(place.rect.y0)),
        begin_(list.VtxBuffer.Size) {}

  /// Forgets all that was drawn since the last call.
  void skip() { begin_ = list_.VtxBuffer.Size; }
  /// Adds the box around all that was drawn since the last call.
  void add();
  /// Adds a box of the window.
  void add(const Rect& rect);
  [[nodiscard]] std::vector<LabelBox> boxes() const { return boxes_; }

 private:
  const ImDrawList& list_;
  dvec2 corner_;
  int begin_;
  std::vector<LabelBox> boxes_;
};

/// Places the labels if the image or the covered boxes have changed. Labels keep their places if they can.
void place_labels(const ViewPlace& place, ViewShown& view, std::vector<LabelBox> covered);

/// Returns whether the view shows pressures of a contact.
bool shows_pressure(const Viewer& viewer, const Shown& shown);
/// Returns the place of the legend of colours, in the upper right corner.
LegendPlace legend_place(const ViewPlace& place, const LegendScales& scales);
/// Returns the name of the displayed scene, or that of the document.
std::string displayed_name(const Viewer& viewer, const Shown& shown);
/// Draws mode and name in the upper left corner.
/// The text ends where the legend begins, which is `legend_width` wide.
void draw_heading(const WindowUi& ui, const Viewer& viewer, const Shown& shown, float legend_width, ImDrawList& list);
void draw_border(const WindowUi& ui, const Viewer& viewer, ImDrawList& list);
/// Draws a tooltip about the object under the resting pointer.
void draw_hover_tooltip(const Viewer& viewer, const Shown& shown);
void draw_labels(const WindowUi& ui, const ViewPlace& place, const ViewShown& view, ImDrawList& list);

enum class Glyph { arrow, line, dot, disc };

/// One kind of mark.
struct MarkRow {
  Glyph glyph = Glyph::line;
  glm::vec4 color{1};  ///< colour of the mark, sRGB; marks of taxels have the colour of the first taxel
  std::string name;
  std::string value;  ///< unit or scale, such as "10 mm = 1 N"
};

/// Returns a row for each kind of mark that is drawn. Marks with a legend of their own, such as tractions, have none.
/// `unit` is the unit of the readings.
[[nodiscard]] std::vector<MarkRow> mark_rows(const SceneInput& input, const FieldNumbers& numbers,
                                             const ReadingUnit& unit);

/// Returns rectangles of the window around the sensors and the contact, which the legend of the marks does not cover.
[[nodiscard]] std::vector<Rect> rects_to_see(const Viewer& viewer, const Shown& shown);

/// Draws the rows at the left of the view, from `top` down. Where the rows would cover most of a small view or one of
/// `rects`, only a title is drawn, and the rows while the pointer is on the title. `is_folded` is updated. Records the
/// texts as widgets of the panel "Marks".
void draw_mark_legend(WindowUi& ui, const ViewPlace& place, const std::vector<MarkRow>& rows, float top,
                      const std::vector<Rect>& rects, bool& is_folded);

/// Returns the polygons that the contact surface left out of the bodies' overlap: the sums over all surfaces of a
/// sensor, by reason.
std::array<RejectedPolygons, kRejections> left_out(const SensorStep& sensor);

/// Draws colour, reason, count, area and force in the lower right corner of the view. Returns the legend's upper edge.
float draw_filtered_legend(const WindowUi& ui, const ViewPlace& place, const SensorStep& sensor);

}  // namespace taxel::ui
