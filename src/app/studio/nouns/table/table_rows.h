// The rows of the table of taxels, their order and their cells: those that can be edited, and those with the values of
// a taxel in the displayed step.
#pragma once

#include <imgui.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/inspector/inspector_state.h"
#include "app/studio/nouns/table/table_state.h"
#include "core/layout/layout.h"
#include "core/sensor/sensor_step.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

/// A column of editable cells.
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

/// The columns of values that the displayed sensors have in addition to readings.
struct ValueColumns {
  bool shear = false, slip = false;
  [[nodiscard]] int count() const { return (shear ? 1 : 0) + (slip ? 1 : 0); }
  /// Adds the columns of another sensor.
  void include(const SensorStep& step) {
    shear = shear || !step.shear.empty();
    slip = slip || !step.slip.empty();
  }
};

inline constexpr const char* kShearTitle = "Shear";
inline constexpr const char* kSlipTitle = "Slip";

/// Returns the tooltip of a column with this title, or "" if it needs none.
[[nodiscard]] const char* value_tip(std::string_view title);

/// Width below which a table leaves out the samples, in heights of text: their numbers would be cut off.
inline constexpr float kNarrowTable = 24;

/// Draws the cells of the reading, and of shear and slip if there are these columns. Values that the sensor does not
/// have are empty cells.
void draw_values(const WindowUi& ui, const SensorStep* step, std::size_t taxel, const ReadingUnit& unit,
                 const ValueColumns& columns);

/// The taxels of the table in this frame.
struct Table {
  const Project* project;  ///< the edited project, or null
  const Layout& layout;
  const SensorModel& model;   ///< compiled model, which may be older than the layout
  const SensorStep* sensor;   ///< state of the sensor, or null in LAYOUT
  std::vector<int> in_model;  ///< index in the model of each taxel of the layout, or -1
  std::vector<int> samples;   ///< number of samples of each taxel of the layout
  bool edited = false;
  ValueColumns values = {};
};

Table table_of(const Viewer& viewer, const Shown& shown, const Layout& layout, const SensorModel& model);

/// Returns all ids, with each run of consecutive selected taxels moved by one place.
std::vector<int> moved_by_one(const Layout& layout, const std::vector<int>& selected, bool up);
/// Returns all ids, with the selected taxels together at the place of the taxel `target`: before the target if they
/// come from below, otherwise after the target.
std::vector<int> moved_to(const Layout& layout, const std::vector<int>& selected, int target);

/// The numbers that the table shows in addition to the fields of the taxels.
struct TableNumbers {
  const std::vector<double>* readings = nullptr;  ///< readings by index in the layout; may be shorter
  const std::vector<int>* samples = nullptr;
  const std::vector<dvec2>* shear = nullptr;  ///< parallel to `readings`; sorted by magnitude
  const std::vector<double>* slip = nullptr;  ///< parallel to `readings`
};

/// Returns the indices of the taxels that pass the filter, in the order of the table. A taxel passes if its id, its
/// name or the text of one of its problems contains the filter, ignoring case.
std::vector<int> table_rows(const TableState& table, const Layout& layout, const LayoutProblems& problems,
                            const TableNumbers& numbers);

/// Returns the rows if the table lists the taxels of several sensors: the taxels that pass the filter, in the order of
/// the table. A taxel passes if each word of the filter is part of its id, its name or the short name of its sensor, or
/// if the filter finds its sensor by body, mesh, class and joints. Rows that are equal in the sorted column keep the
/// order of the sensors and their layouts.
[[nodiscard]] std::vector<SensorRow> sensor_rows(const TableState& table, const std::vector<SensorShown>& sensors);

/// Returns the lines of a table with these rows: in the order of the sensors a heading before the rows of each sensor,
/// and no rows of folded sensors; in another order the rows alone. While there is a filter, no sensor is folded.
[[nodiscard]] std::vector<SensorLine> sensor_lines(const TableState& table, const std::vector<SensorRow>& rows,
                                                   const std::vector<SensorShown>& sensors);

}  // namespace taxel::ui
