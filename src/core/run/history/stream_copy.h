// Copies that do not evict the processor's caches.
#pragma once

#include <cstddef>

namespace taxel {

/// Copies as memcpy does, for data that is not read again soon: whole cache lines are written to memory without being
/// read first, with the widest stores of the processor. Only the calling thread may read the copy: a lock does not make
/// other threads wait for such stores, and a fence that does costs as much as the copy.
void stream_copy(std::byte* to, const void* from, std::size_t size);

}  // namespace taxel
