#include "core/hydro/fields/touched_mesh.h"

namespace taxel {

RepairedMeshPtr repair_touched_mesh(Shape& shape, const Material& material, TouchedRepair repair) {
  const bool refused = shape.mesh == nullptr || shape.mesh->face_count() == 0 || shape.rigid_only != nullptr;
  if (shape.type != ShapeType::mesh || refused || repair == TouchedRepair::off) return nullptr;  // make_body() says why
  RepairRecipe recipe;
  if (!material.compliant() || repair == TouchedRepair::exact) recipe.level = RepairLevel::exact;
  recipe.has_two_sided_sheets = !material.compliant();
  RepairedMeshPtr repaired;
  try {
    repaired = repair_mesh(shape.mesh, recipe, material.thickness);
  } catch (const Error& error) {
    if (recipe.level != RepairLevel::exact) throw;
    throw Error("", error.where(),
                "the mesh has no inside that exact repairs find (" + error.message() +
                    "); write a closed one with taxel mesh FILE --repair wrap --out F.stl");
  }
  if (repaired->mesh == shape.mesh) return nullptr;
  std::vector<int> numbers = repaired->loaded_face_of;
  if (!shape.face_numbers.empty())
    for (int& face : numbers) face = face < 0 ? -1 : shape.face_numbers[static_cast<std::size_t>(face)];
  shape.mesh = repaired->mesh;
  shape.face_numbers = std::move(numbers);
  return repaired;
}

}  // namespace taxel
