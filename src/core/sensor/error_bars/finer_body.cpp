#include "core/sensor/error_bars/finer_body.h"

#include <cmath>
#include <memory>

#include "core/mesh/topology/subdivide.h"
#include "core/sensor/readout/aggregate.h"

namespace taxel {

Shape finer_shape(Shape shape, const Material& material) {
  switch (shape.type) {
    case ShapeType::plane:
    case ShapeType::box:
    case ShapeType::tets:
      break;
    case ShapeType::mesh:
      if (!material.compliant()) break;
      shape.mesh = std::make_shared<const TriMesh>(subdivide(*shape.mesh, 1, SubdivisionScheme::midpoint));
      shape.face_numbers.clear();
      break;
    default:
      shape.resolution = 0.5 * tessellation_edge(shape);
  }
  return shape;
}

SensorModelPtr with_finer_body(const SensorModelPtr& model) {
  if (!model->body->soft()) return model;
  Shape shape;
  shape.type = ShapeType::mesh;
  shape.mesh = model->mesh;
  shape.refine = model->layout.mesh.repair.refine.value_or(kDefaultRefine);
  auto finer = std::make_shared<SensorModel>(*model);
  finer->body =
      make_body(finer_shape(std::move(shape), model->layout.material), model->layout.material, model->layout.name);
  finer->tet_table = nullptr;
  if (const auto* soft = std::get_if<SoftBody>(&finer->body->geometry))
    finer->tet_table = std::make_shared<const TetTable>(*soft->field, finer->rays);
  if (model->skin_fields != nullptr) finer->skin_fields = skin_fields_for(*finer, integral_of(model->layout.readout));
  return finer;
}

std::vector<double> richardson_bars(std::span<const double> coarse, std::span<const double> fine) {
  std::vector<double> bars;
  for (std::size_t k = 0; k < coarse.size(); ++k) bars.push_back(4.0 / 3.0 * std::abs(coarse[k] - fine[k]));
  return bars;
}

}  // namespace taxel
