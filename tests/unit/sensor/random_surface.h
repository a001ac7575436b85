// Generated contact surfaces: convex planar polygons with a linear pressure.
#pragma once

#include "core/base/rng.h"
#include "core/hydro/contact_surface.h"

namespace taxel {

/// Adds a convex polygon with the given corners in order and p0(x) = base + dot(slope, x).
inline void add_polygon(ContactSurface& surface, const std::vector<dvec3>& corners, double base, const dvec3& slope) {
  ContactPolygon polygon;
  polygon.first = static_cast<int>(surface.vertices.size());
  polygon.count = static_cast<int>(corners.size());
  dvec3 area(0), moment(0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    surface.vertices.push_back(corners[i]);
    surface.pressure.push_back(base + glm::dot(slope, corners[i]));
    if (i < 2) continue;
    const dvec3 twice = glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    area += 0.5 * twice;
    moment += 0.5 * glm::length(twice) * (corners[0] + corners[i - 1] + corners[i]) / 3.0;
  }
  polygon.area = glm::length(area);
  polygon.normal = glm::normalize(area);
  polygon.centroid = moment / polygon.area;
  polygon.pressure = base + glm::dot(slope, polygon.centroid);
  polygon.gradient = slope - glm::dot(slope, polygon.normal) * polygon.normal;
  surface.polygons.push_back(polygon);
}

/// Returns `count` polygons of 3 to 8 corners, about `size` wide, at random places in the unit cube.
inline ContactSurface random_surface(int count, double size, std::uint64_t seed) {
  ContactSurface surface;
  const CounterRng rng(seed);
  std::uint64_t next = 0;
  const auto uniform = [&] { return rng.uniform(next++); };
  const auto vector = [&] {
    const double x = uniform(), y = uniform(), z = uniform();
    return dvec3(x, y, z);
  };
  for (int i = 0; i < count; ++i) {
    const dvec3 center = vector(), normal = glm::normalize(vector() - 0.5), slope = vector() * 1e5;
    const dvec3 u = any_perpendicular(normal), v = glm::cross(normal, u);
    const int corners = 3 + static_cast<int>(6.0 * uniform());
    const double radius = size * (0.2 + uniform()), phase = uniform();
    std::vector<dvec3> loop;
    for (int c = 0; c < corners; ++c) {
      const double angle = 2.0 * kPi * (c + 0.8 * uniform() + phase) / corners;
      loop.push_back(center + radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
    add_polygon(surface, loop, 1e6, slope);
  }
  return surface;
}

}  // namespace taxel
