// NumPy arrays of an archive: vectors and poses as rows of numbers, and back, and arrays whose values are checked
// before they are used. Quaternions are w x y z.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/archive/npz.h"
#include "core/base/error.h"
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

/// Returns the vector that begins at this number.
inline dvec3 vector_at(const std::vector<double>& numbers, std::size_t first) {
  return {numbers[first], numbers[first + 1], numbers[first + 2]};
}
inline Pose pose_of_row(const std::vector<double>& positions, const std::vector<double>& quaternions, std::size_t row) {
  const double* q = &quaternions[4 * row];
  return {{q[0], q[1], q[2], q[3]}, vector_at(positions, 3 * row)};
}

// Checked arrays: finite numbers, unit quaternions, whole numbers within limits. Every function throws Error that names
// file, array, row and value.

/// Largest number in an array, in SI units. Squares and sums of such forces, pressures and lengths stay finite, also in
/// single precision after one product with a length.
inline constexpr double kLargestNumber = 1e30;

/// Largest coordinate of a body [m]: MuJoCo stops a simulation beyond it (mjMAXVAL).
inline constexpr double kLargestCoordinate = 1e10;

/// Reads numbers that must all be finite, and at most `largest`.
inline std::vector<double> finite_doubles(const NpzReader& in, const std::string& name, const NpzReader::Shape& shape,
                                          double largest = kLargestNumber) {
  std::vector<double> values = in.doubles(name, shape);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i]))
      throw Error(in.file(), name, fmt::format("value {} must be finite, is {}", i, values[i]));
    if (std::abs(values[i]) > largest)
      throw Error(in.file(), name, fmt::format("value {} must be at most {:g}, is {}", i, largest, values[i]));
  }
  return values;
}

/// Reads quaternions w x y z, the rows of an array. Each length must be 1 within 1e-3; MuJoCo normalises the
/// quaternions of a scene.
inline std::vector<double> unit_quaternions(const NpzReader& in, const std::string& name,
                                            const NpzReader::Shape& shape) {
  constexpr double kTolerance = 1e-3;
  std::vector<double> values = finite_doubles(in, name, shape);
  for (std::size_t i = 0; i + 3 < values.size(); i += 4) {
    const double length = std::hypot(std::hypot(values[i], values[i + 1]), std::hypot(values[i + 2], values[i + 3]));
    if (!(std::abs(length - 1) <= kTolerance))
      throw Error(in.file(), name, fmt::format("quaternion {} must be of length 1, is of length {}", i / 4, length));
  }
  return values;
}

/// Reads whole numbers that must be from `least` to `most`.
inline std::vector<std::int64_t> bounded_integers(const NpzReader& in, const std::string& name,
                                                  const NpzReader::Shape& shape, std::int64_t least,
                                                  std::int64_t most) {
  std::vector<std::int64_t> values = in.integers(name, shape);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i] < least || values[i] > most)
      throw Error(in.file(), name, fmt::format("value {} must be from {} to {}, is {}", i, least, most, values[i]));
  return values;
}

}  // namespace taxel
