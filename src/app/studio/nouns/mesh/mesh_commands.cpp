#include "app/studio/nouns/mesh/mesh_commands.h"

#include "app/studio/host/document/documents.h"
#include "app/studio/host/host.h"
#include "app/studio/nouns/history/edit_commands.h"

namespace taxel::studio {

/// The taxels stay where they are. Where there are none yet, there will be as many samples as before.
void carry_out(const ui::SetMeshUnit& command, Host& host) {
  edit_document(host, [&](EditSession& edits) {
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

void carry_out(const ui::PolishSamples&, Host& host) {
  polish(host);
}

}  // namespace taxel::studio
