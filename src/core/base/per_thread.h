// What each thread of a loop keeps for itself: made when a thread first asks for it, and used again in its next chunk.
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <memory>

namespace taxel {

/// In memory of the standard allocator: ThreadSanitizer does not see that oneTBB's own hands memory from one thread to
/// another only after the first gave it back.
template <class T>
using PerThread = tbb::enumerable_thread_specific<T, std::allocator<T>>;

}  // namespace taxel
