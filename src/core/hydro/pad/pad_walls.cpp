// Limits the prisms below large faces, so that their inner triangles stay on their side of thin walls.
#include <algorithm>
#include <numeric>
#include <utility>

#include "core/base/parallel.h"
#include "core/hydro/pad/pad_pressures.h"
#include "core/hydro/pad/pad_shape.h"

namespace taxel {
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
/// depth of the corners (PadShape::own_offset); below convex skin it cannot be less.
bool PadShape::crosses_wall(int face) const {
  double least = 0, longest = 0, edge = 0;
  dvec3 centroid(0);
  for (int c = 0; c < 3; ++c) {
    const int own = leg(face, c);
    if (pinched_[at(own)] || !(offset_[at(own)] > 0)) return false;
    least += kOwnDepth * legs_.inward[at(own)].least_cosine * offset_[at(own)] / 3.0;
    longest = std::max(longest, offset_[at(own)]);
    centroid += inner_position(own) / 3.0;
    edge = std::max(edge, glm::distance(mesh_.vertex(face, c), mesh_.vertex(face, (c + 1) % 3)));
  }
  if (edge < kSmall * longest) return false;
  least *= kBeyond;
  return depth_inside(index_, centroid, least) < least;
}

/// Shortens the offsets of prisms that cross the middle of a wall.
void PadShape::shrink_crossing() {
  constexpr int kChunk = 64;
  std::vector<int> suspects(mesh_.faces().size());
  std::iota(suspects.begin(), suspects.end(), 0);
  for (int round = 0; round < kRounds && !suspects.empty(); ++round) {
    std::vector<char> crossing(suspects.size(), 0);
    parallel_chunks(static_cast<int>(suspects.size()), kChunk, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) crossing[at(i)] = crosses_wall(suspects[at(i)]) ? 1 : 0;
    });
    const std::vector<double> before = offset_;
    std::vector<char> shrunk(offset_.size(), 0);
    for (std::size_t i = 0; i < suspects.size(); ++i) {
      for (int c = 0; c < 3 && crossing[i] != 0; ++c) {
        const int own = leg(suspects[i], c);
        if (std::exchange(shrunk[at(own)], 1)) continue;
        shorten(own, kWallShrink * offset_[at(own)]);
        shortened_.push_back(own);
      }
    }
    smooth();
    suspects.clear();
    std::vector<char> suspected(mesh_.faces().size(), 0);
    for (int own = 0; own < leg_count(); ++own) {
      if (offset_[at(own)] == before[at(own)]) continue;
      for (const int f : faces_around(own)) {
        if (!std::exchange(suspected[at(f)], 1)) suspects.push_back(f);
      }
    }
  }
}

}  // namespace taxel
