// Limits of runs and recordings, tested on both sides of each limit.
#include "core/base/limits.h"

#include <gtest/gtest.h>

#include <limits>

#include "fixtures/complaint.h"

namespace taxel {
namespace {

TEST(Limits, AllowRunsOfAtMostAHundredMillionSteps) {
  EXPECT_NO_THROW(check_steps(1e8, "the run"));
  EXPECT_EQ(test::complaint_of([] { check_steps(1.001e8, "the run"); }),
            "the run would take 1e+08 steps, at most 1e+08 are made: is the time step too small?");
  EXPECT_THROW(check_steps(std::numeric_limits<double>::infinity(), "the run"), Error);
  EXPECT_THROW(check_steps(std::numeric_limits<double>::quiet_NaN(), "the run"), Error);
}

TEST(Limits, AllowRecordingsOfAtMostAGibibyte) {
  EXPECT_NO_THROW(check_recording_bytes(1 << 20, 1024, "rest"));
  EXPECT_EQ(test::complaint_of([] { check_recording_bytes((1 << 20) + 1, 1024, "rest"); }),
            "the recording of 1.05e+06 steps would take 1 GiB of memory, at most 1 GiB are taken: rest");
  EXPECT_EQ(test::complaint_of([] { check_recording_bytes(2e6, 4096, "rest"); }),
            "the recording of 2e+06 steps would take 7.63 GiB of memory, at most 1 GiB are taken: rest");
}

}  // namespace
}  // namespace taxel
