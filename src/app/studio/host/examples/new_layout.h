// A new layout without taxels, on the mesh that is built into the program.
#pragma once

#include "app/studio/host/document/documents.h"

namespace taxel::studio {

/// Name under which the new layout opens, instead of a file.
inline constexpr std::string_view kNewLayout = "built-in: new layout";
/// Returns a layout without taxels on the fingertip's mesh, with the fingertip's settings. Throws Cancelled.
LoadedDocument new_layout(const SensorBuild& how);

}  // namespace taxel::studio
