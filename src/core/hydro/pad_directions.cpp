#include "core/hydro/pad_directions.h"

#include <span>

namespace taxel {
namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

double least_cosine(const dvec3& direction, std::span<const dvec3> normals) {
  double least = 1;
  for (const dvec3& n : normals) least = std::min(least, glm::dot(direction, n));
  return least;
}

/// Centre of the smallest cap that holds all normals: that of their smallest enclosing ball, by Badoiu and Clarkson
/// (2003), which steps towards the farthest one by 1/(i + 1) in round i.
dvec3 middle_direction(std::span<const dvec3> normals) {
  constexpr int kRounds = 300;
  dvec3 center = normals[0];
  for (int i = 1; i <= kRounds; ++i) {
    const dvec3* farthest = &normals[0];
    double most = -1;
    for (const dvec3& n : normals) {
      const double d = glm::dot(n - center, n - center);
      if (d > most) {
        most = d;
        farthest = &n;
      }
    }
    center += (*farthest - center) / (i + 1.0);
  }
  const double length = glm::length(center);
  return length > 0 ? center / length : normals[0];
}

}  // namespace

std::vector<PadDirection> pad_directions(const TriMesh& mesh) {
  constexpr double kGoodCosine = 0.5;
  std::vector<std::vector<dvec3>> around(mesh.vertices().size());
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (int c = 0; c < 3; ++c) around[at(mesh.faces()[at(f)][c])].push_back(mesh.face_normals()[at(f)]);
  }
  std::vector<PadDirection> directions(mesh.vertices().size());
  for (std::size_t v = 0; v < directions.size(); ++v) {
    if (around[v].empty()) continue;
    dvec3 outward = mesh.vertex_normals()[v];
    double least = least_cosine(outward, around[v]);
    if (least < kGoodCosine) {
      const dvec3 middle = middle_direction(around[v]);
      const double better = least_cosine(middle, around[v]);
      if (better > least) {
        outward = middle;
        least = better;
      }
    }
    directions[v] = {-outward, least};
  }
  return directions;
}

}  // namespace taxel
