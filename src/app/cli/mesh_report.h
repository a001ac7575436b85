// `taxel mesh`: what a mesh is, and what was repaired on reading it.
#pragma once

#include <string>

#include "core/mesh/mesh_io.h"
#include "core/mesh/repair/repair.h"

namespace taxel::cli {

std::string mesh_text(const LoadedMesh& loaded);
/// With the key "repair" if `repaired` is not null.
std::string mesh_json(const LoadedMesh& loaded, const RepairedMesh* repaired = nullptr);

}  // namespace taxel::cli
