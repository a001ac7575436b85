// Copies that leave the processor's caches to those who need them.
#pragma once

#include <cstddef>

namespace taxel {

/// memcpy for what is not read again soon: whole cache lines are written to memory without being read first, as few
/// stores to a line as the machine's instruction sets allow. For the same thread to read: no lock makes another one
/// wait for such writes, and a fence that does costs as much as the copy.
void stream_copy(std::byte* to, const void* from, std::size_t size);

}  // namespace taxel
