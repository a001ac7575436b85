#include "core/hydro/pad/pad_refine.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "core/base/index.h"
#include "core/base/parallel.h"
#include "core/hydro/pad/pad_press.h"
#include "core/hydro/pad/pad_pressures.h"

namespace taxel {
namespace {

/// Cosine to a face's normal above which all legs must be for an even face.
constexpr double kStraight = 0.9;
/// Largest relative difference of the pressure of an even face from E depth/H.
constexpr double kEvenPressure = 0.03;
/// Depth of the points at which the pressure is tested, in thicknesses.
constexpr double kTried = 0.1;

/// An edge with its length and the indices of its ends. Edges are sorted, longest first.
struct FaceEdge {
  double squared_length;
  int low, high;
  int face, corner;  ///< one of its faces, and the corner from which the edge leads to the next
  bool operator<(const FaceEdge& other) const {
    return std::tie(other.squared_length, low, high) < std::tie(squared_length, other.low, other.high);
  }
  bool operator==(const FaceEdge& other) const { return low == other.low && high == other.high; }
};

/// Returns the faces across the edges from corner c to c + 1 of every face of a closed mesh.
std::vector<ivec3> faces_across(const EdgeTopology& topology) {
  std::vector<ivec3> across(topology.faces().size());
  for (int h = 0; h < topology.half_edge_count(); ++h) across[at(h / 3)][h % 3] = topology.face_across(h);
  return across;
}

class Bisection {
 public:
  Bisection(const TriMesh& mesh, std::vector<char> wanted)
      : vertices_(mesh.vertices()),
        faces_(mesh.faces()),
        across_(faces_across(mesh.topology())),
        face_of_(faces_.size()) {
    std::iota(face_of_.begin(), face_of_.end(), 0);
    for (int f = 0; f < mesh.face_count(); ++f) {
      if (wanted[at(f)] != 0) wanted_.push_back(f);
    }
    is_wanted_ = std::move(wanted);
  }

  RefinedSkin run(double longest, int most_faces) {
    while (bisect_once(longest, most_faces)) {
    }
    return {std::make_shared<const TriMesh>(std::move(vertices_), std::move(faces_)), std::move(face_of_)};
  }

 private:
  FaceEdge edge(int face, int corner) const {
    const int a = faces_[at(face)][corner], b = faces_[at(face)][(corner + 1) % 3];
    const auto [low, high] = std::minmax(a, b);
    const dvec3 along = vertices_[at(high)] - vertices_[at(low)];
    return {glm::dot(along, along), low, high, face, corner};
  }
  FaceEdge longest_edge(int face) const { return std::min({edge(face, 0), edge(face, 1), edge(face, 2)}); }

  /// Returns the edge at the end of the path of longest edges from a face, which is the longest edge of both its faces.
  FaceEdge terminal_edge(FaceEdge own) const {
    for (;;) {
      const FaceEdge next = longest_edge(across_[at(own.face)][own.corner]);
      if (next == own) return own;
      own = next;
    }
  }

  /// Bisects every edge at the end of a path once; no two of these edges share a face. Returns false if there is none.
  bool bisect_once(double longest, int most_faces) {
    std::set<FaceEdge> found;
    for (const int f : wanted_) {
      const FaceEdge own = longest_edge(f);
      if (own.squared_length > longest * longest) found.insert(terminal_edge(own));
    }
    for (const FaceEdge& e : found) {
      if (static_cast<int>(faces_.size()) + 2 > most_faces) return false;
      bisect(e);
    }
    return !found.empty();
  }

  /// Replaces the face (a, b, c) by (a, m, c) and the new face (m, b, c), and divides the face across the edge in the
  /// same way.
  void bisect(const FaceEdge& e) {
    const auto m = static_cast<int>(vertices_.size());
    vertices_.push_back(0.5 * (vertices_[at(e.low)] + vertices_[at(e.high)]));
    const std::array<int, 2> old{e.face, across_[at(e.face)][e.corner]};
    const auto first_new = static_cast<int>(faces_.size());
    for (int i = 0; i < 2; ++i) {
      const int f = old[at(i)];
      int corner = 0;
      while (!(edge(f, corner) == e)) ++corner;
      const int next = (corner + 1) % 3, last = (corner + 2) % 3, beyond = across_[at(f)][next];
      ivec3 half = faces_[at(f)], half_across = across_[at(f)];
      half[corner] = m;
      half_across[corner] = old[at(1 - i)];
      half_across[last] = f;
      ivec3& seen = across_[at(beyond)];
      for (int c = 0; c < 3; ++c) {
        if (faces_[at(beyond)][c] == faces_[at(f)][last] && faces_[at(beyond)][(c + 1) % 3] == faces_[at(f)][next])
          seen[c] = first_new + i;
      }
      faces_.push_back(half);
      across_.push_back(half_across);
      if (is_wanted_[at(f)] != 0) wanted_.push_back(first_new + i);
      is_wanted_.push_back(is_wanted_[at(f)]);
      face_of_.push_back(face_of_[at(f)]);
    }
    for (int i = 0; i < 2; ++i) {
      const int f = old[at(i)];
      int corner = 0;
      while (!(edge(f, corner) == e)) ++corner;
      const int next = (corner + 1) % 3;
      faces_[at(f)][next] = m;
      across_[at(f)][corner] = first_new + 1 - i;
      across_[at(f)][next] = first_new + i;
    }
  }

