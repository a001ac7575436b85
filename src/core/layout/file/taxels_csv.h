// Taxels as a table, for spreadsheets and for other programs.
#pragma once

#include <string>
#include <vector>

#include "core/layout/layout.h"

namespace taxel {

/// `Index,X,Y,Z,NormX,NormY,NormZ,Radius,Parent,Name`, metres, shortest round-trip numbers. Index is the id; Parent is
/// -1. A subtaxel follows its taxel, with that one's id as Parent and an Index of its own behind the largest id. Throws
/// Error naming the taxel where a number is not finite.
std::string taxels_to_csv(const std::vector<Taxel>& taxels);

/// What a table gave.
struct CsvTaxels {
  std::vector<Taxel> taxels;
  bool normals = false, radii = false;  ///< given; otherwise each taxel has the defaults of Taxel
};

/// Reads what taxels_to_csv writes, and any table with columns x, y and z: columns are found by the names in the first
/// row (any case, any order; normx or nx, index or id; others are left out), or, where that row holds numbers, are x,
/// y, z and then the normal. `unit` is what one unit of the table's lengths is [m]. An empty Parent, or -1, is none; a
/// row without an Index gets its number, from 0. Throws Error(file, "line N, column NAME", ...) for what is missing or
/// is no number, for a Parent that no row before has, and for a table without taxels. Ids may repeat: layout_check
/// tells.
CsvTaxels parse_taxels_csv(const std::string& text, const std::string& file = "", double unit = 1.0);

}  // namespace taxel
