#include "core/sim/model/bare_model.h"

#include <numeric>

#include "core/sim/model/geometry.h"
#include "core/sim/model/scene_view.h"

namespace taxel {

SensorModelPtr bare_model(const std::string& name, const TriMeshPtr& surface, const HydroBodyPtr& body) {
  const auto model = std::make_shared<SensorModel>();
  model->layout.name = name;
  model->layout.mesh.file = model->layout.name;
  model->layout.frame = {{1, 0, 0}, {0, 0, 1}};
  model->layout.material = body->material;
  model->loaded = model->mesh = surface;
  model->repaired = std::make_shared<const RepairedMesh>(RepairedMesh{model->mesh, {}, {}, {}, {}});
  model->skin = std::make_shared<const MeshIndex>(model->mesh);
  model->skin_face_of.resize(static_cast<std::size_t>(model->mesh->face_count()));
  std::iota(model->skin_face_of.begin(), model->skin_face_of.end(), 0);
  model->body = body;
  return model;
}

SensorModelPtr bare_model(const mjModel& m, int geom, const HydroBodyPtr& body) {
  return bare_model(geom_name(m, geom), drawn_mesh(m, geom), body);
}

}  // namespace taxel