  std::vector<dvec3> vertices_;
  std::vector<ivec3> faces_, across_;
  std::vector<int> face_of_, wanted_;
  std::vector<char> is_wanted_;
};

/// Returns true if a face is coarse enough and has a leg that leads away from its normal.
bool can_be_uneven(const TriMesh& mesh, const PadShape& shape, int face, double longest) {
  double edge = 0, cosine = 1;
  for (int c = 0; c < 3; ++c) {
    edge = std::max(edge, glm::distance(mesh.vertex(face, c), mesh.vertex(face, (c + 1) % 3)));
    const dvec3& inward = shape.direction(shape.leg(face, c)).direction;
    cosine = std::min(cosine, -glm::dot(mesh.face_normals()[at(face)], inward));
  }
  return edge > longest && cosine < kStraight;
}

std::array<int, 3> sorted(const ivec3& v) {
  std::array<int, 3> s{v.x, v.y, v.z};
  std::sort(s.begin(), s.end());
  return s;
}

/// The field of the tets at the corners of some faces and of the faces next to them.
PressureField field_around(const TriMesh& mesh, const std::vector<int>& some, const PadTets& pad) {
  std::vector<char> corner(mesh.vertices().size(), 0), near(pad.vertices.size(), 0);
  for (const int f : some) {
    for (int c = 0; c < 3; ++c) corner[at(mesh.faces()[at(f)][c])] = 1;
  }
  for (const ivec3& face : mesh.faces()) {
    if (corner[at(face.x)] + corner[at(face.y)] + corner[at(face.z)] < 2) continue;
    for (int c = 0; c < 3; ++c) near[at(face[c])] = 1;
  }
  std::vector<ivec4> tets;
  std::copy_if(pad.tets.begin(), pad.tets.end(), std::back_inserter(tets),
               [&](const ivec4& t) { return near[at(t[0])] + near[at(t[1])] + near[at(t[2])] + near[at(t[3])] > 0; });
  return {pad.vertices, std::move(tets), pad.pressure, FieldReport{}};
}

}  // namespace

std::vector<char> uneven_faces(const MeshIndex& index, const PadShape& shape, const PadTets& pad, double modulus,
                               double thickness, double longest) {
  const TriMesh& mesh = index.mesh();
  std::vector<char> uneven(mesh.faces().size(), 0);
  std::vector<int> tried;
  std::map<std::array<int, 3>, SkinFace> skin;
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (!can_be_uneven(mesh, shape, f, longest)) continue;
    tried.push_back(f);
    skin[sorted(mesh.faces()[at(f)])] = {-1, -1};
  }
  if (tried.empty()) return uneven;
  const PressureField field = field_around(mesh, tried, pad);
  for (const SkinFace& face : skin_faces(field)) {
    const ivec4& v = field.tets()[at(face.tet)].vertices;
    const auto entry =
        skin.find(sorted({v[(face.corner + 1) % 4], v[(face.corner + 2) % 4], v[(face.corner + 3) % 4]}));
    if (entry != skin.end()) entry->second = face;
  }
  const double depth = kTried * thickness;
  const auto is_uneven = [&](int f) {
    const SkinFace& face = skin.at(sorted(mesh.faces()[at(f)]));
    if (face.tet < 0) return true;
    // The centroid, and points near the middles of the edges.
    constexpr double kFar = 0.475, kNear = 0.05;
    for (const dvec3& w :
         {dvec3(1.0 / 3), dvec3(kNear, kFar, kFar), dvec3(kFar, kNear, kFar), dvec3(kFar, kFar, kNear)}) {
      const dvec3 x = w.x * mesh.vertex(f, 0) + w.y * mesh.vertex(f, 1) + w.z * mesh.vertex(f, 2);
      const dvec3 outward = mesh.face_normals()[at(f)];
      double pressure = -1;
      pressures_below(field, face, x, {&depth, 1}, {&pressure, 1});
      if (pressure < 0) {
        // In such a thin body, smaller faces would not have deeper prisms.
        if (is_nearest_skin(index, x - 2 * depth * outward, 2 * depth)) return true;
        continue;
      }
      const double exact = modulus / thickness * depth_inside(index, x - depth * outward, depth);
      if (std::abs(pressure - exact) > kEvenPressure * exact) return true;
    }
    return false;
  };
  constexpr int kChunk = 16;
  parallel_chunks(static_cast<int>(tried.size()), kChunk, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) uneven[at(tried[at(i)])] = is_uneven(tried[at(i)]) ? 1 : 0;
  });
  return uneven;
}

RefinedSkin refine_skin(const TriMesh& mesh, std::vector<char> wanted, double longest, int most_faces) {
  return Bisection(mesh, std::move(wanted)).run(longest, most_faces);
}

}  // namespace taxel
