// A step in one piece of memory: everything a viewer needs of it, bit for bit, with nothing to spare.
#pragma once

#include <cstddef>

#include "core/run/history/step_view.h"

namespace taxel {

/// Flat: poses, readings, the surfaces' arrays one after the other. Shared: the scene, the sensor models, and of
/// polygons in a tet of the sensor's own field the gradient, which is the tet's. Not kept: what rays hit, and the
/// shear, which follow from the surfaces and their motions when a step is unpacked, to the same bits.
[[nodiscard]] std::size_t largest_packed_size(const StepView& view);
/// Writes at most so many bytes, and returns how many. Only for the thread that writes them (stream_copy.h).
std::size_t pack_step(const StepView& view, std::byte* to);
/// Reads what pack_step() wrote. Needs scene and time of the packed step; step number, travel and `finished` are not
/// packed and stay unchanged.
void unpack_step(const std::byte* from, Step& step);

}  // namespace taxel
