// Conversion of signed indices for containers.
#pragma once

#include <cstddef>

namespace taxel {

/// Returns the index i, which must not be negative, in the type that containers take: v[at(i)]. Indices are stored as
/// int because a mesh, a layout or a surface has fewer than 2^31 parts, and int takes half the memory.
[[nodiscard]] constexpr std::size_t at(int i) noexcept {
  return static_cast<std::size_t>(i);
}

}  // namespace taxel
