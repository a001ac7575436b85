// Colours of data: viridis for pressure, a colour-blind-safe palette for taxels. sRGB, 0..1.
#pragma once

#include <cstdint>

#include <glm/glm.hpp>

#include "core/hydro/contact_surface.h"

namespace taxel::ui {

/// viridis (van der Walt, Smith 2015; CC0) at t in [0, 1], clamped: 256 entries, linear between them.
glm::vec3 viridis(double t);
/// 256 RGB8 entries for a lookup texture.
const unsigned char* viridis_table();
/// Colour of a taxel by its number, SensorModel::color: Okabe-Ito, then the safe extension, repeating after 24.
glm::vec3 taxel_color(int number);
/// Colour of what was left out of a contact surface for one reason: none that viridis has.
glm::vec3 rejection_color(Rejection reason);
/// sRGB 0..1 with alpha as four bytes, red in the lowest.
std::uint32_t pack(const glm::vec4& rgba);
inline std::uint32_t pack(const glm::vec3& rgb) {
  return pack(glm::vec4(rgb, 1));
}

}  // namespace taxel::ui
