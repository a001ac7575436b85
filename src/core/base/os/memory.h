// Advice to the operating system about memory.
#pragma once

#include <cstddef>

namespace taxel::os {

/// Asks for pages of 2 MiB, which need one page fault instead of 512. Does nothing on systems without them.
void prefer_huge_pages(void* memory, std::size_t bytes);

}  // namespace taxel::os
