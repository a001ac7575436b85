// Compares a run with the episode of a data set that it repeats, row by row.
#pragma once

#include <cstdint>
#include <string>

#include "core/run/batch/episode.h"
#include "core/run/trace.h"

namespace taxel {

/// Result of comparing the first rows of a run with an episode.
struct ReplayCheck {
  std::uint64_t edition = 0;       ///< edition of the trace that was compared
  std::size_t rows = 0;            ///< number of compared rows
  std::size_t different_rows = 0;  ///< rows in which a reading, the time or the travel has other bits
  double largest = 0;              ///< largest difference of a reading [unit of the readings]
  std::size_t largest_taxel = 0;   ///< index of the taxel with the largest difference
  double largest_time = 0;         ///< time of the episode's row with the largest difference [s]
  bool has_other_times = false;    ///< a time or a travel differs
  bool has_preview = false;        ///< a row was read with preview samples
  std::string problem;             ///< reason why the rows cannot be compared, or empty
  bool operator==(const ReplayCheck&) const = default;
};

/// Continues a comparison with the rows that a run has got since. Begins again if rows were removed. Readings, time and
/// travel are compared by their bits, with `bits` = 32 after rounding to 32 bits. Rows behind the end of the episode
/// count as different.
void compare_with_episode(const Trace& trace, const Episode& episode, int bits, ReplayCheck& check);

}  // namespace taxel
