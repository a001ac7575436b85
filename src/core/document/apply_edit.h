// Applies edits to a project.
#pragma once

#include <string>

#include "core/document/edit.h"

namespace taxel {

/// Returns the project after the edit. Throws Error that names the taxel ("taxel 3: radius: must be greater than 0, is
/// -1") or the setting ("/material/modulus: ...") by the rules of layout_check. An edit cannot add an error, and one
/// error of a broken layout can be repaired without the others.
Project apply_edit(const Project& project, const Edit& edit);

/// Returns the name of the edit for the Edit menu: "Move taxel 3", "Delete 6 taxels", "Change the material".
std::string edit_name(const Edit& edit);

}  // namespace taxel
