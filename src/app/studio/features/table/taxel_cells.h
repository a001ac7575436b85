// The cells of the table of taxels that can be typed in.
#pragma once

#include <imgui.h>

#include <span>
#include <string>

#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/table/table_state.h"

namespace taxel::ui {

struct CellColumn {
  TableColumn column;
  const char* title;
  const char* tip;
  float width;  ///< in heights of text
};
/// Of the table in LAYOUT, from the left.
std::span<const CellColumn> layout_columns();

/// Text of a cell, at its right end where it is a number.
void draw_text(const std::string& text, bool right, const ImVec4& color);

/// Whether a column can be typed in.
bool is_editable(TableColumn column);
/// Begins to type in a cell; a column that cannot be typed in stands for the name.
void edit_cell(TableState& table, int id, TableColumn column);
/// After the table was drawn: Tab goes on to another cell.
void leave_cell(TableState& table, const Layout& layout);
/// Number or name, or the field while it is typed in.
void draw_cell(WindowUi& ui, TableState& table, const Taxel& taxel, TableColumn column);

}  // namespace taxel::ui
