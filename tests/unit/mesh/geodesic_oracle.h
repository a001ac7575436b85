// Geodesic distances by exhaustive search, which share only the mesh with the library. Every sequence of faces is
// unfolded from its side lengths in long double, which gives the straight paths between points and vertices. The
// shortest chain of straight paths is the distance.
#pragma once

#include <algorithm>
#include <complex>
#include <map>
#include <vector>

#include "core/base/math.h"
#include "core/mesh/tri_mesh.h"

namespace taxel::test {

struct OnSurface {
  int face = 0;
  dvec3 weights{1, 0, 0};  ///< barycentric coordinates
  [[nodiscard]] dvec3 position(const TriMesh& mesh) const {
    return weights.x * mesh.vertex(face, 0) + weights.y * mesh.vertex(face, 1) + weights.z * mesh.vertex(face, 2);
  }
};

class GeodesicOracle {
 public:
  using Real = long double;
  using Plane = std::complex<Real>;

  /// Paths longer than `longest` are not searched.
  GeodesicOracle(const TriMesh& mesh, Real longest) : mesh_(mesh), longest_(longest) {
    for (int f = 0; f < mesh.face_count(); ++f)
      for (int c = 0; c < 3; ++c) {
        faces_at_[edge(corner(f, c), corner(f, c + 1))].push_back(f);
        faces_around_[corner(f, c)].push_back(f);
      }
    for (int v = 0; v < mesh.vertex_count(); ++v) from_vertex_.push_back(straight_from_vertex(v));
  }

  /// Finds the smallest lengths of all straight paths from a point to the vertices and the targets.
  std::vector<Real> distances(const OnSurface& from, const std::vector<OnSurface>& targets) {
    std::vector<Real> to_vertex(static_cast<std::size_t>(mesh_.vertex_count()), infinite()), to_target;
    targets_ = &targets;
    Straight first = straight_from_point(from);
    to_vertex = first.vertices;
    relax(to_vertex);
    to_target = first.targets;
    for (std::size_t t = 0; t < targets.size(); ++t) {
      const std::vector<OnSurface> none;
      targets_ = &none;
      const Straight back = straight_from_point(targets[t]);
      for (std::size_t v = 0; v < to_vertex.size(); ++v)
        to_target[t] = std::min(to_target[t], to_vertex[v] + back.vertices[v]);
    }
    return to_target;
  }

 private:
  struct Straight {
    std::vector<Real> vertices, targets;
  };
  static Real infinite() { return std::numeric_limits<Real>::infinity(); }
  static std::pair<int, int> edge(int a, int b) { return std::minmax(a, b); }
  [[nodiscard]] int corner(int face, int c) const { return mesh_.faces()[static_cast<std::size_t>(face)][c % 3]; }
  static Real cross(Plane a, Plane b) { return a.real() * b.imag() - a.imag() * b.real(); }
  [[nodiscard]] Real side(int a, int b) const {
    const dvec3 &p = mesh_.vertices()[static_cast<std::size_t>(a)], &q = mesh_.vertices()[static_cast<std::size_t>(b)];
    const Real x = Real(p.x) - q.x, y = Real(p.y) - q.y, z = Real(p.z) - q.z;
    return std::sqrt(x * x + y * y + z * z);
  }
  /// Returns the third corner of a triangle left of a -> b, from its three sides.
  [[nodiscard]] Plane third(Plane a, Plane b, Real ab, Real bc, Real ca) const {
    const Real along = (ab * ab + ca * ca - bc * bc) / (2 * ab);
    const Real up = std::sqrt(std::max(Real(0), ca * ca - along * along));
    return a + (b - a) / ab * Plane(along, up);
  }

  void relax(std::vector<Real>& d) {
    std::vector<char> done(d.size(), 0);
    for (std::size_t round = 0; round < d.size(); ++round) {
      std::size_t best = d.size();
      for (std::size_t v = 0; v < d.size(); ++v)
        if (!done[v] && (best == d.size() || d[v] < d[best])) best = v;
      done[best] = 1;
      for (std::size_t v = 0; v < d.size(); ++v) d[v] = std::min(d[v], d[best] + from_vertex_[best].vertices[v]);
    }
  }

