// Tets with pressures as VTK files.
#include "core/hydro/fields/tet_mesh.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  const auto mesh = read_or_refuse([&] { return read_vtk_tets(input, "input.vtk"); });
  if (!mesh) return;
  for (const ivec4& tet : mesh->tets)
    for (int k = 0; k < 4; ++k)
      require(tet[k] >= 0 && static_cast<std::size_t>(tet[k]) < mesh->vertices.size(), "corners of tets are vertices");
}

const Registered kTarget("vtk", run);

}  // namespace
}  // namespace taxel::fuzz
