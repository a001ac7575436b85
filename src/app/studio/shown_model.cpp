#include "app/studio/shown_model.h"

#include <utility>

namespace taxel::studio {

ShownModel shown_model(const Layout& layout, const TriMesh& mesh,
                       const std::function<SensorModelPtr(const Layout&)>& compile) {
  if (mesh.closed() || !layout.material.compliant()) return {compile(layout), ""};
  Layout rigid = layout;
  rigid.material.modulus = 0;
  SensorModel model = *compile(rigid);
  model.layout = layout;
  return {std::make_shared<const SensorModel>(std::move(model)),
          "The mesh is not closed: it can be edited, not simulated (Panels > Mesh report)"};
}

}  // namespace taxel::studio
