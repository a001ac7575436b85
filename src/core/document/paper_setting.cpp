#include "core/document/paper_setting.h"

#include <memory>

namespace taxel {

Layout as_in_the_paper(Layout layout) {
  layout.material.field = FieldKind::star;
  layout.material.modulus = 5.0e4;
  layout.material.dissipation = 5.0;
  layout.material.friction = 0.3;
  // Drake 1.8 left out polygons whose normal and gradient are more than 5 pi/8 apart, by a step at that angle.
  layout.material.faces = FaceRule::along_gradient;
  layout.sampling.density = 1.0e6;
  layout.sampling.weights = SampleWeights::equal;
  layout.receptive_field.angle_falloff_deg = 0.0;
  layout.receptive_field.normals = FieldNormals::face;
  layout.readout.method = ReadingMethod::samples;
  return layout;
}

Edit paper_setting_edit(const Layout& layout) {
  const Layout changed = as_in_the_paper(layout);
  EditList edits{{SetMaterial{changed.material}, SetSampling{changed.sampling}}};
  if (changed.receptive_field != layout.receptive_field)
    edits.edits.emplace_back(SetReceptiveField{changed.receptive_field});
  if (changed.readout != layout.readout) edits.edits.emplace_back(SetReadout{changed.readout});
  edits.edits.emplace_back(SetScenario{default_scenario(kKind<scenarios::Paper>)});
  return ApplyAll{"Set up as in the paper", std::make_shared<const EditList>(edits)};
}

}  // namespace taxel
