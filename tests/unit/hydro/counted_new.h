#pragma once

namespace taxel {

/// How often operator new ran since the program began.
long allocation_count();

}  // namespace taxel
