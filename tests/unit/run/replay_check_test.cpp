// The comparison of a run with the episode that it repeats, bit by bit.
#include "core/run/batch/data_set.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace taxel {
namespace {

/// Returns an episode of three rows with two readings.
Episode made_episode() {
  return {3,
          {{kTimestamp, 1, false, {0.1, 0.2, 0.3}},
           {kTravel, 1, false, {0, 0.001, 0.002}},
           {kTactile, 2, true, {0, 10, 20.1, 30, 1e-3, 1.0 / 3}}},
          {}};
}

/// Returns the rows of an episode as a run has them.
Trace trace_of(const Episode& episode, std::size_t rows) {
  Trace trace{{}, 7};
  for (std::size_t r = 0; r < rows; ++r)
    trace.rows.push_back({episode.columns[0].values[r],
                          episode.columns[1].values[r],
                          {episode.columns[2].values[2 * r], episode.columns[2].values[2 * r + 1]}});
  return trace;
}

Episode rounded_to_float32(Episode episode) {
  for (EpisodeColumn& column : episode.columns)
    for (double& value : column.values) value = static_cast<double>(static_cast<float>(value));
  return episode;
}

ReplayCheck check_of(const Trace& trace, const Episode& episode, int bits) {
  ReplayCheck check;
  compare_with_episode(trace, episode, bits, check);
  return check;
}

TEST(ReplayCheck, FindsNoDifferenceInEqualRows) {
  const Episode episode = made_episode();
  const ReplayCheck check = check_of(trace_of(episode, 3), episode, 64);
  EXPECT_EQ(check.rows, 3U);
  EXPECT_EQ(check.different_rows, 0U);
  EXPECT_EQ(check.largest, 0);
  EXPECT_EQ(check.problem, "");
}

TEST(ReplayCheck, FindsADifferenceInTheLastBit) {
  const Episode episode = made_episode();
  Trace trace = trace_of(episode, 3);
  double& reading = trace.rows[1].readings[0];
  reading = std::nextafter(reading, 100);
  const ReplayCheck check = check_of(trace, episode, 64);
  EXPECT_EQ(check.different_rows, 1U);
  EXPECT_EQ(check.largest, reading - 20.1);
  EXPECT_EQ(check.largest_taxel, 0U);
  EXPECT_EQ(check.largest_time, 0.2);
  EXPECT_FALSE(check.has_other_times);
}

TEST(ReplayCheck, FindsAZeroOfAnotherSignAndAnotherTravel) {
  const Episode episode = made_episode();
  Trace trace = trace_of(episode, 3);
  trace.rows[0].readings[0] = -0.0;
  EXPECT_EQ(check_of(trace, episode, 64).different_rows, 1U) << "other bits";
  trace.rows[2].travel = 0.003;
  const ReplayCheck check = check_of(trace, episode, 64);
  EXPECT_EQ(check.different_rows, 2U);
  EXPECT_TRUE(check.has_other_times);
}

TEST(ReplayCheck, RoundsTheRunToTheBitsOfTheDataSet) {
  const Episode exact = made_episode(), rounded = rounded_to_float32(exact);
  EXPECT_EQ(check_of(trace_of(exact, 3), rounded, 32).different_rows, 0U);
  EXPECT_EQ(check_of(trace_of(exact, 3), rounded, 64).different_rows, 3U);
  Trace trace = trace_of(exact, 3);
  trace.rows[2].readings[1] += 1e-6;  // more than a bit of float32
  EXPECT_EQ(check_of(trace, rounded, 32).different_rows, 1U);
}

TEST(ReplayCheck, ContinuesWithNewRowsAndBeginsAgainIfRowsAreRemoved) {
  const Episode episode = made_episode();
  Trace trace = trace_of(episode, 2);
  trace.rows[0].readings[1] = 11;
  ReplayCheck check = check_of(trace, episode, 64);
  const ReplayCheck before = check;
  trace.rows.push_back(trace_of(episode, 3).rows[2]);
  compare_with_episode(trace, episode, 64, check);
  EXPECT_EQ(check.rows, 3U);
  EXPECT_EQ(check.different_rows, before.different_rows);
  Trace again = trace_of(episode, 1);
  again.edition = trace.edition + 1;
  compare_with_episode(again, episode, 64, check);
  EXPECT_EQ(check.rows, 1U);
  EXPECT_EQ(check.different_rows, 0U);
  EXPECT_EQ(check.largest, 0);
}

TEST(ReplayCheck, ForgetsTheVerdictOfAnEarlierRunOfTheSameLength) {
  const Episode episode = made_episode();
  Trace trace = trace_of(episode, 3);
  trace.rows[1].readings[0] += 1;
  ReplayCheck check = check_of(trace, episode, 64);
  ASSERT_EQ(check.different_rows, 1U);
  Trace again = trace_of(episode, 3);
  again.edition = trace.edition + 1;
  compare_with_episode(again, episode, 64, check);
  EXPECT_EQ(check.rows, 3U);
  EXPECT_EQ(check.different_rows, 0U);
  EXPECT_EQ(check.largest, 0);
}

TEST(ReplayCheck, CountsRowsAfterTheEndOfTheEpisode) {
  const Episode episode = made_episode();
  Trace trace = trace_of(episode, 3);
  trace.rows.push_back({0.4, 0.003, {1, 2}});
  EXPECT_EQ(check_of(trace, episode, 64).different_rows, 1U);
}

TEST(ReplayCheck, NamesAnotherNumberOfTaxels) {
  const Episode episode = made_episode();
  Trace trace = trace_of(episode, 3);
  trace.rows[0].readings.push_back(1);
  EXPECT_EQ(check_of(trace, episode, 64).problem, "the run has 3 readings and the episode has 2");
  EXPECT_FALSE(check_of(trace_of(episode, 3), {3, {}, {}}, 64).problem.empty());
}

}  // namespace
}  // namespace taxel
