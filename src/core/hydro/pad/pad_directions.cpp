#include "core/hydro/pad/pad_directions.h"

#include <span>

#include "core/base/index.h"

namespace taxel {
namespace {

double least_cosine(const dvec3& direction, std::span<const dvec3> normals) {
  double least = 1;
  for (const dvec3& n : normals) least = std::min(least, glm::dot(direction, n));
  return least;
}

/// Returns the centre of the smallest cap that contains all normals, computed from their smallest enclosing ball
/// (Badoiu and Clarkson 2003): round i moves the centre towards the farthest normal by 1/(i + 1) of the distance.
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

struct Around {
  double area;
  dvec3 normal;
};

/// Sorts the faces around one vertex by area, largest first, and returns their normals.
std::vector<dvec3> by_area(std::vector<Around>& faces) {
  std::stable_sort(faces.begin(), faces.end(), [](const Around& a, const Around& b) { return a.area > b.area; });
  std::vector<dvec3> normals;
  for (const Around& face : faces) normals.push_back(face.normal);
  return normals;
}

PadDirection direction_of(const dvec3& angle_weighted, std::vector<Around>& faces) {
  constexpr double kGoodCosine = 0.5, kPoorCosine = 0.2, kNegligibleArea = 0.05;
  const std::vector<dvec3> normals = by_area(faces);
  double least = least_cosine(angle_weighted, normals);
  if (least >= kGoodCosine) return {-angle_weighted, least};
  double area = 0, left_out = 0;
  for (const Around& face : faces) area += face.area;
  dvec3 best = angle_weighted;
  for (std::size_t count = normals.size(); count > 0; --count) {
    const std::span<const dvec3> kept(normals.data(), count);
    const dvec3 middle = middle_direction(kept);
    const double cosine = least_cosine(middle, kept);
    if (cosine > least) {
      best = middle;
      least = cosine;
    }
    left_out += faces[count - 1].area;
    if (least >= kPoorCosine || left_out > kNegligibleArea * area) break;
  }
  return {-best, least};
}

}  // namespace

PadDirection pad_direction(const TriMesh& mesh, int vertex, std::span<const int> faces) {
  std::vector<Around> around;
  dvec3 sum{0};
  for (const int f : faces) {
    const dvec3& normal = mesh.face_normals()[at(f)];
    around.push_back({mesh.face_areas()[at(f)], normal});
    const ivec3& corners = mesh.faces()[at(f)];
    const int c = corners.x == vertex ? 0 : corners.y == vertex ? 1 : 2;
    const dvec3 a = mesh.vertex(f, (c + 1) % 3) - mesh.vertex(f, c),
                b = mesh.vertex(f, (c + 2) % 3) - mesh.vertex(f, c);
    sum += std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * normal;
  }
  const double length = glm::length(sum);
  return direction_of(length > 0 ? sum / length : around.front().normal, around);
}

std::vector<PadDirection> pad_directions(const TriMesh& mesh) {
  std::vector<std::vector<Around>> around(mesh.vertices().size());
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (int c = 0; c < 3; ++c)
      around[at(mesh.faces()[at(f)][c])].push_back({mesh.face_areas()[at(f)], mesh.face_normals()[at(f)]});
  }
  std::vector<PadDirection> directions(mesh.vertices().size());
  for (std::size_t v = 0; v < directions.size(); ++v) {
    if (!around[v].empty()) directions[v] = direction_of(mesh.vertex_normals()[v], around[v]);
  }
  return directions;
}

}  // namespace taxel
