// The lengths of a pad's offset vectors: as long as the thickness asks for, and as short as the body demands.
//
// 1. Each offset vector alone: the length at which the depth below its faces is H (a mitre on ridges, at most twice H),
//    limited by the medial axis, which shrinking balls find (Ma, Bae, Choi 2012): the ball about the inner vertex must
//    hold no point of the skin.
// 2. Neighbours: no edge between inner vertices is steeper than allowed, and fans below an edge are no longer than the
//    longest vector of a face.
// 3. Prisms: a folded one, or one whose middle crosses the middle of a thin wall, shortens its offset vectors in
//    rounds. If no length helps, as few inner vertices as possible fall back onto the skin (collapsed).
// 4. Gaps of divided vertices that fold are closed: these vertices get one offset vector, and all is done again, at
//    most six times; then no vertex is divided.
//
// Cost: some closest-point queries per vertex; a face is tested again only if an offset vector around it has changed,
// and rounds reuse lengths of unchanged directions. Pitfall: a prism counts as folded below a volume that is small but
// not 0, or the planes of its tets would be rounding errors. Theory: docs/theory/hydro.md, "Pads".
#include "core/hydro/pad/pad_shape.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>

#include "core/base/parallel.h"
#include "core/hydro/fields/tet_geometry.h"

namespace taxel {
namespace {

/// Thickness of a pad in a thin body, as a fraction of the distance to the medial axis.
constexpr double kThinMargin = 0.9;
/// Largest length of a mitre, in thicknesses.
constexpr double kLongestMitre = 2.0;
/// Shortest edge of a crease whose vertices are divided, in thicknesses.
constexpr double kShortestCrease = 0.5;
/// Largest difference of neighbouring lengths, divided by their distance.
constexpr double kLargestSlope = 1.5;
/// Volume fraction below which a prism is treated as folded. It is not zero, because the planes of flatter tets would
/// be rounding errors.
constexpr double kFoldedVolume = 1e-4;
/// Factor by which folded prisms shrink in a round, and largest number of rounds (down to a ten thousandth).
constexpr double kShapeShrink = 0.8;
constexpr int kShrinkRounds = 40;

}  // namespace

double depth_inside(const MeshIndex& index, const dvec3& x, double most) {
  const SignedPoint skin = index.signed_point(x, most);
  return skin.point.face < 0 ? most : std::clamp(-skin.signed_distance, 0.0, most);
}

bool is_nearest_skin(const MeshIndex& index, const dvec3& x, double distance) {
  constexpr double kNearest = 0.97;
  return depth_inside(index, x, distance) >= kNearest * distance;
}

/// Finds the lengths of the offset vectors of a shape, so that no prism and no gap is folded.
class PadFit final : public PadShape {
 public:
  PadFit(const MeshIndex& index, double thickness, const PadShape* coarse);

 private:
  /// An inner vertex is treated as beyond the medial axis, so that it belongs to another part of the skin, if its
  /// distance to the skin is less than this fraction of its depth below the faces around its own vertex.
  static constexpr double kOwnDepth = 0.95;
  [[nodiscard]] double own_length(int offset, double most, double& depth, dvec3& obstacle) const;
  [[nodiscard]] OwnLength find_own_length(int offset, dvec3& obstacle) const;
  [[nodiscard]] std::span<const int> faces_around(int offset) const;
  void set_offsets(PadOffsets offsets);
  void fit();
  void reuse_lengths(const PadOffsets& last, int last_vertices, const std::vector<OwnLength>& own);
  void gather_faces();
  void shorten(int offset, double length);
  void smooth();
  [[nodiscard]] bool crosses_wall(int face) const;
  void shrink_crossing();
  void shrink_folded();
  [[nodiscard]] bool is_sound_without(int face, unsigned corners);
  [[nodiscard]] unsigned corners_to_collapse(int face);
  void collapse_folded();
  void lower_fans();
  bool find_folded_gaps(std::vector<char>& whole) const;
  void set_depths(const PadShape* coarse);

