#include "core/base/os/memory.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace taxel::os {

void prefer_huge_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef __linux__
  ::madvise(memory, bytes, MADV_HUGEPAGE);  // no harm if it is refused
#endif
}

}  // namespace taxel::os
