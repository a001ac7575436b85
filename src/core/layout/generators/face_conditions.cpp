// The faces of a mesh that satisfy conditions on their place and direction.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "core/base/error.h"
#include "core/base/text/expression.h"
#include "core/layout/generators/generated_layout.h"

namespace taxel {
namespace {

struct FaceCondition {
  int axis = 0;          ///< component of the vector
  bool normal = false;   ///< true for the normal, false for the centroid
  bool greater = false;  ///< true for >, false for <
  double bound = 0;      ///< [m] for a place
};

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == std::string_view::npos ? "" : std::string(text.substr(first, last - first + 1));
}

FaceCondition parse_condition(const std::string& text) {
  constexpr std::array<std::string_view, 6> kVariables{"x", "y", "z", "nx", "ny", "nz"};
  const std::size_t sign = text.find_first_of("<>");
  if (sign == std::string::npos)
    throw Error("", "region", fmt::format("\"{}\" has no < or >; write it as in \"z > 5 mm, ny < -0.3\"", text));
  const std::string name = trimmed(std::string_view(text).substr(0, sign));
  const auto variable = std::find(kVariables.begin(), kVariables.end(), name);
  if (variable == kVariables.end())
    throw Error(
        "", "region",
        fmt::format("\"{}\": the variable must be x, y, z (place) or nx, ny, nz (normal), is \"{}\"", text, name));
  const auto number = static_cast<int>(variable - kVariables.begin());
  FaceCondition condition{number % 3, number >= 3, text[sign] == '>', 0};
  try {
    condition.bound = evaluate(trimmed(std::string_view(text).substr(sign + 1)), condition.normal ? "" : "m");
  } catch (const Error& error) {
    throw Error("", "region", fmt::format("\"{}\": {}", text, error.message()));
  }
  return condition;
}

}  // namespace

std::vector<int> faces_where(std::string_view conditions, const TriMesh& mesh) {
  std::vector<FaceCondition> all;
  for (std::size_t begin = 0; begin <= conditions.size();) {
    const std::size_t end = std::min(conditions.find(',', begin), conditions.size());
    all.push_back(parse_condition(trimmed(conditions.substr(begin, end - begin))));
    begin = end + 1;
  }
  std::vector<int> faces;
  for (int face = 0; face < mesh.face_count(); ++face) {
    const dvec3 middle = (mesh.vertex(face, 0) + mesh.vertex(face, 1) + mesh.vertex(face, 2)) / 3.0;
    const dvec3& normal = mesh.face_normals()[static_cast<std::size_t>(face)];
    const bool holds = std::all_of(all.begin(), all.end(), [&](const FaceCondition& c) {
      const double value = (c.normal ? normal : middle)[c.axis];
      return c.greater ? value > c.bound : value < c.bound;
    });
    if (holds) faces.push_back(face);
  }
  if (faces.empty()) throw Error("", "region", fmt::format("no face of the mesh satisfies \"{}\"", conditions));
  return faces;
}

}  // namespace taxel
