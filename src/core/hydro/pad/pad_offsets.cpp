// The directions of a pad's offset vectors.
//
// A vertex has one direction: minus the angle-weighted normal, or, if a face around is more than 60 degrees off, the
// middle of the smallest cap that holds the faces' normals. Below a sharp concave edge (a crease) the points of one
// depth are on a round surface, so the faces around a vertex are divided into groups between its creases; each group
// has its own offset vector, and more fan out in between, at most 30 degrees apart. A crease that ends at a vertex also
// divides the flat faces opposite to it. The gaps between the groups are wedges along edges and cones at vertices,
// which tets fill (tet_geometry.h).
//
// Pitfalls: a vertex is only divided if its faces are a single fan and all of its vectors lead below all faces that
// they belong to. The smallest faces of folded tessellations may have normals that no direction serves; they are left
// out while they are a small part of the area. Theory: docs/theory/hydro.md, "Split normals".
#include "core/hydro/pad/pad_shape.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <span>
#include <utility>

#include "core/base/math.h"
#include "core/hydro/fields/tet_geometry.h"

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

namespace {

/// Smallest angle between the normals of the faces at a concave edge that is a crease.
const double kCrease = 40.0 * kPi / 180.0;
/// Largest angle between offset vectors that fan out. Between two of them, the round surface below the edge is too low
/// by at most 1 - cos(15 degrees) = 3 %.
const double kFanStep = 30.0 * kPi / 180.0;
/// Largest angle of an edge opposite to the end of a crease at which the faces of the vertex may be divided.
const double kFlatAngle = 20.0 * kPi / 180.0;
/// Smallest cosine of an offset vector to the normal of a face.
constexpr double kMinCosine = 0.2;

int corner_of(const ivec3& face, int v) {
  return face.x == v ? 0 : face.y == v ? 1 : 2;
}

/// The edges ("spokes") of a vertex, counter-clockwise seen from outside: face i is between the edges to ends[i] and
/// ends[i + 1].
struct VertexRing {
  std::vector<int> faces, ends;
};

class OffsetMaker {
 public:
  OffsetMaker(const TriMesh& mesh, const std::vector<PadDirection>& directions, const PadCreases& creases)
      : mesh_(mesh), creases_(creases) {
    offsets_.skin.resize(mesh.vertices().size());
    std::iota(offsets_.skin.begin(), offsets_.skin.end(), 0);
    offsets_.inward = directions;
    offsets_.of_face = mesh.faces();
  }

  PadOffsets make(const std::vector<char>& whole) {
    for (const auto& [v, ends] : creases_.ends) {
      if (!whole[at(v)]) split(v, ends);
    }
    for (const auto& [u, v] : cut_edges_) add_wedge(u, v);
    return std::move(offsets_);
  }

 private:
  /// Returns the ring of a vertex; empty if the faces around v are not a single fan.
  VertexRing ring_of(int v) const {
    const std::vector<int>& around = creases_.around.at(v);
    VertexRing ring;
    int face = around.front();
    for (std::size_t i = 0; i < around.size(); ++i) {
      const ivec3& f = mesh_.faces()[at(face)];
      const int c = corner_of(f, v), left = f[(c + 2) % 3];
      ring.faces.push_back(face);
      ring.ends.push_back(f[(c + 1) % 3]);
      const auto next = std::find_if(around.begin(), around.end(), [&](int g) {
        const ivec3& other = mesh_.faces()[at(g)];
        return other[(corner_of(other, v) + 1) % 3] == left;
      });
      if (next == around.end()) return {};
      face = *next;
    }
    return face == around.front() ? ring : VertexRing{};
  }

  /// Returns the spoke that is best opposite to a crease that ends at v, or -1. Only spokes at which the neighbouring
  /// offset vectors diverge and do not cross are considered.
  int opposite_spoke(int v, const VertexRing& ring, int crease) const {
    const auto n = static_cast<int>(ring.faces.size());
    const auto normal = [&](int i) { return mesh_.face_normals()[at(ring.faces[at((i + n) % n)])]; };
    const dvec3 away = -glm::normalize(normal(crease) + normal(crease - 1));
    int best = -1;
    double most = 0.5;
    for (int i = 0; i < n; ++i) {
      if (i == crease || angle_between(normal(i), normal(i - 1)) > kFlatAngle) continue;
      const double along =
          glm::dot(away, glm::normalize(mesh_.vertices()[at(ring.ends[at(i)])] - mesh_.vertices()[at(v)]));
      if (along > most) {
        most = along;
        best = i;
      }
    }
    return best;
  }

