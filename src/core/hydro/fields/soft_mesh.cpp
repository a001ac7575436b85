#include "core/hydro/fields/soft_mesh.h"

namespace taxel {

RepairedMeshPtr repair_soft_mesh(Shape& shape, const Material& material) {
  const bool refused = shape.mesh == nullptr || shape.mesh->face_count() == 0 || shape.rigid_only != nullptr;
  if (shape.type != ShapeType::mesh || !material.compliant() || refused) return nullptr;  // make_body() says why
  RepairedMeshPtr repaired = repair_mesh(shape.mesh, {}, material.thickness);
  if (repaired->mesh == shape.mesh) return nullptr;
  std::vector<int> numbers = repaired->loaded_face_of;
  if (!shape.face_numbers.empty())
    for (int& face : numbers) face = face < 0 ? -1 : shape.face_numbers[static_cast<std::size_t>(face)];
  shape.mesh = repaired->mesh;
  shape.face_numbers = std::move(numbers);
  return repaired;
}

}  // namespace taxel
