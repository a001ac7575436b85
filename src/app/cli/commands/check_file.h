// All problems of one file: a layout, a project, a contact case, a scenario, a mesh or a MuJoCo scene.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/layout/file/skin_choice.h"

namespace taxel::cli {

/// Returns all problems of a file that can be read. Throws Error for a file that cannot be read: missing, not JSON, a
/// value of the wrong type, an unknown version or kind, a scene that does not compile. `skin` names the mesh of layouts
/// of other programs; without a mesh only their values are checked.
Problems check_file(const std::string& file, const SkinChoice& skin);

}  // namespace taxel::cli
