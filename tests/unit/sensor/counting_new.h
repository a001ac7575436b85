// How often this test program has allocated so far.
#pragma once

namespace taxel {
long allocation_count();
}  // namespace taxel