  const MeshIndex& index_;
  double thickness_;
  int vertices_of_offsets_ = 0;             ///< number of vertices of the mesh of offsets_
  std::vector<int> first_face_, faces_at_;  ///< the faces of an offset vector i are faces_at_ from first_face_[i] on
  std::vector<double> steepest_;  ///< largest difference of lengths along the edge from corner c, at 3 face + c
  std::vector<int> shortened_;    ///< offset vectors whose neighbours' lengths must still be compared
};

PadShape::PadShape(const MeshIndex& index, double thickness, const PadShape* coarse)
    : PadShape(static_cast<PadShape&&>(PadFit(index, thickness, coarse))) {}

PadFit::PadFit(const MeshIndex& index, double thickness, const PadShape* coarse)
    : PadShape(index.mesh()), index_(index), thickness_(thickness) {
  if (coarse != nullptr) {
    offsets_ = coarse->offsets_;
    vertices_of_offsets_ = coarse->mesh_.vertex_count();
    own_ = coarse->own_;
  }
  // Vertices are not divided if the gaps around them fold; after some rounds no vertex is divided. Most folds occur
  // before the offsets are fitted to each other.
  constexpr int kRounds = 6;
  const std::vector<PadDirection> directions = pad_directions(mesh_);
  const PadCreases creases = find_pad_creases(mesh_, directions, kShortestCrease * thickness_);
  std::vector<char> whole(mesh_.vertices().size(), 0);
  for (int round = 0;; ++round) {
    if (round == kRounds) whole.assign(whole.size(), 1);
    set_offsets(make_pad_offsets(mesh_, directions, creases, whole));
    if (find_folded_gaps(whole)) continue;
    fit();
    if (!find_folded_gaps(whole)) break;
  }
  set_depths(coarse);
}

/// Reuses the lengths of offset vectors that have the same direction as in the last round, from before they were fitted
/// to their neighbours.
void PadFit::reuse_lengths(const PadOffsets& last, int last_vertices, const std::vector<OwnLength>& own) {
  std::map<int, std::vector<int>> further;  // skin vertex -> its offset vectors after the first
  for (int offset = last_vertices; offset < static_cast<int>(last.skin.size()); ++offset)
    further[last.skin[at(offset)]].push_back(offset);
  const auto reuse = [&](int offset, int old) {
    if (last.inward[at(old)].direction != offsets_.inward[at(offset)].direction ||
        last.inward[at(old)].least_cosine != offsets_.inward[at(offset)].least_cosine)
      return;
    own_[at(offset)] = own[at(old)];
  };
  for (int offset = 0; offset < offset_count() && !own.empty(); ++offset) {
    if (offset < mesh_.vertex_count()) {
      if (offset < last_vertices) reuse(offset, offset);
      continue;
    }
    const auto entry = further.find(offsets_.skin[at(offset)]);
    if (entry == further.end()) continue;
    for (const int old : entry->second) reuse(offset, old);
  }
}

/// Sets the offset vectors, and finds the largest length of each offset vector alone.
void PadFit::set_offsets(PadOffsets offsets) {
  const PadOffsets last = std::exchange(offsets_, std::move(offsets));
  const std::vector<OwnLength> earlier = std::exchange(own_, std::vector<OwnLength>(offsets_.skin.size()));
  reuse_lengths(last, std::exchange(vertices_of_offsets_, mesh_.vertex_count()), earlier);
  constexpr int kChunk = 64;
  parallel_chunks(offset_count(), kChunk, [&](int begin, int end) {
    dvec3 obstacle(std::numeric_limits<double>::infinity());
    for (int offset = begin; offset < end; ++offset) {
      if (!own_[at(offset)].is_found) own_[at(offset)] = find_own_length(offset, obstacle);
    }
  });
  length_.clear();
  depth_.clear();
  collapsed_.clear();
  for (const OwnLength& own : own_) {
    length_.push_back(own.length);
    depth_.push_back(own.depth);
    collapsed_.push_back(own.collapsed);
  }
}

void PadFit::fit() {
  gather_faces();
  shortened_.resize(offsets_.skin.size());
  std::iota(shortened_.begin(), shortened_.end(), 0);
  smooth();
  shrink_crossing();
  shrink_folded();
  collapse_folded();
  lower_fans();
}

void PadFit::gather_faces() {
  first_face_.assign(offsets_.skin.size() + 1, 0);
  for (const ivec3& f : offsets_.of_face) {
    for (int c = 0; c < 3; ++c) ++first_face_[at(f[c]) + 1];
  }
  for (std::size_t v = 1; v < first_face_.size(); ++v) first_face_[v] += first_face_[v - 1];
  faces_at_.resize(3 * mesh_.faces().size());
  steepest_.resize(faces_at_.size());
  std::vector<int> next(first_face_.begin(), first_face_.end() - 1);
  for (int f = 0; f < mesh_.face_count(); ++f) {
    for (int c = 0; c < 3; ++c) {
      faces_at_[at(next[at(offset(f, c))]++)] = f;
      steepest_[at(3 * f + c)] = kLargestSlope * glm::distance(mesh_.vertex(f, c), mesh_.vertex(f, (c + 1) % 3));
    }
  }
}

std::span<const int> PadFit::faces_around(int offset) const {
  return {faces_at_.data() + first_face_[at(offset)], faces_at_.data() + first_face_[at(offset) + 1]};
}

/// Returns the largest offset up to `most` at which the inner vertex still belongs to its own part of the skin, and
/// sets `depth` to its depth; 0 if there is no such offset. Uses shrinking balls (Ma, Bae, Choi 2012): the ball about
/// the inner vertex, whose radius s h is the least required depth, must contain no point of the skin. If it contains q,
/// the ball is shrunk until q is on it: |v + h d - q| = s h. `obstacle` is the last such point of any offset vector; it
/// often limits the next offset vector too, so that the first and largest ball is not needed.
double PadFit::own_length(int offset, double most, double& depth, dvec3& obstacle) const {
  constexpr int kMaxBalls = 30;
  constexpr double kMinLength = 1e-3, kTouching = 5e-3;
  const dvec3& direction = offsets_.inward[at(offset)].direction;
  const double s = kOwnDepth * offsets_.inward[at(offset)].least_cosine;
  // (1 - s^2) h^2 + 2 (w d) h + w^2 = 0 with w = v - q; its smaller root, in the form that loses no digits.
  const auto shrunk = [&](const dvec3& q, double h) {
    const dvec3 w = skin(offset) - q;
    const double half_b = glm::dot(w, direction), c = glm::dot(w, w);
    const double root = half_b * half_b - (1 - s * s) * c;
    const double next = root > 0 && half_b < 0 ? c / (std::sqrt(root) - half_b) : 0.5 * h;
    return std::min(next, 0.999 * h);  // beyond another wall no ball touches: step back
  };
  const bool is_blocked = glm::distance(moved(offset, most), obstacle) < s * most;
  double h = is_blocked ? shrunk(obstacle, most) : most;
  for (int i = is_blocked ? 1 : 0; i < kMaxBalls && h > kMinLength * most; ++i) {
    const SignedPoint q =
        index_.signed_point(moved(offset, h), h);  // the vertex of the offset vector is at this distance
    depth = -q.signed_distance;
    if (depth >= (s - (i > 0 ? kTouching : 0.0)) * h) return h;
    obstacle = q.point.position;
    h = shrunk(obstacle, h);
  }
  depth = 0;
  return 0;
}

/// Returns the largest offset that does not cross the medial axis, up to the offset at which the depth is H.
PadShape::OwnLength PadFit::find_own_length(int offset, dvec3& obstacle) const {
  OwnLength own;
  own.is_found = true;
  own.full = thickness_;
  const double least_cosine = offsets_.inward[at(offset)].least_cosine;
  if (least_cosine < kEdgeOn) {  // no direction leads inside
    own.collapsed = 1;
    return own;
  }
  // No point of the body is deeper than half its smallest extent.
  const dvec3 extent = mesh_.bounds().extent();
  double most = std::min(thickness_, 0.5 * std::min({extent.x, extent.y, extent.z}));
  // A ball of less than half the offset could miss a wall in between, so the halfway point is tested first.
  constexpr double kNarrow = 0.5;
  double h = most;
  if (least_cosine < kNarrow) h = own_length(offset, 0.5 * most, own.depth, obstacle);
  if (h >= 0.5 * most) h = own_length(offset, most, own.depth, obstacle);
  if (h == thickness_ && own.depth < 0.99 * thickness_) {
    // Below a ridge the depth is less than the offset along the bisector, so the offset is longer, as given by the
    // angles of the faces (a mitre).
    most = own.full = thickness_ * std::min(thickness_ / own.depth, kLongestMitre);
    h = own_length(offset, most, own.depth, obstacle);
  }
  own.length = h;
  if (h < most) {
    own.length = kThinMargin * h;
    own.depth = -1;
  }
  return own;
}

void PadFit::shorten(int offset, double length) {
  length_[at(offset)] = length;
  depth_[at(offset)] = -1;
}

/// Reduces offsets until no edge is steeper than allowed. Collapsed vertices are no limit, because tets may be upright
/// there.
void PadFit::smooth() {
  while (!shortened_.empty()) {
    const int low = shortened_.back();
    shortened_.pop_back();
    if (collapsed_[at(low)]) continue;
    for (const int f : faces_around(low)) {
      const ivec3& face = offsets_.of_face[at(f)];
      const int c = face.x == low ? 0 : face.y == low ? 1 : 2, before = (c + 2) % 3;
      const std::array<std::pair<int, double>, 2> beside{
          {{face[(c + 1) % 3], steepest_[at(3 * f + c)]}, {face[before], steepest_[at(3 * f + before)]}}};
      for (const auto& [high, steepest] : beside) {
        // Each change is at least a fraction of the thickness, so the loop ends.
        if (length_[at(high)] <= length_[at(low)] + steepest + 1e-6 * thickness_) continue;
        shorten(high, length_[at(low)] + steepest);
        shortened_.push_back(high);
      }
    }
  }
}

dvec3 PadShape::position(int vertex) const {
  const int n = mesh_.vertex_count();
  return vertex < n ? mesh_.vertices()[at(vertex)] : inner_position(vertex - n);
}

/// Returns true if all corners' offsets go below the face; if not, no offset is short enough.
bool PadShape::can_be_filled(int face) const {
  for (int c = 0; c < 3; ++c) {
    const std::size_t own = at(offset(face, c));
    const double cosine = -glm::dot(mesh_.face_normals()[at(face)], offsets_.inward[own].direction);
    if (!collapsed_[own] && cosine < kEdgeOn) return false;
  }
  return true;
}

PrismTets PadShape::prism(int face) const {
  const ivec3& f = mesh_.faces()[at(face)];
  return split_prism(f, {inner(offset(face, 0)), inner(offset(face, 1)), inner(offset(face, 2))}, f);
}

/// Returns true if every tet has at least `part` of the prism's third, taken with the shortest offset around the face.
bool PadShape::well_shaped(int face, double part) const {
  double h = std::numeric_limits<double>::infinity();
  for (int c = 0; c < 3; ++c) {
    const std::size_t own = at(offset(face, c));
    if (!collapsed_[own]) h = std::min(h, length_[own]);
  }
  const PrismTets prism_tets = prism(face);
  for (int i = 0; i < prism_tets.count; ++i) {
    const ivec4& t = prism_tets.tets[at(i)];
    const double six = six_volumes({position(t[0]), position(t[1]), position(t[2]), position(t[3])});
    if (!(six > part * 2.0 * mesh_.face_areas()[at(face)] * h)) return false;
  }
  return true;
}

/// Shortens the offsets of folded prisms until none is folded, up to a number of rounds. A face is tested again only if
/// an offset around it has changed.
void PadFit::shrink_folded() {
  std::vector<int> suspects(mesh_.faces().size());
  std::iota(suspects.begin(), suspects.end(), 0);
  std::vector<char> folded(length_.size(), 0), suspected(mesh_.faces().size(), 0);
  for (int round = 0; round < kShrinkRounds && !suspects.empty(); ++round) {
    std::vector<int> corners;
    for (const int f : suspects) {
      if (!can_be_filled(f) || well_shaped(f, kMinVolume)) continue;
      for (int c = 0; c < 3; ++c) {
        const int own = offset(f, c);
        if (!std::exchange(folded[at(own)], 1)) corners.push_back(own);
      }
    }
    const std::vector<double> before = length_;
    for (const int own : corners) {
      folded[at(own)] = 0;
      shorten(own, kShapeShrink * length_[at(own)]);
      shortened_.push_back(own);
    }
    smooth();
    suspects.clear();
    for (int own = 0; own < offset_count(); ++own) {
      if (length_[at(own)] == before[at(own)]) continue;
      for (const int f : faces_around(own)) {
        if (!std::exchange(suspected[at(f)], 1)) suspects.push_back(f);
      }
    }
    for (const int f : suspects) suspected[at(f)] = 0;
  }
}

/// Limits the offset vectors that fan out below an edge to the length of the longest offset vector that belongs to a
/// face.
void PadFit::lower_fans() {
  const auto lower = [&](const std::vector<int>& fan, double most) {
    for (const int own : fan) {
      if (faces_around(own).empty() && length_[at(own)] > most) shorten(own, most);
      if (faces_around(own).empty() && !(most > 0)) collapsed_[at(own)] = 1;
    }
  };
  for (const PadWedge& wedge : offsets_.wedges) {
    for (const std::vector<int>* fan : {&wedge.at_u, &wedge.at_v})
      lower(*fan, std::max(length_[at(fan->front())], length_[at(fan->back())]));
  }
  for (const PadCone& cone : offsets_.cones) {
    double most = 0;
    for (const int own : cone.rim) most = std::max(most, length_[at(own)]);
    lower({cone.center}, most);
  }
}

std::vector<int> PadShape::ends() const {
  std::vector<int> numbers(offsets_.skin.size());
  for (int own = 0; own < offset_count(); ++own) numbers[at(own)] = inner(own);
  return numbers;
}

/// Marks the vertices whose gaps have a tet without positive volume. Returns true if there are any.
bool PadFit::find_folded_gaps(std::vector<char>& whole) const {
  bool any = false;
  const std::vector<int> inner_ends = ends();
  const auto folded = [&](const ivec4& t) {
    return is_flat({position(t[0]), position(t[1]), position(t[2]), position(t[3])});
  };
  const auto check = [&](const std::vector<ivec4>& some, std::initializer_list<int> vertices) {
    if (std::none_of(some.begin(), some.end(), folded)) return;
    for (const int v : vertices) any = std::exchange(whole[at(v)], 1) == 0 || any;
  };
  for (const PadWedge& wedge : offsets_.wedges) check(gap_tets(wedge, inner_ends), {wedge.u, wedge.v});
  for (const PadCone& cone : offsets_.cones) check(gap_tets(cone, inner_ends), {cone.v});
  if (!any) return false;
  // Tets that end on the marked vertices would fold next.
  const std::vector<char> marked = whole;
  for (const PadWedge& wedge : offsets_.wedges) {
    if (marked[at(wedge.u)] || marked[at(wedge.v)]) whole[at(wedge.u)] = whole[at(wedge.v)] = 1;
  }
  return true;
}

/// Computes the depths of the inner vertices that have moved since their offset was found. Equal vertices of a coarse
/// shape give their depth.
void PadFit::set_depths(const PadShape* coarse) {
  const int shared = coarse == nullptr ? 0 : coarse->mesh_.vertex_count();
  const auto is_shared = [&](int own) {
    return own < shared && coarse->length_[at(own)] == length_[at(own)] &&
           coarse->offsets_.inward[at(own)].direction == offsets_.inward[at(own)].direction;
  };
  const auto find_depth = [&](int own) {
    if (collapsed_[at(own)]) return 0.0;
    if (is_shared(own)) return coarse->depth_[at(own)];
    return std::max(0.0, -index_.signed_point(inner_position(own), length_[at(own)]).signed_distance);
  };
  constexpr int kChunk = 64;
  parallel_chunks(offset_count(), kChunk, [&](int begin, int end) {
    for (int own = begin; own < end; ++own) {
      if (depth_[at(own)] < 0) depth_[at(own)] = find_depth(own);
    }
  });
}

PrismTets PadShape::tets(int face) const {
  return can_be_filled(face) && well_shaped(face, kFoldedVolume) ? prism(face) : PrismTets{};
}

/// Returns true if the prism below a face is sound after the offset vectors of these corners (bit c: corner c) are
/// collapsed, too.
bool PadFit::is_sound_without(int face, unsigned corners) {
  const std::array<char, 3> before{collapsed_[at(offset(face, 0))], collapsed_[at(offset(face, 1))],
                                   collapsed_[at(offset(face, 2))]};
  for (int c = 0; c < 3; ++c) {
    if ((corners >> c & 1U) != 0) collapsed_[at(offset(face, c))] = 1;
  }
  const bool sound = tets(face).count > 0;
  for (int c = 0; c < 3; ++c) collapsed_[at(offset(face, c))] = before[at(c)];
  return sound;
}

/// Returns the corners of a folded face whose offset vectors must be collapsed, as bits. Offset vectors almost edge-on
/// to the face come first, unless the face is tiny; a tiny face has no prism, without any cost for the faces around it.
/// Then as few offset vectors are collapsed as are needed for a sound prism, those with the least cosine to the face's
/// normal first; all offset vectors if this is not sufficient.
unsigned PadFit::corners_to_collapse(int face) {
  constexpr double kTinyFace = 1e-3;  // area of a tiny face in squared thicknesses
  std::array<double, 3> cosine{};
  unsigned edge_on = 0;
  for (int c = 0; c < 3; ++c) {
    const int own = offset(face, c);
    cosine[at(c)] = -glm::dot(mesh_.face_normals()[at(face)], offsets_.inward[at(own)].direction);
    if (!collapsed_[at(own)] && cosine[at(c)] < kEdgeOn) edge_on |= 1U << c;
  }
  if (edge_on != 0 && mesh_.face_areas()[at(face)] < kTinyFace * thickness_ * thickness_) return 0;
  std::array<unsigned, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](unsigned a, unsigned b) { return cosine[a] < cosine[b]; });
  const auto bit = [&](std::size_t i) { return 1U << order[i]; };
  for (const unsigned corners : {0U, bit(0), bit(1), bit(2), bit(0) | bit(1), bit(0) | bit(2), bit(1) | bit(2)}) {
    if (is_sound_without(face, corners | edge_on)) return corners | edge_on;
  }
  return 7;
}

