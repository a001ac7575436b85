// What a mesh file says, before anything is repaired.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/math.h"

namespace taxel {

/// Vertices as listed in the file and triangles over them (polygons are fanned). Indices are in range, coordinates
/// finite: the readers throw Error that names file and line (or byte) otherwise.
struct PolygonSoup {
  std::vector<dvec3> vertices;
  std::vector<ivec3> triangles;
  int fanned = 0;   ///< polygons of more than three corners
  int skipped = 0;  ///< polygons of fewer than three corners

  void add_polygon(std::span<const int> corners) {
    if (corners.size() < 3) ++skipped;
    if (corners.size() > 3) ++fanned;
    constexpr std::size_t kMaxFan = 64;
    if (corners.size() > kMaxFan) return halve_polygon(corners);
    for (std::size_t i = 2; i < corners.size(); ++i) triangles.emplace_back(corners[0], corners[i - 1], corners[i]);
  }

  /// Cuts a polygon of many corners in two, again and again. In a fan every triangle would overlap every other one's
  /// box, and a search for cuts would take quadratic time.
  void halve_polygon(std::span<const int> corners) {
    if (corners.size() < 3) return;
    const std::size_t middle = corners.size() / 2;
    halve_polygon(corners.subspan(0, middle + 1));
    triangles.emplace_back(corners.front(), corners[middle], corners.back());
    halve_polygon(corners.subspan(middle));
  }
};

/// Readers of whole files in memory; `file` is for messages.
PolygonSoup read_obj(std::string_view bytes, const std::string& file);
PolygonSoup read_stl(std::string_view bytes, const std::string& file);
PolygonSoup read_ply(std::string_view bytes, const std::string& file);
PolygonSoup read_off(std::string_view bytes, const std::string& file);

}  // namespace taxel
