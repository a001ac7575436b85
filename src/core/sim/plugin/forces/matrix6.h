// Functions of six by six matrices.
#pragma once

#include "core/hydro/traction.h"

namespace taxel {

inline Matrix6 transposed(const Matrix6& A) {
  Matrix6 T{};
  for (std::size_t r = 0; r < 6; ++r)
    for (std::size_t c = 0; c < 6; ++c) T[c][r] = A[r][c];
  return T;
}

}  // namespace taxel
