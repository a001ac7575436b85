// Parallel loops: every index once, exceptions, progress and cancellation.
#include "core/base/parallel.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/base/progress.h"

namespace taxel {
namespace {

TEST(ParallelChunks, CoverEveryIndexOnceInFixedChunks) {
  for (const int count : {0, 1, 9, 10, 11, 1003}) {
    std::vector<std::atomic<int>> seen(static_cast<std::size_t>(count));
    parallel_chunks(count, 10, [&](int begin, int end) {
      EXPECT_EQ(begin % 10, 0);
      EXPECT_TRUE(end == begin + 10 || end == count);
      for (int i = begin; i < end; ++i) ++seen[static_cast<std::size_t>(i)];
    });
    for (const auto& n : seen) EXPECT_EQ(n.load(), 1);
  }
}

TEST(ParallelChunks, GiveSumsThatDoNotDependOnTheNumberOfThreads) {
  const auto sum = [] {
    std::vector<double> partial(100);
    parallel_chunks(10000, 100, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) partial[static_cast<std::size_t>(begin / 100)] += std::sin(i) * 1e-3;
    });
    double total = 0;
    for (const double p : partial) total += p;
    return total;
  };
  const double free = sum();
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(sum(), free);
}

TEST(ParallelChunks, RethrowExceptions) {
  EXPECT_THROW(parallel_chunks(100, 1,
                               [](int begin, int) {
                                 if (begin == 57) throw std::runtime_error("57");
                               }),
               std::runtime_error);
}

TEST(Progress, JoinsPartsToOneBar) {
  Progress progress;
  EXPECT_STREQ(progress.step(), "");
  {
    const ProgressPart half(&progress, 0.25, 0.75);
    progress.set(0.0);
    EXPECT_EQ(progress.fraction(), 0.25);
    progress.check(0.5);
    EXPECT_EQ(progress.fraction(), 0.5);
    EXPECT_EQ(progress.reached(), 0.5);
    {
      const ProgressPart last(&progress, 0.5, 1);
      EXPECT_EQ(progress.reached(), 0);
      progress.set(0.5);
      EXPECT_EQ(progress.fraction(), 0.625);
    }
    EXPECT_EQ(progress.reached(), 0.75) << "of the outer part";
    progress.set(1.0);
    EXPECT_EQ(progress.fraction(), 0.75);
  }
  progress.set(1.0);
  EXPECT_EQ(progress.fraction(), 1);
  const ProgressPart none(nullptr, 0, 0.5);
}

TEST(Progress, StopsAtTheNextCheckAfterCancel) {
  Progress progress;
  progress.check(0.25);
  EXPECT_EQ(progress.fraction(), 0.25);
  progress.cancel();
  EXPECT_THROW(progress.check(0.5), Cancelled);
}

TEST(ParallelAll, CompletesTheOtherTasksIfOneFails) {
  for (int round = 0; round < 20; ++round) {
    std::atomic<int> chunks = 0;
    std::atomic<bool> begun = false, failed = false;
    const auto fails = [&] {
      while (!begun) std::this_thread::yield();
      failed = true;
      throw std::runtime_error("first");
    };
    const auto loops = [&] {
      parallel_chunks(200, 1, [&](int, int) {
        begun = true;
        if (chunks++ < 2) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      });
    };
    const auto fails_too = [] { throw std::logic_error("second"); };
    EXPECT_THROW(parallel_all(fails, loops, fails_too), std::runtime_error) << "the first in order";
    EXPECT_TRUE(failed);
    EXPECT_EQ(chunks, 200);
  }
}

}  // namespace
}  // namespace taxel
