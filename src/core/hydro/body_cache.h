// A cache in which bodies of equal primitives share their tets, triangles and trees.
#pragma once

#include "core/hydro/hydro_body.h"

namespace taxel {

/// Builds a body like make_body(shape, material, name). If another body of the same shape and material exists, a
/// primitive shares its geometry, so a thousand equal spheres are built once. May be called from any thread.
HydroBodyPtr share_body(const Shape& shape, const Material& material, const std::string& name);

}  // namespace taxel