/// Collapses corners of prisms that are folded even after shrinking, until none is left. A face is tested again only if
/// an offset vector around it has changed.
void PadFit::collapse_folded() {
  std::vector<int> suspects(mesh_.faces().size());
  std::iota(suspects.begin(), suspects.end(), 0);
  while (!suspects.empty()) {
    std::vector<int> next;
    for (const int f : suspects) {
      if (tets(f).count > 0) continue;
      const unsigned corners = corners_to_collapse(f);
      for (int c = 0; c < 3; ++c) {
        const int own = offset(f, c);
        if ((corners >> c & 1U) == 0 || std::exchange(collapsed_[at(own)], 1)) continue;
        shorten(own, 0);
        const std::span<const int> around = faces_around(own);
        next.insert(next.end(), around.begin(), around.end());
      }
    }
    suspects = std::move(next);
  }
}

namespace {

/// The middle of an inner triangle has crossed the medial axis if its depth is less than this fraction of the depth
/// that its corners have at least.
constexpr double kBeyond = 0.8;
/// A face without an edge longer than this fraction of its offsets crosses no wall that its corners do not cross.
constexpr double kSmall = 0.5;
/// Factor by which the offsets of crossing prisms shrink in a round, and most rounds (down to a fifteenth).
constexpr double kWallShrink = 0.8;
constexpr int kRounds = 12;

}  // namespace

