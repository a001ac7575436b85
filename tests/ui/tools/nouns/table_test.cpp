// The table of taxels: orders of rows, the filter, the cell that is typed in, and the model's samples.
#include <gtest/gtest.h>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/table/table_rows.h"
#include "ui/tools/tool_scene.h"

namespace taxel::ui {
namespace {

using Ids = std::vector<int>;

/// A layout of taxels with these ids.
Layout layout_of(const Ids& ids) {
  Layout layout;
  for (const int id : ids) {
    layout.taxels.emplace_back();
    layout.taxels.back().id = id;
  }
  return layout;
}

/// The cell after Tab, or Shift+Tab with `back`, in a table of taxels 1 and 2.
TableCell cell_after(int id, TableColumn column, bool back) {
  TableState table;
  table.rows = {0, 1};
  table.left = TableCell{id, column, false, back};
  leave_cell(table, layout_of({1, 2}));
  return table.cell.value();
}

TEST(MovedByOne, MovesARunOfSelectedTaxelsTogether) {
  const Layout layout = layout_of({1, 2, 3, 4, 5});
  EXPECT_EQ(moved_by_one(layout, {2, 3}, true), (Ids{2, 3, 1, 4, 5}));
  EXPECT_EQ(moved_by_one(layout, {2, 3}, false), (Ids{1, 4, 2, 3, 5}));
  EXPECT_EQ(moved_by_one(layout, {5, 2}, true), (Ids{2, 1, 3, 5, 4})) << "two runs, each by one place";
}

TEST(MovedByOne, StopsAtTheEnds) {
  const Layout layout = layout_of({1, 2, 3});
  EXPECT_EQ(moved_by_one(layout, {1, 2}, true), (Ids{1, 2, 3}));
  EXPECT_EQ(moved_by_one(layout, {3}, false), (Ids{1, 2, 3}));
}

TEST(MovedTo, GathersTheSelectedTaxelsAtTheTarget) {
  const Layout layout = layout_of({1, 2, 3, 4, 5});
  EXPECT_EQ(moved_to(layout, {1, 2}, 4), (Ids{3, 4, 1, 2, 5})) << "from above: after the target";
  EXPECT_EQ(moved_to(layout, {4, 5}, 2), (Ids{1, 4, 5, 2, 3})) << "from below: before the target";
  EXPECT_EQ(moved_to(layout, {1, 5}, 3), (Ids{2, 3, 1, 5, 4})) << "from both sides: after the target";
}

TEST(MovedTo, IgnoresASelectedOrUnknownTarget) {
  const Layout layout = layout_of({1, 2, 3});
  EXPECT_EQ(moved_to(layout, {1, 2}, 2), (Ids{1, 2, 3}));
  EXPECT_EQ(moved_to(layout, {1}, 9), (Ids{1, 2, 3}));
}

TEST(TableRows, FilterByIdNameOrProblem) {
  Layout layout = layout_of({7, 12, 3});
  layout.taxels[0].name = "Index TIP";
  LayoutProblems problems;
  problems.list = {{"", "/taxels/2/radius", Severity::error, "", "Radius must be positive", ""}};
  problems.of_taxel[3] = {0};
  TableState table;
  const auto rows = [&](const char* filter) {
    table.filter = filter;
    return table_rows(table, layout, problems, {});
  };
  EXPECT_EQ(rows("2"), (Ids{1})) << "part of an id";
  EXPECT_EQ(rows("tip"), (Ids{0})) << "part of a name, in any case";
  EXPECT_EQ(rows("radius"), (Ids{2})) << "a word of a problem";
  EXPECT_EQ(rows("x"), (Ids{0})) << "Index";
  EXPECT_EQ(rows(""), (Ids{0, 1, 2}));
}

TEST(TableRows, KeepTheLayoutOrderOfEqualNames) {
  Layout layout = layout_of({1, 2, 3});
  layout.taxels[0].name = layout.taxels[2].name = "b";
  layout.taxels[1].name = "a";
  TableState table;
  table.sorted = TableColumn::name;
  EXPECT_EQ(table_rows(table, layout, {}, {}), (Ids{1, 0, 2}));
  table.descending = true;
  EXPECT_EQ(table_rows(table, layout, {}, {}), (Ids{0, 2, 1}));
}

TEST(TableRows, CountMissingReadingsAsZero) {
  const std::vector<double> readings{5, -1};
  TableState table;
  table.sorted = TableColumn::reading;
  EXPECT_EQ(table_rows(table, layout_of({1, 2, 3}), {}, {&readings, nullptr}), (Ids{1, 2, 0}));
}

TEST(TableRows, SortByTheMagnitudeOfShearAndBySlip) {
  const std::vector<double> slip{0.5, 1};
  const std::vector<dvec2> shear{{-3, 4}, {2, 2}, {0, 1}};
  TableState table;
  TableNumbers numbers;
  numbers.shear = &shear, numbers.slip = &slip;
  table.sorted = TableColumn::shear;
  EXPECT_EQ(table_rows(table, layout_of({1, 2, 3}), {}, numbers), (Ids{2, 1, 0}));
  table.sorted = TableColumn::slip;
  EXPECT_EQ(table_rows(table, layout_of({1, 2, 3}), {}, numbers), (Ids{2, 0, 1})) << "a missing share is 0";
}

TEST(EditCell, TypesInTheNameInPlaceOfAnId) {
  TableState table;
  edit_cell(table, 4, TableColumn::y);
  EXPECT_EQ(table.cell->column, TableColumn::y);
  for (const TableColumn column : {TableColumn::id, TableColumn::samples, TableColumn::reading}) {
    edit_cell(table, 4, column);
    EXPECT_EQ(table.cell->column, TableColumn::name);
  }
}

TEST(LeaveCell, SkipsColumnsThatCannotBeTypedIn) {
  const TableCell next = cell_after(1, TableColumn::radius, false);
  EXPECT_EQ(next.id, 1);
  EXPECT_EQ(next.column, TableColumn::x) << "the samples are in between";
  EXPECT_TRUE(next.begins);
  EXPECT_EQ(cell_after(1, TableColumn::x, true).column, TableColumn::radius);
}

TEST(LeaveCell, GoesFromRowToRow) {
  const TableCell down = cell_after(1, TableColumn::nz, false);
  EXPECT_EQ(down.id, 2);
  EXPECT_EQ(down.column, TableColumn::name);
  const TableCell up = cell_after(2, TableColumn::name, true);
  EXPECT_EQ(up.id, 1);
  EXPECT_EQ(up.column, TableColumn::nz);
}

TEST(LeaveCell, StaysInTheFirstAndTheLastCell) {
  const TableCell last = cell_after(2, TableColumn::nz, false);
  EXPECT_EQ(last.id, 2);
  EXPECT_EQ(last.column, TableColumn::nz);
  const TableCell first = cell_after(1, TableColumn::name, true);
  EXPECT_EQ(first.id, 1);
  EXPECT_EQ(first.column, TableColumn::name);
}

TEST(LeaveCell, DropsTheCellOfADeletedTaxel) {
  TableState table;
  edit_cell(table, 3, TableColumn::x);
  leave_cell(table, layout_of({1, 2}));
  EXPECT_FALSE(table.cell);
}

TEST(TableOf, FindsTaxelsByIdInAnOlderModel) {
  test::ToolScene ball({dvec3(1, 0, 0), dvec3(0, 1, 0)});
  const SensorModel& model = *ball.app.shown->document.model;
  const Layout layout = layout_of({2, 9, 1});
  const Table table = table_of(*ball.app.viewer, *ball.app.shown, layout, model);
  EXPECT_EQ(table.in_model, (std::vector<int>{1, -1, 0}));
  EXPECT_EQ(table.samples[0], model.fields.first[2] - model.fields.first[1]);
  EXPECT_EQ(table.samples[1], 0) << "taxel 9 is newer than the model";
  EXPECT_GT(table.samples[2], 0);
}

TEST(TableOf, IsEditableInLayoutOnly) {
  test::ToolScene ball({dvec3(1, 0, 0)});
  const SensorModel& model = *ball.app.shown->document.model;
  EXPECT_TRUE(table_of(*ball.app.viewer, *ball.app.shown, model.layout, model).edited);
  ball.app.viewer->mode = Mode::simulate;
  EXPECT_FALSE(table_of(*ball.app.viewer, *ball.app.shown, model.layout, model).edited);
}

}  // namespace
}  // namespace taxel::ui
