// Section of the mesh at right angles to y:
//
//             __          arc of 90 degrees between the two upper sides: its centre is `radius` sqrt(2) below the
//           /    \        sharp edge, because the sides descend by 45 degrees
//         /        \      .
//         \        /      .
//           \    /        .
//             \/          z = 0
#include "core/run/motion/upright_edge.h"

#include <cmath>

namespace taxel {
namespace {

/// Number of sides of the polygon that replaces the arc. Half of a side spans 1.4 degrees: 1 - cos(1.4 deg) = 3e-4.
constexpr int kArcSides = 32;

/// Returns the corners (x, z) of the section, counter-clockwise from x to z, from the lower edge.
std::vector<dvec2> section(double size, double radius) {
  const double half = size * std::sqrt(0.5);  // half of the diagonal
  const double center = 2 * half - std::sqrt(2.0) * radius;
  std::vector<dvec2> corners{{0, 0}, {half, half}};
  for (int i = 0; i <= kArcSides; ++i) {
    const double angle = kPi / 4 + kPi / 2 * i / kArcSides;
    corners.emplace_back(radius * std::cos(angle), center + radius * std::sin(angle));
  }
  corners.emplace_back(-half, half);
  return corners;
}

}  // namespace

double height_of_round(double radius) {
  return (std::sqrt(2.0) - 1) * radius;
}

TriMesh make_upright_edge(double size, double radius) {
  const std::vector<dvec2> corners = section(size, radius);
  const int n = static_cast<int>(corners.size());
  std::vector<dvec3> vertices;
  for (const dvec2& corner : corners)
    for (const double y : {-0.5 * size, 0.5 * size}) vertices.emplace_back(corner.x, y, corner.y);
  std::vector<ivec3> faces;
  for (int i = 0; i < n; ++i) {  // vertex 2 i has the smaller y, vertex 2 i + 1 the larger
    const int j = (i + 1) % n;
    faces.emplace_back(2 * i, 2 * i + 1, 2 * j + 1);
    faces.emplace_back(2 * i, 2 * j + 1, 2 * j);
  }
  for (int i = 1; i + 1 < n; ++i) {  // both ends are fans about the lower edge: the section is convex
    faces.emplace_back(0, 2 * i, 2 * (i + 1));
    faces.emplace_back(1, 2 * (i + 1) + 1, 2 * i + 1);
  }
  return TriMesh(std::move(vertices), std::move(faces));
}

}  // namespace taxel
