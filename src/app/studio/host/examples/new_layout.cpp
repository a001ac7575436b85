#include "app/studio/host/examples/new_layout.h"

#include "core/layout/file/layout_json.h"
#include "core/mesh/mesh_io.h"

namespace taxel::studio {

std::string_view embedded_file(std::string_view name);

LoadedDocument new_layout(const SensorBuild& how) {
  const BuiltInMesh mesh = built_in_mesh();
  Layout layout = parse_layout(std::string(embedded_file("assets/layouts/fingertip.taxels.json")), "new layout");
  layout.name = "Untitled";
  layout.mesh.file = mesh.name;
  layout.readout.method = ReadingMethod::exact;
  layout.taxels.clear();
  layout.calibration.reset();
  LoadedDocument document = document_in_memory(std::move(layout), read_mesh(mesh.bytes, mesh.name), how);
  document.name = "Untitled";
  return document;
}

}  // namespace taxel::studio
