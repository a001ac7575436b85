// Loops over the sensors and bodies of one simulation whose passes are independent.
#pragma once

#include <atomic>
#include <cstddef>

#include "core/base/parallel.h"

namespace taxel {

/// Contact polygons that take about 100 us, which is longer than to wake threads.
inline constexpr std::size_t kManyPolygons = 400;

/// Number of simulations of this process that are in a loop of side_by_side() now.
inline std::atomic<int>& computing_simulations() {
  static std::atomic<int> count = 0;
  return count;
}

/// Calls body(i) for i in [0, count). The calls are made side by side if that gains more than it costs: if they work on
/// many polygons, and if no other simulation of this process computes at this moment, because programs that step many
/// simulations keep all cores busy with them. Throws the first exception of a call.
template <class Body>
void side_by_side(std::size_t count, std::size_t polygons, const Body& body) {
  struct Counted {
    bool is_alone = computing_simulations()++ == 0;
    Counted() = default;
    Counted(const Counted&) = delete;
    Counted& operator=(const Counted&) = delete;
    ~Counted() { --computing_simulations(); }
  } const counted;
  if (counted.is_alone && polygons > kManyPolygons && count > 1) {
    parallel_chunks(static_cast<int>(count), 1, [&](int i, int) { body(static_cast<std::size_t>(i)); });
  } else {
    for (std::size_t i = 0; i < count; ++i) body(i);
  }
}

}  // namespace taxel
