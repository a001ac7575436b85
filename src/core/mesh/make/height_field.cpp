#include "core/mesh/make/height_field.h"

#include <fmt/format.h>

#include "core/base/error.h"

namespace taxel {
namespace {

void check(const HeightField& field) {
  if (field.rows < 2 || field.columns < 2)
    throw Error(fmt::format("a height field needs 2 rows and 2 columns, not {} x {}", field.rows, field.columns));
  const auto count = static_cast<std::size_t>(field.rows) * static_cast<std::size_t>(field.columns);
  if (field.elevation.size() != count)
    throw Error(fmt::format("{} elevations for {} x {} points", field.elevation.size(), field.rows, field.columns));
  for (const double size : {field.size.x, field.size.y, field.size.z, field.base}) {
    if (!(size > 0) || !std::isfinite(size))
      throw Error(fmt::format("sizes and base of a height field must be positive, not {}", size));
  }
  for (std::size_t i = 0; i < count; ++i) {
    const double height = field.elevation[i] * field.size.z;
    if (!std::isfinite(height) || !(height > -field.base))
      throw Error(fmt::format("elevation {} must be finite and above the base, is {}", i, field.elevation[i]));
  }
}

/// Returns the points of the grid's rim, counter-clockwise seen from above.
std::vector<int> rim_of(int rows, int columns) {
  std::vector<int> rim;
  for (int c = 0; c < columns; ++c) rim.push_back(c);
  for (int r = 1; r < rows; ++r) rim.push_back(r * columns + columns - 1);
  for (int c = columns - 2; c >= 0; --c) rim.push_back((rows - 1) * columns + c);
  for (int r = rows - 2; r > 0; --r) rim.push_back(r * columns);
  return rim;
}

}  // namespace

TriMesh make_height_field(const HeightField& field) {
  check(field);
  std::vector<dvec3> vertices;
  std::vector<ivec3> faces;
  for (int r = 0; r < field.rows; ++r) {
    for (int c = 0; c < field.columns; ++c) {
      const double height = field.elevation[static_cast<std::size_t>(r * field.columns + c)] * field.size.z;
      vertices.emplace_back(2 * field.size.x / (field.columns - 1) * c - field.size.x,
                            2 * field.size.y / (field.rows - 1) * r - field.size.y, height);
    }
  }
  for (int r = 0; r + 1 < field.rows; ++r) {
    for (int c = 0; c + 1 < field.columns; ++c) {
      const int low = r * field.columns + c, right = low + 1, up = low + field.columns, high = up + 1;
      faces.emplace_back(low, right, high);
      faces.emplace_back(low, high, up);
    }
  }
  const std::vector<int> rim = rim_of(field.rows, field.columns);
  const int foot = static_cast<int>(vertices.size()), count = static_cast<int>(rim.size()), middle = foot + count;
  for (const int i : rim) {
    const dvec3& top = vertices[static_cast<std::size_t>(i)];
    vertices.emplace_back(top.x, top.y, -field.base);
  }
  vertices.emplace_back(0, 0, -field.base);
  for (int i = 0; i < count; ++i) {
    const int next = (i + 1) % count, a = rim[static_cast<std::size_t>(i)], b = rim[static_cast<std::size_t>(next)];
    faces.emplace_back(foot + i, foot + next, b);
    faces.emplace_back(foot + i, b, a);
    faces.emplace_back(middle, foot + next, foot + i);
  }
  return {std::move(vertices), std::move(faces)};
}

}  // namespace taxel
