// Vectors and poses as rows of NumPy arrays, and back. Quaternions are w x y z.
#pragma once

#include <vector>

#include "core/base/math.h"

namespace taxel {

inline void append(std::vector<double>& to, const dvec3& v) {
  to.insert(to.end(), {v.x, v.y, v.z});
}
inline void append(std::vector<double>& to, const dvec2& v) {
  to.insert(to.end(), {v.x, v.y});
}
inline void append(std::vector<double>& to, const dquat& q) {
  to.insert(to.end(), {q.w, q.x, q.y, q.z});
}
inline void append(std::vector<double>& positions, std::vector<double>& quaternions, const Pose& pose) {
  append(positions, pose.p);
  append(quaternions, pose.q);
}

/// That begins at this number.
inline dvec3 vector_at(const std::vector<double>& numbers, std::size_t first) {
  return {numbers[first], numbers[first + 1], numbers[first + 2]};
}
inline Pose pose_of_row(const std::vector<double>& positions, const std::vector<double>& quaternions, std::size_t row) {
  const double* q = &quaternions[4 * row];
  return {{q[0], q[1], q[2], q[3]}, vector_at(positions, 3 * row)};
}

}  // namespace taxel
