// The pool of job threads and its slots: order, limits, superseded jobs, destruction, failures.
#include "app/studio/host/jobs/job_executor.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>

#include "app/studio/host/jobs/newest_wins.h"

namespace taxel::studio {
namespace {

using namespace std::chrono_literals;

/// A gate at which tasks wait until the test opens it.
class Gate {
 public:
  void open() {
    {
      const std::lock_guard lock(mutex_);
      is_open_ = true;
    }
    opened_.notify_all();
  }
  void pass() {
    std::unique_lock lock(mutex_);
    opened_.wait(lock, [this] { return is_open_; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable opened_;
  bool is_open_ = false;
};

/// Waits until `done` returns true, at most ten seconds.
template <class Done>
bool becomes_true(const Done& done) {
  const auto end = std::chrono::steady_clock::now() + 10s;
  while (!done() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(1ms);
  return done();
}

/// Counts running tasks and records the largest number.
class Counter {
 public:
  void enter() {
    const int now = ++running_;
    int peak = peak_;
    while (now > peak && !peak_.compare_exchange_weak(peak, now)) {
    }
  }
  void leave() { --running_; }
  [[nodiscard]] int running() const { return running_; }
  [[nodiscard]] int peak() const { return peak_; }

 private:
  std::atomic<int> running_ = 0, peak_ = 0;
};

struct Text {
  std::string text;
  std::string problem;
};
using Slot = NewestWins<int, Text>;

/// A pool with one slot whose work the test defines.
class NewestWinsTest : public testing::Test {
 protected:
  NewestWinsTest() {
    pool.set_wake([this] { ++woken; });
  }
  std::unique_ptr<Slot> make_slot(Slot::Work work, Priority priority = Priority::normal) {
    return std::make_unique<Slot>(pool, priority, std::move(work));
  }
  /// Returns a slot that writes the job's number. Job 1 waits until the gate is open.
  std::unique_ptr<Slot> make_gated_slot() {
    return make_slot([this](int job, Text& out, Progress&) {
      ++begun;
      if (job == 1) gate.pass();
      out.text = std::to_string(job);
    });
  }
  [[nodiscard]] bool has_begun(int count) {
    return becomes_true([&] { return begun == count; });
  }

  Gate gate;
  std::atomic<int> begun = 0, woken = 0;
  JobPool pool;
};

TEST(JobPool, RunsTasksOfAtMostFourSlotsAtOnce) {
  Gate gate;
  Counter counter;
  JobPool pool;
  int slots[6] = {};
  for (int& slot : slots)
    pool.post(&slot, Priority::normal, [&] {
      counter.enter();
      gate.pass();
      counter.leave();
    });
  EXPECT_TRUE(becomes_true([&] { return counter.running() == JobPool::kThreads; }));
  gate.open();
  for (int& slot : slots) pool.remove(&slot);
  EXPECT_EQ(counter.peak(), JobPool::kThreads);
}

TEST(JobPool, RunsAtMostTwoBackgroundTasksAtOnce) {
  Gate gate;
  Counter background;
  std::atomic<int> normal = 0, done = 0;
  JobPool pool;
  int slots[10] = {};
  for (int i = 0; i < 5; ++i)
    pool.post(&slots[i], Priority::background, [&] {
      background.enter();
      gate.pass();
      background.leave();
      ++done;
    });
  EXPECT_TRUE(becomes_true([&] { return background.running() == JobPool::kMaxBackground; }));
  for (int i = 5; i < 10; ++i) pool.post(&slots[i], Priority::normal, [&] { ++normal; });
  EXPECT_TRUE(becomes_true([&] { return normal == 5; })) << "normal tasks do not wait for background tasks";
  EXPECT_EQ(background.running(), JobPool::kMaxBackground);
  gate.open();
  EXPECT_TRUE(becomes_true([&] { return done == 5; }));
  EXPECT_EQ(background.peak(), JobPool::kMaxBackground);
}

TEST(JobPool, RunsNormalTasksFirstAndOtherwiseInOrder) {
  Gate gate;
  std::mutex mutex;
  std::string order;
  std::atomic<int> waiting = 0, done = 0;
  JobPool pool;
  int blockers[JobPool::kThreads] = {}, slots[4] = {};
  const auto append = [&](char letter) {
    return [&, letter] {
      const std::lock_guard lock(mutex);
      order += letter;
      ++done;
    };
  };
  // One blocker waits longer than the others, so that a single thread runs the remaining tasks in order.
  Gate last;
  for (int i = 0; i < JobPool::kThreads; ++i)
    pool.post(&blockers[i], Priority::normal, [&, i] {
      ++waiting;
      i == 0 ? gate.pass() : last.pass();
    });
  EXPECT_TRUE(becomes_true([&] { return waiting == JobPool::kThreads; }));
  pool.post(&slots[0], Priority::background, append('c'));
  pool.post(&slots[1], Priority::normal, append('a'));
  pool.post(&slots[2], Priority::background, append('d'));
  pool.post(&slots[3], Priority::normal, append('b'));
  gate.open();
  EXPECT_TRUE(becomes_true([&] { return done == 4; }));
  last.open();
  EXPECT_EQ(order, "abcd");
}

TEST(JobPool, NeverRunsTwoTasksOfOneSlotAtOnce) {
  constexpr int kSlots = 12, kPosts = 50;
  Counter counters[kSlots];
  std::atomic<int> runs = 0;
  JobPool pool;
  for (int k = 0; k < kPosts; ++k) {
    for (Counter& counter : counters)
      pool.post(&counter, k % 2 == 0 ? Priority::normal : Priority::background, [&] {
        counter.enter();
        std::this_thread::sleep_for(100us);
        counter.leave();
        ++runs;
      });
    std::this_thread::sleep_for(100us);
  }
  EXPECT_TRUE(becomes_true([&] { return runs >= kSlots; }));
  for (Counter& counter : counters) pool.remove(&counter);
  for (const Counter& counter : counters) EXPECT_EQ(counter.peak(), 1);
}

TEST(JobPool, DropsTheTaskOfARemovedSlotAndWaitsForARunningOne) {
  Gate gate;
  std::atomic<int> begun = 0, done = 0;
  JobPool pool;
  int slot = 0;
  const auto task = [&] {
    ++begun;
    gate.pass();
    ++done;
  };
  pool.post(&slot, Priority::normal, task);
  EXPECT_TRUE(becomes_true([&] { return begun == 1; }));
  pool.post(&slot, Priority::normal, task);
  std::thread opener([&] {
    std::this_thread::sleep_for(20ms);
    gate.open();
  });
  pool.remove(&slot);
  EXPECT_EQ(done, 1);
  opener.join();
  std::this_thread::sleep_for(10ms);
  EXPECT_EQ(begun, 1) << "the queued task was dropped";
}

TEST(JobPool, DropsQueuedTasksWhenItIsDestroyed) {
  Gate gate;
  std::atomic<int> begun = 0;
  int slots[9] = {};
  std::thread opener;
  {
    JobPool pool;
    for (int& slot : slots)
      pool.post(&slot, Priority::normal, [&] {
        ++begun;
        gate.pass();
      });
    EXPECT_TRUE(becomes_true([&] { return begun == JobPool::kThreads; }));
    opener = std::thread([&] {
      std::this_thread::sleep_for(20ms);
      gate.open();
    });
  }
  opener.join();
  EXPECT_EQ(begun, JobPool::kThreads);
}

TEST_F(NewestWinsTest, RunsTheNewestOfManyJobsAndDropsTheOthers) {
  const auto slot = make_gated_slot();
  slot->post(1);
  ASSERT_TRUE(has_begun(1));
  for (int job = 2; job <= 50; ++job) slot->post(job);
  EXPECT_EQ(slot->posted(), 50);
  EXPECT_TRUE(slot->busy());
  gate.open();
  slot->wait();
  EXPECT_FALSE(slot->busy());
  EXPECT_EQ(slot->newest()->text, "50");
  EXPECT_EQ(begun, 2);
  EXPECT_EQ(woken, 2) << "when wait() returns";
}

TEST_F(NewestWinsTest, WakesTheWindowAtTheEndOfEveryJob) {
  const auto slot = make_slot([&](int job, Text& out, Progress& progress) {
    ++begun;
    if (job == 1) gate.pass();
    progress.stop_if_cancelled();
    if (job == 2) throw std::runtime_error("no");
    out.text = std::to_string(job);
  });
  slot->post(1);
  ASSERT_TRUE(has_begun(1));
  EXPECT_TRUE(pool.busy());
  EXPECT_EQ(pool.ended(), 0U);
  slot->post(std::nullopt, Superseded::cancel);
  gate.open();
  slot->wait();
  EXPECT_EQ(woken, 1) << "a cancelled one";
  slot->post(2);
  slot->wait();
  EXPECT_EQ(woken, 2) << "one that fails";
  slot->post(3);
  slot->wait();
  EXPECT_EQ(woken, 3) << "one with a result";
  EXPECT_EQ(pool.ended(), 3U);
  EXPECT_TRUE(becomes_true([&] { return !pool.busy(); }));
}

TEST_F(NewestWinsTest, UsesTheResultOfASupersededJobMeanwhile) {
  Gate second;
  const auto slot = make_slot([&](int job, Text& out, Progress&) {
    ++begun;
    job == 1 ? gate.pass() : second.pass();
    out.text = std::to_string(job);
  });
  slot->post(1);
  ASSERT_TRUE(has_begun(1));
  slot->post(2);
  gate.open();
  ASSERT_TRUE(has_begun(2));
  ASSERT_NE(slot->newest(), nullptr);
  EXPECT_EQ(slot->newest()->text, "1");
  second.open();
  slot->wait();
  EXPECT_EQ(slot->newest()->text, "2");
}

TEST_F(NewestWinsTest, RunsAnEqualJobOnce) {
  const auto slot = make_gated_slot();
  gate.open();
  slot->post(1);
  slot->wait();
  slot->post(1);
  EXPECT_FALSE(slot->busy());
  slot->post(std::nullopt);
  EXPECT_EQ(slot->newest(), nullptr);
  slot->post(1);
  slot->wait();
  EXPECT_EQ(slot->newest()->text, "1");
  EXPECT_EQ(begun, 2) << "once more after it was forgotten";
}

TEST_F(NewestWinsTest, DoesNotRepeatAJobThatIsPostedAgainWhileItRuns) {
  const auto slot = make_gated_slot();
  slot->post(1);
  ASSERT_TRUE(has_begun(1));
  slot->post(2);
  slot->post(1);
  gate.open();
  slot->wait();
  EXPECT_EQ(slot->newest()->text, "1");
  EXPECT_EQ(begun, 1);
}

TEST_F(NewestWinsTest, CancelsARunningJobAndDropsItsResult) {
  const auto slot = make_slot([&](int job, Text& out, Progress& progress) {
    ++begun;
    out.text = std::to_string(job);
    while (job == 1) {
      progress.check(0.5);
      std::this_thread::sleep_for(1ms);
    }
  });
  slot->post(1);
  ASSERT_TRUE(has_begun(1));
  EXPECT_TRUE(becomes_true([&] { return slot->fraction() == 0.5; }));
  slot->post(2, Superseded::cancel);
  slot->wait();
  EXPECT_EQ(slot->newest()->text, "2");
  EXPECT_EQ(slot->fraction(), 0);
}

TEST_F(NewestWinsTest, DoesNotCancelAJobThatIsPostedAgain) {
  const auto slot = make_gated_slot();
  slot->post(1);
  ASSERT_TRUE(has_begun(1));
  slot->post(1, Superseded::cancel);
  gate.open();
  slot->wait();
  EXPECT_EQ(slot->newest()->text, "1");
  EXPECT_EQ(begun, 1);
}

TEST_F(NewestWinsTest, DropsTheResultOfACancelledJobThatEndsNormally) {
  const auto slot = make_gated_slot();
  slot->post(1);
  ASSERT_TRUE(has_begun(1));
  slot->post(std::nullopt, Superseded::cancel);
  slot->post(1);  // requested again, so the job must run again
  gate.open();
  slot->wait();
  EXPECT_EQ(slot->newest()->text, "1");
  EXPECT_EQ(begun, 2);
}

TEST_F(NewestWinsTest, ReturnsNoResultIfNoJobIsRequested) {
  const auto slot = make_gated_slot();
  slot->post(1);
  ASSERT_TRUE(has_begun(1));
  slot->post(std::nullopt);
  gate.open();
  slot->wait();
  EXPECT_EQ(slot->newest(), nullptr);
  EXPECT_FALSE(slot->posted());
}

TEST_F(NewestWinsTest, NeedsNoJobIfItsResultIsPublished) {
  const auto slot = make_gated_slot();
  auto found = std::make_shared<Text>();
  slot->publish(5, found);
  EXPECT_EQ(slot->newest(), nullptr) << "nothing is requested";
  slot->post(1);
  ASSERT_TRUE(has_begun(1));
  slot->post(2);
  slot->publish(2, found);
  gate.open();
  slot->wait();
  EXPECT_EQ(slot->newest(), found) << "which the older job does not replace";
  slot->publish(5, found);
  slot->post(5);
  EXPECT_FALSE(slot->busy());
  EXPECT_EQ(begun, 1);
}

TEST_F(NewestWinsTest, RunsAJobOnTheCallingThread) {
  std::thread::id ran_on;
  const auto slot = make_slot([&](int job, Text& out, Progress&) {
    ran_on = std::this_thread::get_id();
    out.text = std::to_string(job);
  });
  slot->post(1);
  slot->wait();
  EXPECT_NE(ran_on, std::this_thread::get_id());
  slot->run_here(2);
  EXPECT_EQ(ran_on, std::this_thread::get_id());
  EXPECT_EQ(slot->newest()->text, "2");
  EXPECT_EQ(woken, 1) << "the caller knows";
}

TEST_F(NewestWinsTest, NeverRunsItsWorkTwiceAtOnce) {
  Counter counter;
  const auto slot = make_slot([&](int, Text&, Progress&) {
    counter.enter();
    std::this_thread::sleep_for(1ms);
    counter.leave();
  });
  for (int job = 0; job < 30; ++job) {
    slot->post(job);
    slot->run_here(100 + job);
  }
  slot->wait();
  EXPECT_EQ(counter.peak(), 1);
}

TEST_F(NewestWinsTest, ReturnsEachResultOnce) {
  const auto slot = make_gated_slot();
  EXPECT_EQ(slot->take(), nullptr);
  gate.open();
  slot->post(1);
  slot->wait();
  EXPECT_EQ(slot->posted(), 1);
  EXPECT_EQ(slot->take()->text, "1");
  EXPECT_EQ(slot->take(), nullptr);
  EXPECT_FALSE(slot->posted()) << "it is done";
  slot->post(1);
  slot->wait();
  EXPECT_EQ(slot->take()->text, "1") << "as it was requested again";
}

TEST_F(NewestWinsTest, KeepsTheNewestJobIfASupersededResultIsRead) {
  Gate second;
  const auto slot = make_slot([&](int job, Text& out, Progress&) {
    ++begun;
    job == 1 ? gate.pass() : second.pass();
    out.text = std::to_string(job);
  });
  slot->post(1);
  ASSERT_TRUE(has_begun(1));
  slot->post(2);
  gate.open();
  ASSERT_TRUE(has_begun(2));
  EXPECT_EQ(slot->take()->text, "1");
  EXPECT_EQ(slot->posted(), 2);
  second.open();
  slot->wait();
  EXPECT_EQ(slot->take()->text, "2");
}

TEST_F(NewestWinsTest, StoresAnExceptionAsTheProblemOfTheResult) {
  const auto slot = make_slot([](int job, Text& out, Progress&) {
    out.text = std::to_string(job);
    if (job == 1) throw std::runtime_error("no memory");
  });
  slot->post(1);
  slot->wait();
  EXPECT_EQ(slot->newest()->problem, "no memory");
  EXPECT_EQ(slot->newest()->text, "1") << "the result that was filled before";
  slot->post(2);
  slot->wait();
  EXPECT_EQ(slot->newest()->problem, "");
}

TEST_F(NewestWinsTest, CancelsTheRunningJobAndDropsThePendingOneAtItsEnd) {
  auto slot = make_slot([&](int, Text&, Progress& progress) {
    ++begun;
    while (true) {
      progress.stop_if_cancelled();
      std::this_thread::sleep_for(1ms);
    }
  });
  slot->post(1);
  ASSERT_TRUE(has_begun(1));
  slot->post(2);
  slot.reset();
  EXPECT_EQ(begun, 1);
  std::this_thread::sleep_for(10ms);
  EXPECT_EQ(begun, 1);
}

TEST_F(NewestWinsTest, WaitsForTheRunningJobAtItsEnd) {
  std::atomic<int> ended = 0;
  auto slot = make_slot([&](int, Text&, Progress&) {
    ++begun;
    std::this_thread::sleep_for(30ms);
    ++ended;
  });
  slot->post(1);
  ASSERT_TRUE(has_begun(1));
  slot.reset();
  EXPECT_EQ(ended, 1);
}

TEST_F(NewestWinsTest, DoesNotWaitForOtherSlotsAtItsEnd) {
  const auto work = [&](int, Text&, Progress&) {
    ++begun;
    gate.pass();
  };
  const auto first = make_slot(work, Priority::background), second = make_slot(work, Priority::background);
  auto third = make_slot(work, Priority::background);
  first->post(1);
  second->post(1);
  ASSERT_TRUE(has_begun(2));
  third->post(1);
  third.reset();  // would wait forever if it waited for its turn
  gate.open();
  first->wait();
  second->wait();
  EXPECT_EQ(begun, 2);
}

TEST_F(NewestWinsTest, GivesEachOfManySlotsItsNewestResultUnderLoad) {
  constexpr int kSlots = 20, kJobs = 300;
  std::vector<std::unique_ptr<Slot>> slots;
  for (int i = 0; i < kSlots; ++i)
    slots.push_back(make_slot([](int job, Text& out, Progress&) { out.text = std::to_string(job); },
                              i % 3 == 0 ? Priority::background : Priority::normal));
  std::vector<std::thread> callers;
  for (int t = 0; t < 2; ++t)
    callers.emplace_back([&, t] {
      for (int job = 1; job <= kJobs; ++job)
        for (int i = t; i < kSlots; i += 2) {
          const auto running = job % 5 == 0 ? Superseded::cancel : Superseded::finish;
          if (job % 7 == 0) slots[static_cast<std::size_t>(i)]->post(std::nullopt, running);
          slots[static_cast<std::size_t>(i)]->post(job, running);
          if (job % 11 == 0) slots[static_cast<std::size_t>(i)]->take();
        }
    });
  for (std::thread& caller : callers) caller.join();
  for (const auto& slot : slots) {
    slot->wait();
    ASSERT_NE(slot->newest(), nullptr);
    EXPECT_EQ(slot->newest()->text, std::to_string(kJobs));
  }
}

TEST_F(NewestWinsTest, AddsAndRemovesSlotsUnderLoad) {
  std::vector<std::thread> callers;
  for (int t = 0; t < 3; ++t)
    callers.emplace_back([&] {
      for (int k = 0; k < 100; ++k) {
        auto alive = std::make_unique<std::atomic<bool>>(true);
        auto slot = make_slot([is_alive = alive.get()](int, Text&, Progress&) { EXPECT_TRUE(is_alive->load()); },
                              k % 2 == 0 ? Priority::background : Priority::normal);
        for (int job = 0; job < 5; ++job) slot->post(job);
        slot.reset();
        *alive = false;
      }
    });
  for (std::thread& caller : callers) caller.join();
}

}  // namespace
}  // namespace taxel::studio
