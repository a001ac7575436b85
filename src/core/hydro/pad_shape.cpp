#include "core/hydro/pad_shape.h"

#include <numeric>
#include <utility>

#include "core/base/parallel.h"

namespace taxel {
namespace {

/// An inner vertex counts as beyond the medial axis, thus as owned by another part of the skin, where its distance to
/// the skin is less than this part of the depth that the faces around its own vertex promise.
constexpr double kOwnDepth = 0.95;
/// Where the body is thin, a pad takes this part of the way to the medial axis.
constexpr double kThinMargin = 0.9;
/// A mitre is at most this times as long as the thickness.
constexpr double kLongestMitre = 2.0;
/// Offsets of neighbours differ at most by this times their distance.
constexpr double kLargestSlope = 1.5;
/// A tet is well shaped when its volume is at least this part of the third of a straight prism's.
constexpr double kLeastVolume = 0.05;
/// Below this part it counts as folded; not zero, because planes of flatter tets are rounding.
constexpr double kFoldedVolume = 1e-4;
/// A face this nearly edge on to the direction of one of its corners folds back however short the offset.
constexpr double kEdgeOn = 0.1;
/// Folded prisms shrink by this, at most so often (to a ten thousandth).
constexpr double kShrink = 0.8;
constexpr int kShrinkRounds = 40;

}  // namespace

PadShape::PadShape(const MeshIndex& index, double thickness)
    : index_(index), mesh_(index.mesh()), thickness_(thickness), inward_(pad_directions(index.mesh())) {
  offset_.assign(mesh_.vertices().size(), 0.0);
  full_.assign(mesh_.vertices().size(), thickness);
  depth_.assign(mesh_.vertices().size(), 0.0);
  pinched_.assign(mesh_.vertices().size(), 0);
  gather_faces();
  constexpr int kChunk = 64;
  parallel_chunks(mesh_.vertex_count(), kChunk, [&](int begin, int end) {
    for (int v = begin; v < end; ++v) set_offset(v);
  });
  for (int v = 0; v < mesh_.vertex_count(); ++v) shortened_.push_back(v);
  smooth();
  shrink_folded();
  pinch_folded();
  set_depths();
}

void PadShape::gather_faces() {
  first_face_.assign(mesh_.vertices().size() + 1, 0);
  for (const ivec3& f : mesh_.faces()) {
    for (int c = 0; c < 3; ++c) ++first_face_[at(f[c]) + 1];
  }
  for (std::size_t v = 1; v < first_face_.size(); ++v) first_face_[v] += first_face_[v - 1];
  faces_at_.resize(3 * mesh_.faces().size());
  steepest_.resize(faces_at_.size());
  std::vector<int> next(first_face_.begin(), first_face_.end() - 1);
  for (int f = 0; f < mesh_.face_count(); ++f) {
    for (int c = 0; c < 3; ++c) {
      faces_at_[at(next[at(mesh_.faces()[at(f)][c])]++)] = f;
      steepest_[at(3 * f + c)] = kLargestSlope * glm::distance(mesh_.vertex(f, c), mesh_.vertex(f, (c + 1) % 3));
    }
  }
}

std::span<const int> PadShape::faces_around(int v) const {
  return {faces_at_.data() + first_face_[at(v)], faces_at_.data() + first_face_[at(v) + 1]};
}

/// The largest offset up to `most` at which the inner vertex is still owned by its own part of the skin, with its depth
/// there; 0 where there is none. Shrinking balls (Ma, Bae, Choi 2012): the ball about the inner vertex whose radius is
/// the least depth asked for, s h, must hold no point of the skin. Where it holds q, the ball is shrunk until q lies on
/// it: |v + h d - q| = s h.
double PadShape::own_offset(int v, double most, double& depth) const {
  constexpr int kMostBalls = 30;
  constexpr double kLeastOffset = 1e-3, kTouching = 5e-3;
  const dvec3& direction = inward_[at(v)].direction;
  const double s = kOwnDepth * inward_[at(v)].least_cosine;
  double h = most;
  for (int i = 0; i < kMostBalls && h > kLeastOffset * most; ++i) {
    const SignedPoint q = index_.signed_point(moved(v, h), h);  // its own vertex is as near as that
    depth = -q.signed_distance;
    if (depth >= (s - (i > 0 ? kTouching : 0.0)) * h) return h;
    // (1 - s^2) h^2 + 2 (w d) h + w^2 = 0 with w = v - q; its smaller root, in the form that loses no digits.
    const dvec3 w = mesh_.vertices()[at(v)] - q.point.position;
    const double half_b = glm::dot(w, direction), c = glm::dot(w, w);
    const double root = half_b * half_b - (1 - s * s) * c;
    const double next = root > 0 && half_b < 0 ? c / (std::sqrt(root) - half_b) : 0.5 * h;
    h = std::min(next, 0.999 * h);  // beyond another wall no ball touches: step back
  }
  depth = 0;
  return 0;
}

/// The largest offset up to where the depth is H, that does not cross the medial axis.
void PadShape::set_offset(int v) {
  if (inward_[at(v)].least_cosine < kEdgeOn) {  // no direction leads inside
    pinched_[at(v)] = 1;
    return;
  }
  // No point of the body is deeper than half its smallest extent.
  const dvec3 extent = mesh_.bounds().extent();
  double most = std::min(thickness_, 0.5 * std::min({extent.x, extent.y, extent.z}));
  // A ball of less than half the offset could pass a wall between: look half way first.
  constexpr double kNarrow = 0.5;
  double& depth = depth_[at(v)];
  double h = most;
  if (inward_[at(v)].least_cosine < kNarrow) h = own_offset(v, 0.5 * most, depth);
  if (h >= 0.5 * most) h = own_offset(v, most, depth);
  if (h == thickness_ && depth < 0.99 * thickness_) {
    // A ridge loses depth along its bisector: go as much farther as its faces' angles say (a mitre).
    most = full_[at(v)] = thickness_ * std::min(thickness_ / depth, kLongestMitre);
    h = own_offset(v, most, depth);
  }
  offset_[at(v)] = h;
  if (h < most) shorten(v, kThinMargin * h);
}

void PadShape::shorten(int v, double offset) {
  offset_[at(v)] = offset;
  depth_[at(v)] = -1;
}

/// Lowers offsets until no edge is steeper than allowed. Pinched vertices are no bound: tets may stand upright there.
void PadShape::smooth() {
  while (!shortened_.empty()) {
    const int low = shortened_.back();
    shortened_.pop_back();
    if (pinched_[at(low)]) continue;
    for (const int f : faces_around(low)) {
      const ivec3& face = mesh_.faces()[at(f)];
      const int c = face.x == low ? 0 : face.y == low ? 1 : 2, before = (c + 2) % 3;
      const std::array<std::pair<int, double>, 2> beside{
          {{face[(c + 1) % 3], steepest_[at(3 * f + c)]}, {face[before], steepest_[at(3 * f + before)]}}};
      for (const auto& [high, steepest] : beside) {
        // Each change moves at least by a part of the thickness: the loop ends.
        if (offset_[at(high)] <= offset_[at(low)] + steepest + 1e-6 * thickness_) continue;
        shorten(high, offset_[at(low)] + steepest);
        shortened_.push_back(high);
      }
    }
  }
}

dvec3 PadShape::position(int v) const {
  const int n = mesh_.vertex_count();
  return v < n ? mesh_.vertices()[at(v)] : inner_position(v - n);
}

/// Whether all corners' offsets go below the face; if not, no offset is short enough.
bool PadShape::can_be_filled(int face) const {
  const ivec3& f = mesh_.faces()[at(face)];
  for (int c = 0; c < 3; ++c) {
    const double cosine = -glm::dot(mesh_.face_normals()[at(face)], inward_[at(f[c])].direction);
    if (!pinched_[at(f[c])] && cosine < kEdgeOn) return false;
  }
  return true;
}

PrismTets PadShape::prism(int face) const {
  const ivec3& f = mesh_.faces()[at(face)];
  return split_prism(f, {inner(f.x), inner(f.y), inner(f.z)});
}

/// Whether every tet has at least `part` of the prism's third, taken with the shortest offset around the face.
bool PadShape::well_shaped(int face, double part) const {
  double h = std::numeric_limits<double>::infinity();
  for (int c = 0; c < 3; ++c) {
    const int v = mesh_.faces()[at(face)][c];
    if (!pinched_[at(v)]) h = std::min(h, offset_[at(v)]);
  }
  const PrismTets prism_tets = prism(face);
  for (int i = 0; i < prism_tets.count; ++i) {
    const ivec4& t = prism_tets.tets[at(i)];
    const dvec3 o = position(t[0]);
    const double six = glm::dot(glm::cross(position(t[1]) - o, position(t[2]) - o), position(t[3]) - o);
    if (!(six > part * 2.0 * mesh_.face_areas()[at(face)] * h)) return false;
  }
  return true;
}

/// Shortens the offsets of folded prisms until none is folded, or so often. A face is looked at again only where an
/// offset around it changed.
void PadShape::shrink_folded() {
  std::vector<int> suspects(mesh_.faces().size());
  std::iota(suspects.begin(), suspects.end(), 0);
  std::vector<char> folded(offset_.size(), 0), suspected(mesh_.faces().size(), 0);
  for (int round = 0; round < kShrinkRounds && !suspects.empty(); ++round) {
    std::vector<int> corners;
    for (const int f : suspects) {
      if (!can_be_filled(f) || well_shaped(f, kLeastVolume)) continue;
      for (int c = 0; c < 3; ++c) {
        const int v = mesh_.faces()[at(f)][c];
        if (!std::exchange(folded[at(v)], 1)) corners.push_back(v);
      }
    }
    const std::vector<double> before = offset_;
    for (const int v : corners) {
      folded[at(v)] = 0;
      shorten(v, kShrink * offset_[at(v)]);
      shortened_.push_back(v);
    }
    smooth();
    suspects.clear();
    for (int v = 0; v < mesh_.vertex_count(); ++v) {
      if (offset_[at(v)] == before[at(v)]) continue;
      for (const int f : faces_around(v)) {
        if (!std::exchange(suspected[at(f)], 1)) suspects.push_back(f);
      }
    }
    for (const int f : suspects) suspected[at(f)] = 0;
  }
}

/// Pinches the corners of prisms that no shrinking unfolded, until none is left.
void PadShape::pinch_folded() {
  std::vector<int> suspects(mesh_.faces().size());
  std::iota(suspects.begin(), suspects.end(), 0);
  while (!suspects.empty()) {
    std::vector<int> next;
    for (const int f : suspects) {
      if (!can_be_filled(f) || well_shaped(f, kFoldedVolume)) continue;
      for (int c = 0; c < 3; ++c) {
        const int v = mesh_.faces()[at(f)][c];
        if (std::exchange(pinched_[at(v)], 1)) continue;
        shorten(v, 0);
        const std::span<const int> around = faces_around(v);
        next.insert(next.end(), around.begin(), around.end());
      }
    }
    suspects = std::move(next);
  }
}

/// Depths of the inner vertices that moved after their offset was found.
void PadShape::set_depths() {
  constexpr int kChunk = 64;
  parallel_chunks(mesh_.vertex_count(), kChunk, [&](int begin, int end) {
    for (int v = begin; v < end; ++v) {
      if (depth_[at(v)] < 0)
        depth_[at(v)] = pinched_[at(v)]
                            ? 0.0
                            : std::max(0.0, -index_.signed_point(inner_position(v), offset_[at(v)]).signed_distance);
    }
  });
}

PrismTets PadShape::tets(int face) const {
  return can_be_filled(face) && well_shaped(face, kFoldedVolume) ? prism(face) : PrismTets{};
}

}  // namespace taxel
