// Layouts in NumPy archives of poses.
#pragma once

#include "core/base/archive/npz.h"
#include "core/layout/file/imported_layout.h"

namespace taxel {

/// Reads the array `poses` (taxels, 3, 4) or (taxels, 4, 4), whose third column is the normal and whose fourth is the
/// centre [m], and the arrays `ids`, `radii` and `names`, which may be missing. Throws Error naming file and array.
ImportedLayout layout_of_poses(const NpzReader& npz);

}  // namespace taxel
