#include "core/run/data_set/replay_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace taxel {
namespace {

const EpisodeColumn* column_of(const Episode& episode, const char* name) {
  const auto found = std::ranges::find(episode.columns, name, &EpisodeColumn::name);
  return found != episode.columns.end() ? &*found : nullptr;
}

/// The columns of an episode that a trace has as well.
struct ComparedColumns {
  const EpisodeColumn *time, *travel, *tactile;
};

bool has_same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

double rounded(double value, int bits) {
  constexpr int kFloat32 = 32;
  return bits == kFloat32 ? static_cast<double>(static_cast<float>(value)) : value;
}

void compare_row(const TraceRow& row, const ComparedColumns& columns, std::size_t r, int bits, ReplayCheck& check) {
  const double time = columns.time->values[r];
  const bool has_same_times = has_same_bits(rounded(row.time, bits), time) &&
                              has_same_bits(rounded(row.travel, bits), columns.travel->values[r]);
  bool is_equal = has_same_times;
  const std::size_t width = columns.tactile->width;
  for (std::size_t k = 0; k < width; ++k) {
    const double live = rounded(row.readings[k], bits), recorded = columns.tactile->values[r * width + k];
    if (has_same_bits(live, recorded)) continue;
    is_equal = false;
    const double difference = std::abs(live - recorded);
    if (difference <= check.largest) continue;
    check.largest = difference;
    check.largest_taxel = k;
    check.largest_time = time;
  }
  check.has_other_times = check.has_other_times || !has_same_times;
  if (!is_equal) ++check.different_rows;
}

}  // namespace

void compare_with_episode(const Trace& trace, const Episode& episode, int bits, ReplayCheck& check) {
  if (check.edition != trace.edition || trace.rows.size() < check.rows) check = {};
  check.edition = trace.edition;
  const ComparedColumns columns{column_of(episode, kTimestamp), column_of(episode, kTravel),
                                column_of(episode, kTactile)};
  const auto has_rows = [&](const EpisodeColumn* column) {
    return column != nullptr && column->values.size() == static_cast<std::size_t>(episode.rows) * column->width;
  };
  if (!has_rows(columns.time) || !has_rows(columns.travel) || !has_rows(columns.tactile) || columns.time->width != 1 ||
      columns.travel->width != 1) {
    check.problem = "the episode has no times, travels or readings";
    return;
  }
  const auto rows = static_cast<std::size_t>(episode.rows);
  for (; check.rows < trace.rows.size() && check.problem.empty(); ++check.rows) {
    const TraceRow& row = trace.rows[check.rows];
    check.has_preview = check.has_preview || row.quality == SampleQuality::preview;
    if (row.readings.size() != columns.tactile->width)
      check.problem =
          fmt::format("the run has {} readings and the episode has {}", row.readings.size(), columns.tactile->width);
    else if (check.rows < rows)
      compare_row(row, columns, check.rows, bits, check);
    else
      ++check.different_rows;
  }
}

}  // namespace taxel
