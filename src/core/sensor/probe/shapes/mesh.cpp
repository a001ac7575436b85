#include "core/sensor/probe/probe.h"

#include "core/base/error.h"
#include "core/mesh/repair/repair.h"
#include "core/mesh/topology/mesh_check.h"

namespace taxel {
namespace {

/// Returns the middle of the box around the lowest vertices. It does not depend on the triangulation of a flat end.
dvec3 tip_of(const TriMesh& mesh) {
  const double flat = 1e-9 * mesh.bounds().diagonal();
  Aabb lowest;
  for (const dvec3& v : mesh.vertices())
    if (v.z <= mesh.bounds().lo.z + flat) lowest.include(v);
  return {lowest.center().x, lowest.center().y, mesh.bounds().lo.z};
}

/// Returns the repaired mesh, which must be closed: a rigid or soft probe is a solid.
TriMeshPtr repaired_probe(const TriMeshPtr& mesh) {
  try {
    const TriMeshPtr solid = repair_mesh(mesh, {}, 0)->mesh;
    if (!solid->closed()) refuse_probe("the mesh must be closed: " + openings(*solid));
    return solid;
  } catch (const Error& e) {
    refuse_probe(e.message());
  }
}

}  // namespace

ProbeForm ProbeMesh::body() const {
  if (mesh == nullptr || mesh->face_count() == 0) refuse_probe("the mesh has no triangles");
  const TriMeshPtr solid = repaired_probe(mesh);
  return {mesh_shape(solid), tip_of(*solid)};
}

}  // namespace taxel
