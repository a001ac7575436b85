// Sentences on the values of a layout that a file format cannot hold.
#pragma once

#include <string>
#include <vector>

#include "core/layout/formats/layout_format.h"

namespace taxel {

/// Returns one sentence for each kind of value that the layouts have and the format does not hold. `noun` names the
/// format: "a table".
std::vector<std::string> losses_in(const std::vector<ImportedLayout>& layouts, const HeldValues& holds,
                                   const std::string& noun);

/// Throws Error if a layout has no taxels, or a number is not finite.
void check_taxels_to_write(const std::vector<ImportedLayout>& layouts);

/// Throws Error if a layout does not have the normals of its taxels. `noun` is as in losses_in().
void require_normals(const std::vector<ImportedLayout>& layouts, const std::string& noun);

/// Returns true if the ids of the taxels are 0, 1, 2 and so on.
bool are_ids_row_numbers(const std::vector<Taxel>& taxels);

}  // namespace taxel
