// Meshes as legacy VTK files, binary and text.
#include "core/mesh/mesh_io.h"
#include "core/mesh/topology/mesh_check.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  const auto loaded = read_or_refuse([&] { return read_mesh(input, "input.vtk"); });
  if (!loaded) return;
  require(loaded->mesh->face_count() > 0, "a mesh that is read has faces");
  require(loaded->file_face_of.size() == static_cast<std::size_t>(loaded->mesh->face_count()),
          "each face has its number in the file");
  check_mesh(*loaded->mesh, "input.vtk");
}

const Registered kTarget("vtk_surface", run);

}  // namespace
}  // namespace taxel::fuzz
