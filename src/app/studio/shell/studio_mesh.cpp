// The mesh under the taxels: its unit.
#include "app/studio/host/document/documents.h"
#include "app/studio/shell/studio.h"

namespace taxel::studio {

/// The taxels stay where they are. Where there are none yet, there will be as many samples as before.
void Studio::carry_out(const ui::SetMeshUnit& command) {
  edit_document([&](EditSession& edits) {
    const Layout& layout = edits.project()->layout;
    ReplaceMesh replace{layout.mesh, *edits.project()->layout.sampling.region};
    const double ratio = command.metres / replace.mesh.scale.x;
    replace.mesh.scale = dvec3(command.metres);
    std::vector<Edit> steps;
    if (const OpenMeshPtr mesh = edits.mesh(); mesh && layout.taxels.empty()) {
      Sampling sampling = layout.sampling;
      sampling.density = density_for(mesh->loaded.mesh->area() * ratio * ratio);
      steps.emplace_back(SetSampling{sampling});
    }
    steps.emplace_back(replace);
    edits.edit_together(steps);
  });
}

}  // namespace taxel::studio
