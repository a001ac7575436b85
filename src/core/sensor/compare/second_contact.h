// The choice of the contact that a second layout reads.
#pragma once

namespace taxel {

/// The contact that a second layout reads.
enum class SecondContact {
  recorded,  ///< surfaces of the first layout, as they were recorded
  own        ///< surfaces of the second layout's own body, in the recorded poses
};

}  // namespace taxel
