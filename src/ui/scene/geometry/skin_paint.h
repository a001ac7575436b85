// Pieces of a skin as triangles in flat colours.
#pragma once

#include <cstdint>
#include <vector>

#include "ui/scene/geometry/field_patch.h"

namespace taxel::ui {

struct PaintVertex {
  glm::vec3 position{0};
  std::uint32_t rgba = 0;  ///< sRGB, straight alpha, red in the lowest byte
};

inline void append_piece(const SkinPiece& piece, std::uint32_t rgba, std::vector<PaintVertex>& out) {
  for (const dvec3& p : {piece.a, piece.b, piece.c}) out.push_back({glm::vec3(p), rgba});
}

}  // namespace taxel::ui
