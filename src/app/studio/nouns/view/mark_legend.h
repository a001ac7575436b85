// The legend of the marks: what each arrow, line, dot and disc in the view is, with its unit.
#pragma once

#include <string>
#include <vector>

#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "ui/scene/field_numbers.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

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

/// Draws the rows at the left of the view, from `top` down. In a small view, most of which the rows would cover, only a
/// title is drawn, and the rows while the pointer is on the title. Records the texts as widgets of the panel "Marks".
void draw_mark_legend(WindowUi& ui, const ViewPlace& place, const std::vector<MarkRow>& rows, float top);

}  // namespace taxel::ui
