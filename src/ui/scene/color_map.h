// Colours of data: colour maps for numbers, one row each, and a palette for taxels. sRGB, 0 to 1.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string_view>

#include "core/base/page/viridis.h"
#include "core/hydro/contact_surface.h"

namespace taxel::ui {

/// A colour map. A new colour map is a table next to viridis.h and a row of kColorMaps.
struct ColorMap {
  std::string_view word;   ///< key in files
  std::string_view label;  ///< name as shown to the user
  std::span<const Rgb8, 256> table;

  /// Returns the colour at t in [0, 1], linear between the table's entries. Smaller, larger and NaN t are clamped.
  [[nodiscard]] glm::vec3 at(double t) const;
};

/// The first row colours all quantities that have no choice of their own.
inline constexpr std::array kColorMaps{ColorMap{"viridis", "Viridis", kViridis}};

/// Returns the colour of a taxel by its number, SensorModel::color. The 24 colours repeat.
glm::vec3 taxel_color(int number);
/// Returns the colour of polygons that a contact surface excludes for a reason: a colour that no map has.
glm::vec3 rejection_color(Rejection reason);
/// Returns a colour with alpha as four bytes, red in the lowest.
std::uint32_t pack(const glm::vec4& rgba);
/// Returns an opaque colour as four bytes.
inline std::uint32_t pack(const glm::vec3& rgb) {
  return pack(glm::vec4(rgb, 1));
}

}  // namespace taxel::ui
