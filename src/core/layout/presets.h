// The built-in layout of this project.
#pragma once

#include <string>

#include "core/layout/layout.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// Returns a layout with the twelve taxels of the paper "Curved Tactile Sensor Simulation with Hydroelastic Contacts in
/// MuJoCo" on our own fingertip (primitives.h): the paper's centres moved to the nearest point of `skin`, with the
/// smooth surface normals there, six on the +x side and their mirror images; radius 6 mm, density 1e7 per square metre.
/// Numbers rounded to 0.1 micrometre and to 1e-6. mesh.file is "../meshes/fingertip.obj", and `mesh_sha256` is the hash
/// of this file.
Layout fingertip_layout(const MeshIndex& skin, const std::string& mesh_sha256 = "");

}  // namespace taxel
