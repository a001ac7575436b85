// Reads and writes taxels as a table, for spreadsheets and other programs.
#pragma once

#include <string>
#include <vector>

#include "core/layout/layout.h"

namespace taxel {

/// Settings of a table to write.
struct CsvStyle {
  bool normals = true;        ///< false leaves the columns of the normals out
  std::string parent = "-1";  ///< Parent of taxels: -1, or the path of a USD prim
};

/// Returns a table with the columns `Index,X,Y,Z,NormX,NormY,NormZ,Radius,Parent,Name`, in metres, with the shortest
/// numbers that read back unchanged. Index is the id. A subtaxel follows its taxel; its Parent is the taxel's id, and
/// its Index is greater than all ids. Throws Error naming the taxel of a number that is not finite.
std::string taxels_to_csv(const std::vector<Taxel>& taxels, const CsvStyle& style = {});

/// The taxels of a table.
struct CsvTaxels {
  std::vector<Taxel> taxels;
  bool normals = false, radii = false;   ///< true if in the table; otherwise the defaults of Taxel
  std::vector<std::string> prims = {};   ///< path of the USD prim of each taxel, empty if its Parent is none
  std::vector<std::string> unread = {};  ///< names of the columns that are not read
  bool has_units = false;                ///< true if the head of a column names a unit of length
};

/// Reads the table of taxels_to_csv(), or any table with columns x, y and z. The first row has the names of the columns
/// in any case and order (normx or nx, index or id, name or GenTact's `Object Name in Blender`; a quaternion qx, qy,
/// qz, qw gives its z axis as the normal). A column may name its unit ("x [mm]", "x_mm"); `unit` is the length of the
/// unit of the others [m]. Text may be in UTF-16, separators may be semicolons, tabs or blanks, and decimal marks
/// commas. If the first row has numbers, the columns are x, y, z and then the normal. An empty Parent or -1 is no
/// parent, nor is the path of a USD prim, which begins with `/`; a row without an Index gets the row's index. Does not
/// check for repeated ids: layout_check does. Throws Error(file, "line N, column NAME", ...): a value is missing or not
/// a number, no earlier row has a Parent as its Index, or there are no taxels.
CsvTaxels parse_taxels_csv(const std::string& text, const std::string& file = "", double unit = 1.0);

}  // namespace taxel
