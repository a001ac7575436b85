// A step packed into one piece of memory, bit for bit, for the history.
#pragma once

#include <cstddef>

#include "core/run/step.h"

namespace taxel {

/// Returns an upper bound of the packed size [bytes]. Packed are poses, readings and the arrays of the surfaces. Not
/// packed are the scene, the sensor models, and gradients that the sensor's own field has; nor hits and shear, which
/// unpack_step() computes again from the surfaces and motions, to the same bits.
[[nodiscard]] std::size_t largest_packed_size(const StepView& view);
/// Packs a step into largest_packed_size() bytes, and returns the number of bytes used. Only the calling thread may
/// read them (stream_copy.h).
std::size_t pack_step(const StepView& view, std::byte* to);
/// Reads a step that pack_step() has written. Needs scene and time of the packed step; step number, travel and
/// `finished` are not packed and stay unchanged.
void unpack_step(const std::byte* from, Step& step);

}  // namespace taxel
