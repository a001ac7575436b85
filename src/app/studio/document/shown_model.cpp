#include "app/studio/document/shown_model.h"

#include <fmt/format.h>

#include <utility>

#include "core/base/error.h"

namespace taxel::studio {

ShownModel shown_model(const Layout& layout, const std::function<SensorModelPtr(const Layout&)>& compile) {
  std::string problem;
  try {
    return {compile(layout), ""};
  } catch (const Error& e) {
    if (!layout.material.compliant() || !e.where().starts_with("/mesh/")) throw;
    problem = e.message();
  }
  Layout rigid = layout;
  rigid.material.modulus = 0;
  rigid.mesh.repair.level = RepairLevel::keep;
  SensorModel model = *compile(rigid);
  model.layout = layout;
  return {std::make_shared<const SensorModel>(std::move(model)),
          fmt::format("The mesh is not closed: it can be edited, not simulated (Inspector > Mesh): {}", problem)};
}

}  // namespace taxel::studio
