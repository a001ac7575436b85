// The body, the samples, the method and the scenario of the paper's released demo.
#pragma once

#include "core/document/edit.h"
#include "core/layout/layout.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Bounds of the box of the released demo, frame W [m]; see core/run/motion/motion.h.
inline const Aabb kDemoBox{{-0.015, -0.025, -0.012}, {0.035, 0.025, 0.038}};

/// Returns `layout` with the demo's body and samples: star field, modulus 5e4 Pa, dissipation 5 s/m, friction 0.3, 1e6
/// samples per m^2 of equal weight, fields that are cut at the angle to face normals, readings by samples. Taxels,
/// mesh, seed, metric, largest angle and the rest of the readout do not change.
Layout as_in_the_paper(Layout layout);

/// Returns one edit that applies as_in_the_paper() to a project with this layout, and sets the scenario `paper`.
Edit paper_setting_edit(const Layout& layout);

}  // namespace taxel
