// The editable cells of the table of taxels.
#pragma once

#include <imgui.h>

#include <span>
#include <string>

#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/table/table_state.h"
#include "core/layout/layout.h"

namespace taxel::ui {

struct CellColumn {
  TableColumn column;
  const char* title;
  const char* tip;
  float width;  ///< width of the column, in heights of text
};
/// Returns the columns of the table in LAYOUT, from the left.
std::span<const CellColumn> layout_columns();

/// Draws a square in the colour of a taxel, or nothing in its place if `color` is negative.
void draw_color_square(int color);
/// Draws the text of a cell. Numbers are aligned to the right (`right`).
void draw_text(const std::string& text, bool right, const ImVec4& color);

/// Returns whether the cells of a column can be edited.
bool is_editable(TableColumn column);
/// Begins to edit a cell. If the column cannot be edited, begins to edit the name.
void edit_cell(TableState& table, int id, TableColumn column);
/// Moves the text field to another cell if Tab was pressed. Must be called after the table was drawn.
void leave_cell(TableState& table, const Layout& layout);
/// Draws the number or the name of a cell, or its text field while the cell is edited.
void draw_cell(WindowUi& ui, TableState& table, const Taxel& taxel, TableColumn column);

}  // namespace taxel::ui
