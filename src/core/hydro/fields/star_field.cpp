// Fields of tets that meet in one inner vertex: the star of any mesh, and the medial axis of a sphere.
#include <fmt/format.h>

#include "core/base/error.h"
#include "core/hydro/fields/pressure_field.h"
#include "core/hydro/fields/round_mesh.h"
#include "core/mesh/topology/mesh_check.h"

namespace taxel {
namespace {

void require_positive(double value, const char* what) {
  if (!(value > 0) || !std::isfinite(value)) throw Error(fmt::format("{} must be positive, not {}", what, value));
}

/// Tets from `center`, where p = modulus, to every face, where p = 0.
PressureFieldPtr make_cone_field(const TriMesh& mesh, const dvec3& center, double modulus) {
  std::vector<dvec3> vertices = mesh.vertices();
  std::vector<double> pressure(vertices.size(), 0.0);
  const int apex = static_cast<int>(vertices.size());
  vertices.push_back(center);
  pressure.push_back(modulus);
  std::vector<ivec4> tets;
  tets.reserve(mesh.faces().size());
  int flat = 0;
  for (const ivec3& f : mesh.faces()) {
    const dvec3 &a = vertices[static_cast<std::size_t>(f.x)], &b = vertices[static_cast<std::size_t>(f.y)];
    const dvec3& c = vertices[static_cast<std::size_t>(f.z)];
    if (glm::dot(glm::cross(b - a, c - a), center - a) == 0) {
      ++flat;
      continue;
    }
    tets.push_back({f.x, f.z, f.y, apex});  // the face's normal points away from the apex
  }
  FieldReport report;
  if (flat > 0)
    report.notes.push_back(fmt::format("{} faces lie in a plane through the centroid and have no tet", flat));
  auto field =
      std::make_shared<PressureField>(std::move(vertices), std::move(tets), std::move(pressure), std::move(report));
  return field;
}

}  // namespace

PressureFieldPtr make_star_field(const TriMeshPtr& mesh, double modulus) {
  require_positive(modulus, "modulus of a star field");
  if (!mesh->closed()) throw Error("a star field needs a closed mesh; this one is open: " + openings(*mesh));
  return make_cone_field(*mesh, mesh->centroid(), modulus);
}

PressureFieldPtr make_sphere_field(double radius, double modulus, double edge_length) {
  require_positive(radius, "radius of a soft sphere");
  require_positive(modulus, "modulus of a soft sphere");
  return make_cone_field(make_round_sphere(radius, edge_length), dvec3(0), modulus);
}

}  // namespace taxel
