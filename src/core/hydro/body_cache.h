// Bodies of equal primitives share their tets, triangles and trees.
#pragma once

#include "core/hydro/hydro_body.h"

namespace taxel {

/// As make_body(shape, material, name). A primitive of a shape and material that some living body has already shares
/// that body's geometry: a thousand equal spheres are built once. From any thread.
HydroBodyPtr share_body(const Shape& shape, const Material& material, const std::string& name);

}  // namespace taxel
