// The plugin key `materials`: the materials of geoms, by geom name.
#pragma once

#include <map>
#include <string>

#include "core/base/material.h"
#include "core/mesh/repair/repair_recipe.h"

namespace taxel {

/// Material of one touched geom in the key `materials`.
struct OtherMaterial {
  Material material;          ///< rigid unless `modulus` is given
  bool has_friction = false;  ///< if false, the geom's own sliding friction is used
  bool has_field = false;     ///< if false, the field is the medial axis for primitives, the pad for meshes
  double resolution = 0;      ///< edge length of the tessellation [m]; chosen automatically if 0
  TouchedRepair repair = TouchedRepair::automatic;  ///< repair of a mesh
  bool operator==(const OtherMaterial&) const = default;
};
using OtherMaterials = std::map<std::string, OtherMaterial>;

/// Parses the key `materials`. Throws Error(file, JSON pointer, message).
OtherMaterials parse_materials(const std::string& text, const std::string& file);

}  // namespace taxel
