#include "core/sensor/bare_model.h"

#include <numeric>

namespace taxel {

SensorModelPtr bare_model(const std::string& name, const TriMeshPtr& surface, const HydroBodyPtr& body) {
  const auto model = std::make_shared<SensorModel>();
  model->layout.name = name;
  model->layout.mesh.file = model->layout.name;
  model->layout.frame = {{1, 0, 0}, {0, 0, 1}};
  if (body) model->layout.material = body->material;
  model->loaded = model->mesh = surface;
  model->repaired = std::make_shared<const RepairedMesh>(RepairedMesh{model->mesh, {}, {}, {}, {}});
  model->skin = std::make_shared<const MeshIndex>(model->mesh);
  model->skin_face_of.resize(static_cast<std::size_t>(model->mesh->face_count()));
  std::iota(model->skin_face_of.begin(), model->skin_face_of.end(), 0);
  model->sampled_area = surface->area();
  model->body = body;
  return model;
}

}  // namespace taxel
