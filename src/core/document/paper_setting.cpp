#include "core/document/paper_setting.h"

#include <memory>

namespace taxel {

Layout as_in_the_paper(Layout layout) {
  layout.material.field = FieldKind::star;
  layout.material.modulus = 5.0e4;
  layout.material.dissipation = 5.0;
  layout.material.friction = 0.3;
  layout.sampling.density = 1.0e6;
  layout.sampling.weights = SampleWeights::equal;
  return layout;
}

Edit paper_setting_edit(const Layout& layout) {
  const Layout changed = as_in_the_paper(layout);
  const EditList edits{{SetMaterial{changed.material}, SetSampling{changed.sampling},
                        SetScenario{default_scenario(kKind<scenarios::Paper>)}}};
  return ApplyAll{"Set up as in the paper", std::make_shared<const EditList>(edits)};
}

}  // namespace taxel
