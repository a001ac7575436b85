// What the table of taxels remembers: the filter, the order of its rows, the cell that is typed in.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace taxel::ui {

enum class TableColumn : std::uint8_t { id, name, x, y, z, nx, ny, nz, radius, samples, reading };

struct TableCell {
  int id = 0;
  TableColumn column = TableColumn::name;
  bool begins = true;               ///< the keyboard is not there yet
  std::optional<bool> leaves_back;  ///< Tab leaves it, to the left or not
};

struct TableState {
  std::string filter;
  std::optional<TableColumn> sorted;  ///< none: the order of the layout
  bool descending = false;
  std::vector<int> rows;          ///< indices of the taxels that are shown, in their order
  std::optional<TableCell> cell;  ///< that is typed in
  std::optional<TableCell> left;  ///< in this picture
};

}  // namespace taxel::ui