/// Returns true if the middle of a face's inner triangle is beyond the medial axis, although its corners are not: below
/// a large face the other wall may be nearer than at the corners. The depth of the middle is compared with the least
/// depth of the corners (PadFit::own_length); below convex skin it cannot be less.
bool PadFit::crosses_wall(int face) const {
  double least = 0, longest = 0, edge = 0;
  dvec3 centroid(0);
  for (int c = 0; c < 3; ++c) {
    const int own = offset(face, c);
    if (collapsed_[at(own)] || !(length_[at(own)] > 0)) return false;
    least += kOwnDepth * offsets_.inward[at(own)].least_cosine * length_[at(own)] / 3.0;
    longest = std::max(longest, length_[at(own)]);
    centroid += inner_position(own) / 3.0;
    edge = std::max(edge, glm::distance(mesh_.vertex(face, c), mesh_.vertex(face, (c + 1) % 3)));
  }
  if (edge < kSmall * longest) return false;
  least *= kBeyond;
  return depth_inside(index_, centroid, least) < least;
}

/// Shortens the offsets of prisms that cross the middle of a wall.
void PadFit::shrink_crossing() {
  constexpr int kChunk = 64;
  std::vector<int> suspects(mesh_.faces().size());
  std::iota(suspects.begin(), suspects.end(), 0);
  for (int round = 0; round < kRounds && !suspects.empty(); ++round) {
    std::vector<char> crossing(suspects.size(), 0);
    parallel_chunks(static_cast<int>(suspects.size()), kChunk, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) crossing[at(i)] = crosses_wall(suspects[at(i)]) ? 1 : 0;
    });
    const std::vector<double> before = length_;
    std::vector<char> shrunk(length_.size(), 0);
    for (std::size_t i = 0; i < suspects.size(); ++i) {
      for (int c = 0; c < 3 && crossing[i] != 0; ++c) {
        const int own = offset(suspects[i], c);
        if (std::exchange(shrunk[at(own)], 1)) continue;
        shorten(own, kWallShrink * length_[at(own)]);
        shortened_.push_back(own);
      }
    }
    smooth();
    suspects.clear();
    std::vector<char> suspected(mesh_.faces().size(), 0);
    for (int own = 0; own < offset_count(); ++own) {
      if (length_[at(own)] == before[at(own)]) continue;
      for (const int f : faces_around(own)) {
        if (!std::exchange(suspected[at(f)], 1)) suspects.push_back(f);
      }
    }
  }
}

}  // namespace taxel
