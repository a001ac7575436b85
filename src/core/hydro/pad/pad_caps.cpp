// Caps: additional vertices close to the skin, with which a pad's stiffness at a face is exactly E/H.
//
// The pressure is 0 at the corners of a skin face, so in its tet the gradient is along the normal, |g| = p(x)/h(x) with
// the height h of the fourth corner x. At sharp corners x is nearer to another part of the skin, and |g| is below E/H.
// A vertex m between the incentre of the face and x, with p(m) = (E/H) h(m), splits the tet into four and makes the
// gradient at the face right:
//
//         x          m is inside of the tet, so the four tets are sound, and faces that other tets share stay as
//        /|\         they are. m is lowered until no other part of the skin is nearer than the face.
//       / m \        .
//     _/_____\_      A face without a tet gets one of its own if it overlaps no other tet (separating axes): no
//      incentre      higher than r tan(a/2), r the radius of the incircle, a the least angle at its edges.
//
// Cost: a few closest-point queries per cap, and a tree of the tets near faces without one. Theory:
// docs/theory/hydro.md, "Caps".
#include "core/hydro/pad/pad_field.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/hydro/fields/pressure_field.h"
#include "core/hydro/fields/tet_geometry.h"

namespace taxel {
namespace {

/// A gradient that differs from E/H by less than this fraction needs no cap.
constexpr double kEvenStiffness = 0.02;
/// A cap's vertex is at first at this fraction of the way from the face's incentre to the old tet's apex. Higher caps
/// are even further inside, but leave thin tets around them.
constexpr double kFirstHeight = 0.35;
/// A cap that is nearer to another part of the skin than to its face is lowered by this factor, at most this often.
constexpr double kLower = 0.6;
constexpr int kMaxLowerings = 12;

struct CapFace {
  std::array<dvec3, 3> x;
  dvec3 inward;    ///< unit normal
  dvec3 incentre;  ///< centre of the incircle: corners weighted by the lengths of the opposite edges
  double inradius = 0;
};

CapFace face_of(const dvec3& a, const dvec3& b, const dvec3& c) {
  CapFace face{{a, b, c}, dvec3(0), dvec3(0), 0};
  const dvec3 cross = glm::cross(b - a, c - a);
  const double twice_area = glm::length(cross);
  face.inward = -cross / twice_area;
  const dvec3 opposite(glm::distance(b, c), glm::distance(c, a), glm::distance(a, b));
  const double perimeter = opposite.x + opposite.y + opposite.z;
  face.incentre = (opposite.x * a + opposite.y * b + opposite.z * c) / perimeter;
  face.inradius = twice_area / perimeter;
  return face;
}

/// The skin face of a tet: its corners counter-clockwise seen from outside, and the tet's fourth corner. Only tets with
/// a skin face have three skin vertices (tet_geometry.h).
struct SkinTet {
  int tet;
  ivec3 corners;
  int apex;
};

std::vector<SkinTet> skin_tets(const std::vector<ivec4>& tets, int skin_vertices) {
  // Of a positively oriented tet: the face opposite to corner i, counter-clockwise seen from outside of the tet.
  constexpr std::array<std::array<int, 3>, 4> kOpposite{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  std::vector<SkinTet> found;
  for (int t = 0; t < static_cast<int>(tets.size()); ++t) {
    const ivec4& v = tets[at(t)];
    int inner = -1, inner_count = 0;
    for (int i = 0; i < 4; ++i) {
      if (v[i] < skin_vertices) continue;
      inner = i;
      ++inner_count;
    }
    if (inner_count != 1) continue;
    const auto& o = kOpposite[at(inner)];
    found.push_back({t, {v[o[0]], v[o[1]], v[o[2]]}, v[inner]});
  }
  return found;
}

/// Returns a vertex between incentre and apex, as high as the skin around allows; the incentre itself if no height is
/// allowed.
dvec3 cap_vertex(const MeshIndex& index, const CapFace& face, const dvec3& apex, double thickness) {
  const double whole = glm::dot(apex - face.incentre, face.inward);
  double fraction = kFirstHeight;
  for (int i = 0; i < kMaxLowerings; ++i, fraction *= kLower) {
    const dvec3 m = face.incentre + fraction * (apex - face.incentre);
    const double height = fraction * whole;
    if (height <= thickness && is_nearest_skin(index, m, height)) return m;
  }
  return face.incentre;
}

/// The angle at edge a -> b, turning from the inside of a face into the body, from the face to the half plane through x
/// [rad], in (0, 2 pi).
double angle_from_face(const CapFace& face, const dvec3& a, const dvec3& b, const dvec3& x) {
  const dvec3 along = glm::normalize(b - a);
  const dvec3 into_face = glm::cross(face.inward, along) * -1.0;  // face is counter-clockwise seen from outside
  const dvec3 r = x - a;
  const double angle = std::atan2(glm::dot(r, face.inward), glm::dot(r, into_face));
  return angle > 0 ? angle : angle + 2 * kPi;
}

/// Builds caps on faces that have no tet.
class OwnCaps {
 public:
  OwnCaps(const MeshIndex& index, PadTets& pad, double modulus, double thickness)
      : index_(index), mesh_(index.mesh()), pad_(pad), modulus_(modulus), thickness_(thickness) {}

  int add(std::vector<char>& bare) {
    gather_edges(bare);
    gather_tets(bare);
    int count = 0;
    for (int f = 0; f < mesh_.face_count(); ++f) {
      if (!bare[at(f)] || !add_cap(f)) continue;
      bare[at(f)] = 0;
      ++count;
    }
    return count;
  }

 private:
  /// A tree over the tets that could overlap a cap: no cap is higher than the radius of its face's incircle.
  void gather_tets(const std::vector<char>& bare) {
    std::vector<Aabb> reaches;
    for (int f = 0; f < mesh_.face_count(); ++f) {
      if (!bare[at(f)]) continue;
      const CapFace face = face_of(mesh_.vertex(f, 0), mesh_.vertex(f, 1), mesh_.vertex(f, 2));
      Aabb& reach = reaches.emplace_back();
      for (const dvec3& x : face.x) reach.include(x);
      reach.include(face.incentre + face.inradius * face.inward);
    }
    Bvh bare_tree;
    bare_tree.build(reaches, 1);
    std::vector<Aabb> boxes;
    for (const ivec4& t : pad_.tets) {
      Aabb box;
      for (int i = 0; i < 4; ++i) box.include(pad_.vertices[at(t[i])]);
      bool is_near = false;
      bare_tree.visit([&](const Aabb& node) { return !is_near && node.overlaps(box); }, [&](int) { is_near = true; });
      if (!is_near) continue;
      boxes.push_back(box);
      near_.push_back(t);
    }
    tree_.build(boxes, 1);
  }

  std::array<dvec3, 4> corners(const ivec4& t) const {
    std::array<dvec3, 4> x;
    for (int i = 0; i < 4; ++i) x[at(i)] = pad_.vertices[at(t[i])];
    return x;
  }

  /// Points that bound the angles at the edges of bare faces: corners of the skin faces and the tets there.
  void gather_edges(const std::vector<char>& bare) {
    std::vector<char> is_end(pad_.vertices.size(), 0);
    for (int f = 0; f < mesh_.face_count(); ++f) {
      if (!bare[at(f)]) continue;
      for (int c = 0; c < 3; ++c) {
        const int a = mesh_.faces()[at(f)][c], b = mesh_.faces()[at(f)][(c + 1) % 3];
        at_edge_[std::minmax(a, b)];
        is_end[at(a)] = is_end[at(b)] = 1;
      }
    }
    const auto add = [&](int a, int b, int other) {
      const auto edge = at_edge_.find(std::minmax(a, b));
      if (edge != at_edge_.end()) edge->second.push_back(other);
    };
    for (const ivec3& face : mesh_.faces()) {
      for (int c = 0; c < 3; ++c) {
        const int a = face[c], b = face[(c + 1) % 3];
        if (is_end[at(a)] != 0 && is_end[at(b)] != 0) add(a, b, face[(c + 2) % 3]);
      }
    }
    for (const ivec4& t : pad_.tets) {
      for (int i = 0; i < 4; ++i) {
        for (int j = i + 1; j < 4; ++j) {
          if (is_end[at(t[i])] == 0 || is_end[at(t[j])] == 0) continue;
          for (int k = 0; k < 4; ++k) {
            if (k != i && k != j) add(t[i], t[j], t[k]);
          }
        }
      }
    }
  }

  double least_angle(int f, const CapFace& face) const {
    double least = 0.5 * kPi;
    const ivec3& v = mesh_.faces()[at(f)];
    for (int c = 0; c < 3; ++c) {
      const int a = v[c], b = v[(c + 1) % 3], own = v[(c + 2) % 3];
      for (const int other : at_edge_.at(std::minmax(a, b))) {
        if (other == own) continue;
        least = std::min(
            least, angle_from_face(face, mesh_.vertices()[at(a)], mesh_.vertices()[at(b)], pad_.vertices[at(other)]));
      }
    }
    return least;
  }

  bool is_free(const std::array<dvec3, 4>& cap) const {
    Aabb box;
    for (const dvec3& x : cap) box.include(x);
    bool clear = true;
    const auto check = [&](const ivec4& t) { clear = clear && !tets_overlap(cap, corners(t)); };
    tree_.visit([&](const Aabb& node) { return clear && node.overlaps(box); }, [&](int i) { check(near_[at(i)]); });
    for (const ivec4& t : own_) check(t);
    return clear;
  }

  bool add_cap(int f) {
    const CapFace face = face_of(mesh_.vertex(f, 0), mesh_.vertex(f, 1), mesh_.vertex(f, 2));
    double height = std::min(face.inradius * std::tan(0.5 * least_angle(f, face)), thickness_);
    // Below this part of the incircle a cap is as flat as its face: rounding.
    constexpr double kFlattest = 1e-3;
    for (int i = 0; i < kMaxLowerings && height > kFlattest * face.inradius; ++i, height *= kLower) {
      const dvec3 m = face.incentre + height * face.inward;
      if (!is_nearest_skin(index_, m, height) || !is_free({face.x[0], face.x[2], face.x[1], m})) continue;
      const ivec3& v = mesh_.faces()[at(f)];
      pad_.vertices.push_back(m);
      pad_.pressure.push_back(elastic_pressure(height, thickness_, modulus_));
      own_.emplace_back(v.x, v.z, v.y, static_cast<int>(pad_.vertices.size()) - 1);
      pad_.tets.push_back(own_.back());
      return true;
    }
    return false;
  }

  const MeshIndex& index_;
  const TriMesh& mesh_;
  PadTets& pad_;
  double modulus_, thickness_;
  std::vector<ivec4> near_;                                  ///< tets near bare faces
  Bvh tree_;                                                 ///< over these
  std::map<std::pair<int, int>, std::vector<int>> at_edge_;  ///< edge of a bare face -> corners across it
  std::vector<ivec4> own_;
};

}  // namespace

int split_by_caps(const MeshIndex& index, PadTets& pad, double modulus, double thickness) {
  const double stiffness = modulus / thickness;
  std::vector<SkinTet> uneven;
  for (const SkinTet& skin : skin_tets(pad.tets, index.mesh().vertex_count())) {
    const CapFace face =
        face_of(pad.vertices[at(skin.corners.x)], pad.vertices[at(skin.corners.y)], pad.vertices[at(skin.corners.z)]);
    const double height = glm::dot(pad.vertices[at(skin.apex)] - face.x[0], face.inward);
    // g = p(x)/height, along the face's normal, as the pressure is 0 at its corners.
    if (std::abs(pad.pressure[at(skin.apex)] - stiffness * height) > kEvenStiffness * stiffness * height)
      uneven.push_back(skin);
  }
  std::vector<dvec3> middle(uneven.size());
  std::vector<double> height(uneven.size());
  constexpr int kChunk = 16;
  parallel_chunks(static_cast<int>(uneven.size()), kChunk, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const ivec3& v = uneven[at(i)].corners;
      const CapFace face = face_of(pad.vertices[at(v.x)], pad.vertices[at(v.y)], pad.vertices[at(v.z)]);
      middle[at(i)] = cap_vertex(index, face, pad.vertices[at(uneven[at(i)].apex)], thickness);
      height[at(i)] = glm::dot(middle[at(i)] - face.incentre, face.inward);
    }
  });
  int count = 0;
  for (std::size_t i = 0; i < uneven.size(); ++i) {
    if (!(height[i] > 0)) continue;
    const auto m = static_cast<int>(pad.vertices.size());
    pad.vertices.push_back(middle[i]);
    pad.pressure.push_back(stiffness * height[i]);
    const ivec4 whole = pad.tets[at(uneven[i].tet)];
    for (int k = 0; k < 4; ++k) {
      ivec4 part = whole;
      part[k] = m;
      if (whole[k] == uneven[i].apex) {
        pad.tets[at(uneven[i].tet)] = part;
      } else {
        pad.tets.push_back(part);
      }
    }
    ++count;
  }
  return count;
}

int add_own_caps(const MeshIndex& index, PadTets& pad, std::vector<char>& bare, double modulus, double thickness) {
  if (std::find(bare.begin(), bare.end(), 1) == bare.end()) return 0;
  return OwnCaps(index, pad, modulus, thickness).add(bare);
}

}  // namespace taxel
