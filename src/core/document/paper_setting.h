// The setting in which the paper's released demo reads its fingertip.
#pragma once

#include "core/document/edit.h"
#include "core/layout/layout.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// The box of the released demo, world [m]: see core/run/motion/paper_demo.h.
inline const Aabb kDemoBox{{-0.015, -0.025, -0.012}, {0.035, 0.025, 0.038}};

/// Returns `layout` with the demo's body and samples: star field, modulus 5e4 Pa, dissipation 5 s/m, friction 0.3, 1e6
/// samples per m^2, all of equal weight. Taxels, mesh, seed and readout stay.
Layout as_in_the_paper(Layout layout);

/// The same for a project with this layout, and its scenario `paper`, as one edit.
Edit paper_setting_edit(const Layout& layout);

}  // namespace taxel
