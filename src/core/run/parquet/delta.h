// The encoding DELTA_BINARY_PACKED of whole numbers: the differences of successive numbers, in blocks. The indices of
// rows, which count up, take hardly any bytes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace taxel {

/// Returns the bytes of numbers. Differences wrap around at 64 bits.
std::string delta_bytes(std::span<const std::int64_t> numbers);

/// Reads `count` numbers of delta_bytes(). Throws Error if the bytes are damaged or have another count.
std::vector<std::int64_t> from_delta(std::string_view bytes, std::size_t count);

}  // namespace taxel
