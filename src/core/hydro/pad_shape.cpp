#include "core/hydro/pad_shape.h"

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
  pinched_.assign(mesh_.vertices().size(), 0);
  constexpr int kChunk = 64;
  parallel_chunks(mesh_.vertex_count(), kChunk, [&](int begin, int end) {
    for (int v = begin; v < end; ++v) set_offset(v);
  });
  smooth();
  for (int round = 0; round < kShrinkRounds && shrink_folded() > 0; ++round) smooth();
  while (pinch_folded() > 0) {
  }
}

/// Depth at the offset h, or a negative number where it lies outside or belongs to another part of the skin.
double PadShape::own_depth(int v, double h) const {
  const double depth = -index_.signed_distance(moved(v, h));
  return depth >= kOwnDepth * h * inward_[at(v)].least_cosine ? depth : -1.0;
}

/// The largest offset up to where the depth is H, that does not cross the medial axis.
void PadShape::set_offset(int v) {
  if (inward_[at(v)].least_cosine < kEdgeOn) {  // no direction leads inside
    pinched_[at(v)] = 1;
    return;
  }
  double good = 0, bad = -1, depth = -1;
  const auto try_offset = [&](double h) {
    depth = own_depth(v, h);
    (depth > 0 ? good : bad) = h;
    return depth > 0;
  };
  // No point of the body is deeper than half its smallest extent.
  const dvec3 extent = mesh_.bounds().extent();
  const double reach = std::min(thickness_, 0.5 * std::min({extent.x, extent.y, extent.z}));
  if (try_offset(0.5 * reach) && try_offset(reach) && reach == thickness_ && depth < 0.99 * reach) {
    // A ridge loses depth along its bisector: go as much farther as its faces' angles say (a mitre).
    full_[at(v)] = thickness_ * std::min(thickness_ / depth, kLongestMitre);
    try_offset(full_[at(v)]);
  }
  if (bad >= 0) {
    constexpr int kBisections = 10;
    for (int i = 0; i < kBisections; ++i) try_offset(0.5 * (good + bad));
    good *= kThinMargin;
  }
  offset_[at(v)] = good;
}

/// Lowers offsets until no edge is steeper than allowed. Pinched vertices are no bound: tets may stand upright there.
void PadShape::smooth() {
  bool changed = true;
  const auto lower = [&](int a, int b, double most) {
    // Each change moves at least by a part of the thickness: the loop ends.
    if (pinched_[at(b)] || offset_[at(a)] <= offset_[at(b)] + most + 1e-6 * thickness_) return;
    offset_[at(a)] = offset_[at(b)] + most;
    changed = true;
  };
  while (changed) {
    changed = false;
    for (const ivec3& f : mesh_.faces()) {
      for (int c = 0; c < 3; ++c) {
        const int a = f[c], b = f[(c + 1) % 3];
        const double most = kLargestSlope * glm::distance(mesh_.vertices()[at(a)], mesh_.vertices()[at(b)]);
        lower(a, b, most);
        lower(b, a, most);
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

/// Shortens the offsets of folded prisms; how many there were.
int PadShape::shrink_folded() {
  std::vector<char> folded(offset_.size(), 0);
  int count = 0;
  for (int f = 0; f < mesh_.face_count(); ++f) {
    if (!can_be_filled(f) || well_shaped(f, kLeastVolume)) continue;
    ++count;
    for (int c = 0; c < 3; ++c) folded[at(mesh_.faces()[at(f)][c])] = 1;
  }
  for (std::size_t v = 0; v < offset_.size(); ++v) {
    if (folded[v]) offset_[v] *= kShrink;
  }
  return count;
}

/// Pinches the corners of prisms that no shrinking unfolded; how many were newly pinched.
int PadShape::pinch_folded() {
  int count = 0;
  for (int f = 0; f < mesh_.face_count(); ++f) {
    if (!can_be_filled(f) || well_shaped(f, kFoldedVolume)) continue;
    for (int c = 0; c < 3; ++c) {
      const std::size_t v = at(mesh_.faces()[at(f)][c]);
      if (pinched_[v]) continue;
      pinched_[v] = 1;
      offset_[v] = 0;
      ++count;
    }
  }
  return count;
}

PrismTets PadShape::tets(int face) const {
  return can_be_filled(face) && well_shaped(face, kFoldedVolume) ? prism(face) : PrismTets{};
}

}  // namespace taxel
