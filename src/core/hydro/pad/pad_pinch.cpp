// Repair of folded prisms of a pad: the legs of as few corners as possible are collapsed, so that the faces around keep
// their prisms.
#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "core/hydro/pad/pad_shape.h"

namespace taxel {

/// Returns true if the prism below a face is sound after the legs of these corners (bit c: corner c) are collapsed,
/// too.
bool PadShape::is_sound_without(int face, unsigned corners) {
  const std::array<char, 3> before{pinched_[at(leg(face, 0))], pinched_[at(leg(face, 1))], pinched_[at(leg(face, 2))]};
  for (int c = 0; c < 3; ++c) {
    if ((corners >> c & 1U) != 0) pinched_[at(leg(face, c))] = 1;
  }
  const bool sound = tets(face).count > 0;
  for (int c = 0; c < 3; ++c) pinched_[at(leg(face, c))] = before[at(c)];
  return sound;
}

/// Returns the corners of a folded face whose legs must be collapsed, as bits. Legs almost edge-on to the face come
/// first, unless the face is tiny; a tiny face has no prism, without any cost for the faces around it. Then as few legs
/// are collapsed as are needed for a sound prism, those with the least cosine to the face's normal first; all legs if
/// this is not sufficient.
unsigned PadShape::corners_to_pinch(int face) {
  constexpr double kTinyFace = 1e-3;  // area of a tiny face in squared thicknesses
  std::array<double, 3> cosine{};
  unsigned edge_on = 0;
  for (int c = 0; c < 3; ++c) {
    const int own = leg(face, c);
    cosine[at(c)] = -glm::dot(mesh_.face_normals()[at(face)], legs_.inward[at(own)].direction);
    if (!pinched_[at(own)] && cosine[at(c)] < kEdgeOn) edge_on |= 1U << c;
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
/// a leg around it has changed.
void PadShape::pinch_folded() {
  std::vector<int> suspects(mesh_.faces().size());
  std::iota(suspects.begin(), suspects.end(), 0);
  while (!suspects.empty()) {
    std::vector<int> next;
    for (const int f : suspects) {
      if (tets(f).count > 0) continue;
      const unsigned corners = corners_to_pinch(f);
      for (int c = 0; c < 3; ++c) {
        const int own = leg(f, c);
        if ((corners >> c & 1U) == 0 || std::exchange(pinched_[at(own)], 1)) continue;
        shorten(own, 0);
        const std::span<const int> around = faces_around(own);
        next.insert(next.end(), around.begin(), around.end());
      }
    }
    suspects = std::move(next);
  }
}

}  // namespace taxel