  /// Returns an offset direction with its least cosine to the given faces.
  PadDirection direction_between(const dvec3& direction, std::span<const int> faces) const {
    PadDirection inward{direction, 1};
    for (const int f : faces)
      inward.least_cosine = std::min(inward.least_cosine, -glm::dot(direction, mesh_.face_normals()[at(f)]));
    return inward;
  }

  /// The division of the faces around a vertex into groups. Group k is between the spokes cuts[k] and cuts[k + 1], and
  /// fans[k] leads from group k - 1 to group k. Two cuts have one fan.
  struct Parting {
    std::vector<int> cuts;  ///< other ends of the spokes
    std::vector<std::vector<int>> groups;
    std::vector<PadDirection> inward;
    std::vector<std::vector<dvec3>> fans;
  };

  void split(int v, const std::vector<int>& ends) {
    const VertexRing ring = ring_of(v);
    const int n = static_cast<int>(ring.faces.size());
    std::vector<int> spokes;
    for (int i = 0; i < n; ++i) {
      if (std::find(ends.begin(), ends.end(), ring.ends[at(i)]) != ends.end()) spokes.push_back(i);
    }
    if (spokes.empty()) return;
    const int crease = ring.ends[at(spokes[0])];
    if (spokes.size() == 1) {
      const int opposite = opposite_spoke(v, ring, spokes[0]);
      if (opposite < 0) return;
      spokes.push_back(opposite);
      std::sort(spokes.begin(), spokes.end());
    }
    Parting parting;
    for (std::size_t k = 0; k < spokes.size(); ++k) {
      const int end = k + 1 < spokes.size() ? spokes[k + 1] : spokes[0] + n;
      parting.cuts.push_back(ring.ends[at(spokes[k])]);
      parting.groups.emplace_back();
      for (int i = spokes[k]; i < end; ++i) parting.groups.back().push_back(ring.faces[at(i % n)]);
      parting.inward.push_back(pad_direction(mesh_, v, parting.groups.back()));
    }
    const std::size_t fans = spokes.size() == 2 ? 1 : spokes.size();
    for (std::size_t k = 0; k < fans; ++k) {
      const int end = fans == 1 ? crease : parting.cuts[k];
      const dvec3 edge = glm::normalize(mesh_.vertices()[at(end)] - mesh_.vertices()[at(v)]);
      const std::size_t before = (k + spokes.size() - 1) % spokes.size();
      parting.fans.push_back(fan(parting.inward[before].direction, parting.inward[k].direction, edge));
    }
    if (goes_inward(v, parting)) add_offsets(v, parting);
  }

  /// Returns directions strictly between two directions, at most kFanStep apart. They rotate about the edge, so they
  /// have the common component of both directions along the edge, and for example the depth below a face across the
  /// edge.
  static std::vector<dvec3> fan(const dvec3& from, const dvec3& to, const dvec3& edge) {
    constexpr double kMinAcross = 0.1;
    const dvec3 along(glm::dot(from, edge), glm::dot(to, edge), 0);
    dvec3 p = from - along.x * edge, q = to - along.y * edge;
    const double p_length = glm::length(p), q_length = glm::length(q);
    if (p_length < kMinAcross || q_length < kMinAcross) return {};
    p /= p_length;
    q /= q_length;
    const double angle = angle_between(p, q), first = along.x / p_length, last = along.y / q_length;
    const int steps = std::max(1, static_cast<int>(std::ceil(angle / kFanStep - 1e-9)));
    std::vector<dvec3> directions;
    for (int i = 1; i < steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      const dvec3 across = (std::sin((1 - t) * angle) * p + std::sin(t * angle) * q) / std::sin(angle);
      directions.push_back(glm::normalize(across + ((1 - t) * first + t * last) * edge));
    }
    return directions;
  }

