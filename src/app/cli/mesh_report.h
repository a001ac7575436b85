// `taxel mesh`: what a mesh is, and what was repaired on reading it.
#pragma once

#include <string>

#include "core/mesh/mesh_io.h"

namespace taxel::cli {

std::string mesh_text(const LoadedMesh& loaded);
std::string mesh_json(const LoadedMesh& loaded);

}  // namespace taxel::cli
