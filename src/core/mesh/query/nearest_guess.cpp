#include "core/mesh/query/nearest_guess.h"

#include <algorithm>

#include "core/base/index.h"
#include "core/base/parallel.h"
#include "core/mesh/query/point_triangle.h"

namespace taxel {

NearestGuess::NearestGuess(const MeshIndex& index, double most) : index_(index), most_(most) {
  const TriMesh& mesh = index.mesh();
  const dvec3 reach = glm::max(glm::abs(mesh.bounds().lo), glm::abs(mesh.bounds().hi));
  slack_ = 1e-12 * (reach.x + reach.y + reach.z);
  std::vector<std::vector<int>> around(at(mesh.face_count()));
  parallel_chunks(mesh.face_count(), 64, [&](int begin, int end) {
    for (int f = begin; f < end; ++f) around[at(f)] = faces_around(f);
  });
  first_.assign(1, 0);
  for (const std::vector<int>& faces : around) {
    for (const int other : faces) {
      const dvec3& n = mesh.face_normals()[at(other)];
      around_.push_back(other);
      nx_.push_back(n.x), ny_.push_back(n.y), nz_.push_back(n.z);
      offset_.push_back(-glm::dot(n, mesh.vertex(other, 0)));
    }
    first_.push_back(static_cast<std::uint32_t>(around_.size()));
  }
}

/// Returns the faces that a ball of radius most_ or less may reach if it touches a face from behind, ascending.
std::vector<int> NearestGuess::faces_around(int face) const {
  const TriMesh& mesh = index_.mesh();
  // The balls are within most_ of a point most_ behind the face.
  const dvec3 &a = mesh.vertex(face, 0), &b = mesh.vertex(face, 1), &c = mesh.vertex(face, 2);
  const dvec3 middle = (a + b + c) / 3.0;
  const double r = std::max({glm::distance(middle, a), glm::distance(middle, b), glm::distance(middle, c)});
  std::vector<int> faces = index_.faces_near(middle - most_ * mesh.face_normals()[at(face)], most_ + r);
  std::erase_if(faces, [&](int other) { return other == face || !may_be_nearer(face, other); });
  return faces;
}

/// Returns false only if no ball of radius most_ or less that touches a face from behind reaches another face. The ball
/// at s that reaches y has the radius |y - s|^2 / (2 n (s - y)). For a part of the face with the middle c and the
/// circumradius r, |y - s| >= |y - c| - r, and n (s - y) = n (c - y) is largest at a corner of the other face.
bool NearestGuess::may_be_nearer(int face, int other) const {
  const TriMesh& mesh = index_.mesh();
  const dvec3 &a = mesh.vertex(face, 0), &b = mesh.vertex(face, 1), &c = mesh.vertex(face, 2);
  const dvec3& n = mesh.face_normals()[at(face)];
  double below = 0;
  for (int i = 0; i < 3; ++i) below = std::max(below, glm::dot(n, a - mesh.vertex(other, i)));
  if (!(below > 0)) return false;
  const double clear = std::sqrt(2 * below * most_);
  const dvec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
  for (const std::array<dvec3, 3>& part :
       {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}, std::array{bc, ca, ab}}) {
    const dvec3 middle = (part[0] + part[1] + part[2]) / 3.0;
    const double r =
        std::max({glm::distance(middle, part[0]), glm::distance(middle, part[1]), glm::distance(middle, part[2])});
    const TrianglePoint q =
        nearest_on_triangle(middle, mesh.vertex(other, 0), mesh.vertex(other, 1), mesh.vertex(other, 2));
    if (std::sqrt(q.squared_distance) - r <= clear) return true;
  }
  return false;
}

/// Returns the face around `face` whose plane is nearest to x, if it is nearer than `within`, otherwise -1.
int NearestGuess::nearer_plane(int face, const dvec3& x, double within) const {
  const std::uint32_t first = first_[at(face)], end = first_[at(face) + 1];
  bool any = false;
  for (std::uint32_t i = first; i < end; ++i)
    any |= std::abs(nx_[i] * x.x + ny_[i] * x.y + nz_[i] * x.z + offset_[i]) < within;
  int nearest = -1;
  if (!any) return nearest;
  for (std::uint32_t i = first; i < end; ++i) {
    const double away = std::abs(nx_[i] * x.x + ny_[i] * x.y + nz_[i] * x.z + offset_[i]);
    if (away < within) within = away, nearest = around_[i];
  }
  return nearest;
}

/// Returns the face across the edge that the nearest point of a face is on, or -1.
int NearestGuess::across(int face, const dvec3& barycentric) const {
  const int e = barycentric.z == 0 ? 0 : barycentric.x == 0 ? 1 : 2;  // edge e runs from corner e to the next one
  return index_.mesh().topology().face_across(3 * face + e);
}

SurfacePoint NearestGuess::closest_point(const dvec3& x, int& guess) const {
  const TriMesh& mesh = index_.mesh();
  constexpr int kSteps = 8;
  double within = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kSteps && guess >= 0; ++i) {
    const int f = guess;
    const TrianglePoint q = nearest_on_triangle(x, mesh.vertex(f, 0), mesh.vertex(f, 1), mesh.vertex(f, 2));
    const double h = std::sqrt(q.squared_distance);
    const bool nearer_than_before = h < within;
    within = std::min(within, h);
    if (!(q.barycentric.x > 0 && q.barycentric.y > 0 && q.barycentric.z > 0)) {
      if (!nearer_than_before) break;  // the walk turns back, as below a concave edge
      guess = across(f, q.barycentric);
      continue;
    }
    const bool behind = glm::dot(mesh.face_normals()[at(f)], x - mesh.vertex(f, 0)) <= 0;
    if (!behind || h > most_) break;
    const int nearer = nearer_plane(f, x, h - slack_);
    if (nearer < 0) return {q.position, f, q.barycentric, h};
    guess = nearer;
  }
  const SurfacePoint s = index_.closest_point(x, within);
  guess = s.face;
  return s;
}

}  // namespace taxel