  Straight fresh() const {
    return {std::vector<Real>(static_cast<std::size_t>(mesh_.vertex_count()), infinite()),
            std::vector<Real>(targets_ ? targets_->size() : 0, infinite())};
  }
  /// Places the source at the origin of the plane and the corners of its face around it.
  void see_whole_face(int face, const Plane (&p)[3], Straight& out) {
    visited_.assign(static_cast<std::size_t>(mesh_.face_count()), 0);
    visited_[static_cast<std::size_t>(face)] = 1;
    for (int c = 0; c < 3; ++c)
      out.vertices[at(corner(face, c))] = std::min(out.vertices[at(corner(face, c))], std::abs(p[c]));
    note_targets(face, p, 0, 0, true, out);
    for (int c = 0; c < 3; ++c) cross_edge(face, c, p[c], p[(c + 1) % 3], p[c], p[(c + 1) % 3], out);
  }

  Straight straight_from_vertex(int v) {
    Straight out = fresh();
    for (const int f : faces_around_[v]) {
      int c = 0;
      while (corner(f, c) != v) ++c;
      Plane p[3];
      const int a = corner(f, c + 1), b = corner(f, c + 2);
      p[c] = 0;
      p[(c + 1) % 3] = side(v, a);
      p[(c + 2) % 3] = third(0, side(v, a), side(v, a), side(a, b), side(b, v));
      see_whole_face(f, p, out);
    }
    return out;
  }
  Straight straight_from_point(const OnSurface& from) {
    Straight out = fresh();
    const int a = corner(from.face, 0), b = corner(from.face, 1), c = corner(from.face, 2);
    const Plane pb = side(a, b), pc = third(0, pb, side(a, b), side(b, c), side(c, a));
    const Plane at = Real(from.weights.y) * pb + Real(from.weights.z) * pc;
    const Plane p[3] = {-at, pb - at, pc - at};
    see_whole_face(from.face, p, out);
    return out;
  }
  void note_targets(int face, const Plane (&p)[3], Plane left, Plane right, bool all, Straight& out) {
    if (!targets_) return;
    for (std::size_t t = 0; t < targets_->size(); ++t) {
      const OnSurface& target = (*targets_)[t];
      if (target.face != face) continue;
      const Plane at = Real(target.weights.x) * p[0] + Real(target.weights.y) * p[1] + Real(target.weights.z) * p[2];
      if (all || (cross(right, at) >= -tolerance(right, at) && cross(at, left) >= -tolerance(at, left)))
        out.targets[t] = std::min(out.targets[t], std::abs(at));
    }
  }
  /// Weights sum to 1 only up to the rounding of doubles.
  static Real tolerance(Plane a, Plane b) { return 1e-14L * std::abs(a) * std::abs(b); }

  /// Leaves `face` across its edge from a (at pa) to b, seen from the origin between the rays to `right` and `left`,
  /// clockwise and counter-clockwise. The face is left of a -> b.
  void cross_edge(int face, int c, Plane pa, Plane pb, Plane right, Plane left, Straight& out) {
    const int a = corner(face, c), b = corner(face, c + 1);
    for (const int g : faces_at_[edge(a, b)]) {
      if (visited_[at(g)]) continue;
      visited_[at(g)] = 1;
      int k = 0;
      while (!(corner(g, k) == b && corner(g, k + 1) == a)) ++k;
      const int v = corner(g, k + 2);
      const Plane pv = third(pb, pa, side(a, b), side(a, v), side(v, b));
      Plane p[3];
      p[k] = pb, p[(k + 1) % 3] = pa, p[(k + 2) % 3] = pv;
      const bool right_of_left = cross(pv, left) >= -tolerance(pv, left);
      const bool left_of_right = cross(right, pv) >= -tolerance(right, pv);
      if (right_of_left && left_of_right) out.vertices[at(v)] = std::min(out.vertices[at(v)], std::abs(pv));
      note_targets(g, p, left, right, false, out);
      // The origin is left of a -> b, so b is counter-clockwise of a: the edge a-v is on the right, v-b on the left.
      if (cross(right, pv) > 0 && near(pa, pv))
        cross_edge(g, (k + 1) % 3, pa, pv, right, right_of_left ? pv : left, out);
      if (cross(pv, left) > 0 && near(pv, pb))
        cross_edge(g, (k + 2) % 3, pv, pb, left_of_right ? pv : right, left, out);
      visited_[at(g)] = 0;
    }
  }
  [[nodiscard]] bool near(Plane a, Plane b) const {
    const Plane ab = b - a;
    const Real t = std::clamp(-(std::conj(ab) * a).real() / std::norm(ab), Real(0), Real(1));
    return std::abs(a + t * ab) < longest_;
  }

  const TriMesh& mesh_;
  Real longest_;
  std::map<std::pair<int, int>, std::vector<int>> faces_at_;
  std::map<int, std::vector<int>> faces_around_;
  std::vector<Straight> from_vertex_;
  const std::vector<OnSurface>* targets_ = nullptr;
  std::vector<char> visited_;
};

}  // namespace taxel::test
