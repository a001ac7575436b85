#include "app/studio/host/document/mesh_comparison.h"

#include <utility>

#include "core/sensor/sensor_cache.h"

namespace taxel::studio {

ComparedMesh compare_mesh(const MeshRef& ref, const OpenMeshPtr& mesh, const Layout& layout) {
  const SensorSkinPtr skin = make_sensor_skin(mesh->loaded.mesh, layout.sampling.shells);
  return {ref, mesh, skin->sensed, distances_to(*skin->sensed, layout), ""};
}

MeshComparison::MeshComparison(JobExecutor& executor)
    : slot_(executor, Priority::normal,
            [](const std::shared_ptr<const Layout>& layout, ComparedMesh& out, Progress& progress) {
              out.ref = layout->mesh;
              const OpenMeshPtr mesh = read_open_mesh(layout->mesh, &progress);
              MeshRef ref = layout->mesh;
              ref.sha256 = mesh->loaded.sha256;
              out = compare_mesh(ref, mesh, *layout);
            }) {}

void MeshComparison::start(const Layout& layout) {
  slot_.post(std::nullopt, Superseded::cancel);
  slot_.post(std::make_shared<const Layout>(layout));
}

std::optional<ComparedMesh> MeshComparison::take() {
  const auto compared = slot_.take();
  return compared ? std::optional(*compared) : std::nullopt;
}

}  // namespace taxel::studio