  /// Returns true if every offset vector leads below all faces that it belongs to, and no offset vector of a group has
  /// a smaller cosine than the common offset vector.
  bool goes_inward(int v, const Parting& parting) const {
    const double common = offsets_.inward[at(v)].least_cosine;
    for (const PadDirection& inward : parting.inward) {
      if (inward.least_cosine < std::max(kMinCosine, common)) return false;
    }
    for (const std::vector<dvec3>& fan : parting.fans) {
      for (const dvec3& d : fan) {
        if (direction_between(d, creases_.around.at(v)).least_cosine < kMinCosine) return false;
      }
    }
    return true;
  }

  int add_offset(int v, const PadDirection& inward) {
    offsets_.skin.push_back(v);
    offsets_.inward.push_back(inward);
    return static_cast<int>(offsets_.skin.size()) - 1;
  }

  void add_offsets(int v, const Parting& parting) {
    const std::size_t count = parting.groups.size();
    std::vector<int> of_group;  // the first group has the offset vector of the vertex
    offsets_.inward[at(v)] = parting.inward[0];
    for (std::size_t k = 0; k < count; ++k) {
      of_group.push_back(k == 0 ? v : add_offset(v, parting.inward[k]));
      for (const int f : parting.groups[k]) offsets_.of_face[at(f)][corner_of(mesh_.faces()[at(f)], v)] = of_group[k];
    }
    std::vector<std::vector<int>> chains;  // offset vectors at cut k, from group k - 1 to group k
    for (std::size_t k = 0; k < parting.fans.size(); ++k) {
      chains.push_back({of_group[(k + count - 1) % count]});
      for (const dvec3& d : parting.fans[k])
        chains[k].push_back(add_offset(v, direction_between(d, creases_.around.at(v))));
      chains[k].push_back(of_group[k]);
    }
    if (count == 2) chains.emplace_back(chains[0].rbegin(), chains[0].rend());
    for (std::size_t k = 0; k < count; ++k) {
      chains_[{v, parting.cuts[k]}] = chains[k];
      cut_edges_.insert(std::minmax(v, parting.cuts[k]));
    }
    if (count > 2) add_cone(v, parting, chains);
  }

  void add_cone(int v, const Parting& parting, const std::vector<std::vector<int>>& chains) {
    PadCone cone{v, -1, {}};
    dvec3 middle{0};
    for (std::size_t k = 0; k < chains.size(); ++k) {
      middle += parting.inward[k].direction;
      cone.rim.insert(cone.rim.end(), chains[k].begin() + 1,
                      chains[k].end());  // the first offset vector ends the last chain
    }
    cone.center = add_offset(v, direction_between(glm::normalize(middle), creases_.around.at(v)));
    offsets_.cones.push_back(std::move(cone));
  }

  int face_with(int from, int to) const {
    for (const int v : {from, to}) {
      const auto entry = creases_.around.find(v);
      if (entry == creases_.around.end()) continue;
      for (const int f : entry->second) {
        const ivec3& face = mesh_.faces()[at(f)];
        const int c = corner_of(face, from);
        if (face[c] == from && face[(c + 1) % 3] == to) return f;
      }
    }
    return -1;
  }

  void add_wedge(int u, int v) {
    const int left = face_with(u, v), right = face_with(v, u);
    if (left < 0 || right < 0) return;
    const auto offsets_at = [&](int vertex, int other, bool turned) {
      const auto chain = chains_.find({vertex, other});
      if (chain == chains_.end())
        return std::vector<int>{offsets_.of_face[at(left)][corner_of(mesh_.faces()[at(left)], vertex)]};
      std::vector<int> offsets = chain->second;
      if (turned) std::reverse(offsets.begin(), offsets.end());
      return offsets;
    };
    // Counter-clockwise around u the face on the right comes before the one on the left, around v after it.
    PadWedge wedge{u, v, offsets_at(u, v, true), offsets_at(v, u, false)};
    if (wedge.at_u.size() > 1 || wedge.at_v.size() > 1) offsets_.wedges.push_back(std::move(wedge));
  }

