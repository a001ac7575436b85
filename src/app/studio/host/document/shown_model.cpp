#include "app/studio/host/document/shown_model.h"

#include <fmt/format.h>

#include <utility>

#include "core/base/error.h"
#include "core/base/limits.h"
#include "core/base/text/shown_message.h"
#include "core/sensor/bare_model.h"

namespace taxel::studio {

namespace {

/// Returns the model of a layout on a mesh, for viewing.
SensorModelPtr viewed_model(const Layout& layout, const TriMeshPtr& mesh) {
  SensorModel model = *bare_model(layout.name, mesh, nullptr);
  model.layout = layout;
  return std::make_shared<const SensorModel>(std::move(model));
}

/// Returns the model of a layout that is rigid and on the mesh as loaded, with the values of the layout.
SensorModelPtr rigid_model(const Layout& layout, const std::function<SensorModelPtr(const Layout&)>& compile) {
  Layout rigid = layout;
  rigid.material.modulus = 0;
  rigid.mesh.repair.level = RepairLevel::keep;
  SensorModel model = *compile(rigid);
  model.layout = layout;
  return std::make_shared<const SensorModel>(std::move(model));
}

}  // namespace

ShownModel shown_model(const Layout& layout, const TriMeshPtr& mesh,
                       const std::function<SensorModelPtr(const Layout&)>& compile) {
  const bool is_soft = layout.material.compliant();
  const int triangles = mesh->face_count();
  if (is_soft && layout.taxels.empty() && triangles > kManySkinTriangles)
    return {viewed_model(layout, mesh),
            fmt::format("{} triangles: the pressure field follows with the first taxel ({:.1f} GiB), or first decimate "
                        "the mesh: taxel mesh --decimate",
                        triangles, triangles * kBytesPerSkinTriangle / (1U << 30U))};
  std::string problem;
  try {
    return {compile(layout), ""};
  } catch (const Error& e) {
    if (!is_soft || !e.where().starts_with("/mesh/")) throw;
    problem = shown_part(e.message());
  }
  return {rigid_model(layout, compile),
          fmt::format("The mesh is not closed: it can be edited, not simulated (Inspector > Mesh): {}", problem)};
}

}  // namespace taxel::studio
