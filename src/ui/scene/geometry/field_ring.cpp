#include "ui/scene/geometry/field_ring.h"

#include <algorithm>
#include <array>

#include "core/layout/field/field_disc.h"

namespace taxel::ui {
namespace {

/// A triangle in its own plane. The origin is the foot of the perpendicular from the sphere's centre.
struct PlaneTriangle {
  dvec3 foot, x, y;
  std::array<dvec2, 3> corner;  // counter-clockwise

  [[nodiscard]] bool contains(const dvec2& p) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const dvec2 e = corner[(k + 1) % 3] - corner[k], d = p - corner[k];
      if (e.x * d.y - e.y * d.x < 0) return false;
    }
    return true;
  }
  [[nodiscard]] dvec3 lift(double angle, double r) const {
    return foot + r * (std::cos(angle) * x + std::sin(angle) * y);
  }
};

PlaneTriangle in_own_plane(const TriMesh& mesh, int face, const dvec3& center) {
  const dvec3& n = mesh.face_normals()[static_cast<std::size_t>(face)];
  PlaneTriangle t;
  t.foot = center - glm::dot(center - mesh.vertex(face, 0), n) * n;
  t.x = any_perpendicular(n);
  t.y = glm::cross(n, t.x);
  for (int k = 0; k < 3; ++k) {
    const dvec3 d = mesh.vertex(face, k) - t.foot;
    t.corner[static_cast<std::size_t>(k)] = {glm::dot(d, t.x), glm::dot(d, t.y)};
  }
  return t;
}

/// Returns the angles at which the circle of radius r about the origin crosses the sides, ascending.
std::vector<double> crossings(const PlaneTriangle& t, double r) {
  std::vector<double> angles;
  for (std::size_t k = 0; k < 3; ++k) {
    const dvec2 p = t.corner[k], d = t.corner[(k + 1) % 3] - p;
    const double a = glm::dot(d, d), b = glm::dot(p, d), c = glm::dot(p, p) - r * r;  // a s^2 + 2 b s + c = 0
    const double discriminant = b * b - a * c;
    if (!(discriminant > 0)) continue;
    for (const double sign : {-1.0, 1.0}) {
      const double s = (-b + sign * std::sqrt(discriminant)) / a;
      if (s < 0 || s > 1) continue;
      const dvec2 q = p + s * d;
      angles.push_back(std::atan2(q.y, q.x));
    }
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

/// Appends the pieces of the circle of radius r about the origin that are inside the triangle.
void append_arcs(const PlaneTriangle& t, double r, int face, double step, std::vector<RingPiece>& out) {
  std::vector<double> angles = crossings(t, r);
  if (angles.empty()) angles.push_back(-kPi);  // the circle is entirely inside or outside
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double from = angles[i];
    const double to = i + 1 < angles.size() ? angles[i + 1] : angles[0] + 2 * kPi;
    const double middle = 0.5 * (from + to);
    if (!(to > from) || !t.contains(r * dvec2(std::cos(middle), std::sin(middle)))) continue;
    const int pieces = std::max(1, static_cast<int>(std::ceil((to - from) / step)));
    for (int k = 0; k < pieces; ++k) {
      out.push_back(
          {t.lift(from + (to - from) * k / pieces, r), t.lift(from + (to - from) * (k + 1) / pieces, r), face});
    }
  }
}

}  // namespace

std::vector<RingPiece> field_ring(const MeshIndex& skin, const dvec3& center, double radius, const dvec3& normal,
                                  double max_angle_deg, double step_deg) {
  const TriMesh& mesh = skin.mesh();
  const double least = std::cos(glm::radians(max_angle_deg)) * glm::length(normal);
  const double step = glm::radians(step_deg);
  std::vector<RingPiece> out;
  for (const int f : skin.faces_near(center, radius)) {
    const dvec3& n = mesh.face_normals()[static_cast<std::size_t>(f)];
    if (glm::dot(n, normal) <= least) continue;
    const double h = glm::dot(center - mesh.vertex(f, 0), n);  // height above the plane
    if (std::abs(h) >= radius) continue;
    append_arcs(in_own_plane(mesh, f, center), std::sqrt(radius * radius - h * h), f, step, out);
  }
  return out;
}

namespace {

/// Returns the ring of a disc by the rule. With interpolated normals, the pieces end within `step_deg` of the limit.
std::vector<RingPiece> disc_ring(const MeshIndex& skin, const FieldDisc& disc, const ReceptiveFieldRule& rule,
                                 double step_deg) {
  if (rule.normals == FieldNormals::face)
    return field_ring(skin, disc.center, disc.radius, disc.normal, rule.max_angle_deg, step_deg);
  std::vector<RingPiece> ring = field_ring(skin, disc.center, disc.radius, disc.normal, 180.0, step_deg);
  const FieldAngle angle(rule);
  std::erase_if(ring, [&](const RingPiece& piece) {
    const dvec3 normal = skin_normal(skin.mesh(), piece.face, 0.5 * (piece.a + piece.b));
    return !(disc.facing(normal, angle) > 0);
  });
  return ring;
}

}  // namespace

std::vector<RingPiece> taxel_rings(const MeshIndex& skin, const Taxel& taxel, const ReceptiveFieldRule& rule,
                                   double step_deg) {
  std::vector<RingPiece> out;
  for (const FieldDisc& disc : discs_of(taxel)) {
    const std::vector<RingPiece> ring = disc_ring(skin, disc, rule, step_deg);
    out.insert(out.end(), ring.begin(), ring.end());
  }
  return out;
}

}  // namespace taxel::ui