  const TriMesh& mesh_;
  const PadCreases& creases_;
  PadOffsets offsets_;
  std::map<std::pair<int, int>, std::vector<int>>
      chains_;  ///< split vertex and other end of a cut edge -> offset vectors
  std::set<std::pair<int, int>> cut_edges_;
};

}  // namespace

PadCreases find_pad_creases(const TriMesh& mesh, const std::vector<PadDirection>& directions, double shortest) {
  // The normals at the ends of a crease are this far apart, so no direction is closer to all of them than half of the
  // angle.
  const double most_cosine = std::cos(0.5 * kCrease) + 1e-9;
  std::vector<std::array<int, 4>> sides;  // low, high, face, opposite vertex
  for (int f = 0; f < mesh.face_count(); ++f) {
    const ivec3& face = mesh.faces()[at(f)];
    for (int c = 0; c < 3; ++c) {
      const int a = face[c], b = face[(c + 1) % 3];
      if (directions[at(a)].least_cosine > most_cosine || directions[at(b)].least_cosine > most_cosine) continue;
      sides.push_back({std::min(a, b), std::max(a, b), f, face[(c + 2) % 3]});
    }
  }
  std::sort(sides.begin(), sides.end());
  PadCreases creases;
  std::set<int> too_short;
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const auto& [low, high, face, opposite] = sides[i];
    const auto& [other_low, other_high, other_face, other_opposite] = sides[i + 1];
    if (low != other_low || high != other_high) continue;
    const dvec3 &n = mesh.face_normals()[at(face)], &m = mesh.face_normals()[at(other_face)];
    const dvec3 &a = mesh.vertices()[at(low)], &b = mesh.vertices()[at(high)];
    if (!(glm::dot(n, mesh.vertices()[at(other_opposite)] - a) > 0) || angle_between(n, m) < kCrease) continue;
    creases.ends[low].push_back(high);
    creases.ends[high].push_back(low);
    if (glm::distance(a, b) < shortest) too_short.insert({low, high});
  }
  for (const int v : too_short) creases.ends.erase(v);
  for (const auto& [v, ends] : creases.ends) creases.around.try_emplace(v);
  for (int f = 0; f < mesh.face_count() && !creases.around.empty(); ++f) {
    for (int c = 0; c < 3; ++c) {
      const auto entry = creases.around.find(mesh.faces()[at(f)][c]);
      if (entry != creases.around.end()) entry->second.push_back(f);
    }
  }
  return creases;
}

PadOffsets make_pad_offsets(const TriMesh& mesh, const std::vector<PadDirection>& directions, const PadCreases& creases,
                            const std::vector<char>& whole) {
  return OffsetMaker(mesh, directions, creases).make(whole);
}

std::vector<ivec4> gap_tets(const PadWedge& wedge, const std::vector<int>& ends) {
  std::vector<int> at_u, at_v;
  for (const int offset : wedge.at_u) at_u.push_back(ends[at(offset)]);
  for (const int offset : wedge.at_v) at_v.push_back(ends[at(offset)]);
  std::vector<ivec4> tets;
  split_wedge(wedge.u, wedge.v, std::move(at_u), std::move(at_v), tets);
  return tets;
}

std::vector<ivec4> gap_tets(const PadCone& cone, const std::vector<int>& ends) {
  std::vector<ivec4> tets;
  for (const ivec3& f : gap_floor(cone)) {
    const int b = ends[at(f[0])], middle = ends[at(f[1])], a = ends[at(f[2])];
    if (a != b && a != cone.v && b != cone.v && middle != cone.v) tets.emplace_back(cone.v, b, a, middle);
  }
  return tets;
}

std::vector<ivec3> gap_floor(const PadWedge& wedge) {
  return wedge_floor(wedge.u, wedge.v, wedge.at_u, wedge.at_v);
}

std::vector<ivec3> gap_floor(const PadCone& cone) {
  std::vector<ivec3> floor;
  for (std::size_t i = 0; i < cone.rim.size(); ++i)
    floor.emplace_back(cone.rim[(i + 1) % cone.rim.size()], cone.center, cone.rim[i]);
  return floor;
}

}  // namespace taxel
