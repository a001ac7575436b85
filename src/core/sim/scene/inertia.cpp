// Mass, centre and moments of inertia of a solid mesh of even density.
//
// The tets between the faces and the centroid fill the solid, with a sign where they overlap. The integral of x x^T
// over the tet of a face (a, b, c) and the origin is det/120 (s s^T + a a^T + b b^T + c c^T), det = a . (b x c), s = a
// + b + c; the moments follow from its trace. A mesh that is open or encloses nothing gets the inertia of its box.
#include "core/sim/scene/inertia.h"

namespace taxel {
namespace {

Inertia box_inertia(const Aabb& box, double mass) {
  const dvec3 e = box.extent();
  Inertia inertia{mass, box.center(), dmat3(0)};
  for (int i = 0; i < 3; ++i) {
    const double a = e[(i + 1) % 3], b = e[(i + 2) % 3];
    inertia.moment[i][i] = mass * (a * a + b * b) / 12.0;
  }
  return inertia;
}

}  // namespace

Inertia solid_inertia(const TriMesh& mesh, double mass) {
  if (!mesh.closed() || !(mesh.volume() > 0)) return box_inertia(mesh.bounds(), mass);
  const dvec3 center = mesh.centroid();
  dmat3 second(0);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const dvec3 a = mesh.vertex(f, 0) - center, b = mesh.vertex(f, 1) - center, c = mesh.vertex(f, 2) - center;
    const dvec3 s = a + b + c;
    second += glm::dot(a, glm::cross(b, c)) / 120.0 *
              (glm::outerProduct(s, s) + glm::outerProduct(a, a) + glm::outerProduct(b, b) + glm::outerProduct(c, c));
  }
  const double trace = second[0][0] + second[1][1] + second[2][2];
  return {mass, center, mass / mesh.volume() * (trace * dmat3(1) - second)};
}

}  // namespace taxel
