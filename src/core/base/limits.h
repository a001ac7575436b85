// Limits of the size of a run and of a recording, in one place, so that every reader and writer refuses the same.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "core/base/error.h"

namespace taxel {

/// Largest number of steps of one simulation. A step of the smallest scene takes about 20 microseconds, so this number
/// takes half an hour.
inline constexpr double kMaxSteps = 1e8;

/// Largest memory for the rows of a recording [bytes]. Writing a recording takes about twice as much in addition.
inline constexpr std::size_t kMaxRecordingBytes = std::size_t{1} << 30U;

/// Largest coordinate of a vertex or a taxel [m]. Squares and cubes of much larger lengths overflow, and then no place
/// on a mesh is the nearest.
inline constexpr double kFarthest = 1e6;

/// Largest angle in a file of another program [rad]: about 159 turns. A double near 1e300 has no meaning as an angle.
inline constexpr double kMaxAngle = 1e3;

/// Largest elastic modulus of a material [Pa]. Diamond has 1.2e12.
inline constexpr double kMaxModulus = 1e15;

/// Largest number of triangles in the tessellation of a round shape. A soft body gets several tets for each: building
/// 8e5 tets takes 13 s and 700 MB.
inline constexpr double kMaxSoftTriangles = 2e5, kMaxRigidTriangles = 2e6;

/// Approximate memory per triangle of a skin while its pressure field is made [bytes]: 5.1 GB and 40 s were measured
/// for 2.1 million triangles. A mesh with more than kManySkinTriangles is opened without a pressure field until it has
/// taxels.
inline constexpr double kBytesPerSkinTriangle = 2400, kManySkinTriangles = 5e5;

/// Approximate memory per sample while samples are distributed and a sensor model is built [bytes]: 13.2 GB were
/// measured for 8.5 million samples, 1.08 GB for 0.68 million. The memory is announced before kManySamples or more are
/// made.
inline constexpr double kBytesPerSample = 1600, kManySamples = 5e5;

/// Throws Error if a simulation would take more than kMaxSteps steps, or a number of steps that is not finite.
/// `simulation` is the subject of the sentence: "the scenario".
inline void check_steps(double steps, const std::string& simulation) {
  if (steps <= kMaxSteps) return;
  throw Error(fmt::format("{} would take {:.3g} steps, at most {:.0e} are made: is the time step too small?",
                          simulation, steps, kMaxSteps));
}

/// Throws Error if the recording of `steps` steps would take more than kMaxRecordingBytes.
inline void check_recording_bytes(double steps, double bytes_per_step, const std::string& remedy) {
  const double bytes = steps * bytes_per_step;
  if (bytes <= static_cast<double>(kMaxRecordingBytes)) return;
  throw Error(fmt::format("the recording of {:.3g} steps would take {:.3g} GiB of memory, at most {} GiB are taken: {}",
                          steps, bytes / (1U << 30U), kMaxRecordingBytes >> 30U, remedy));
}

}  // namespace taxel
