// The executor of scripts runs jobs on the calling thread, in order, after as many frames as the script sees.
#include "app/studio/host/jobs/job_executor.h"

#include <gtest/gtest.h>

#include <string>

#include "app/studio/host/jobs/newest_wins.h"

namespace taxel::studio {
namespace {

struct Executed {
  InlineExecutor executor;
  int slots[3] = {};
  std::string order;

  void post(int slot, char name, int frames = 0) {
    executor.post(
        &slots[slot], Priority::normal, [this, name] { order += name; }, frames);
  }
  void next_frame(bool without_delay = false) {
    executor.begin_frame(without_delay);
    executor.run_posted();
    order += '|';
  }
};

TEST(InlineExecutorTest, RunsTasksInOrderWhenItIsAsked) {
  Executed e;
  e.post(1, 'a');
  e.post(0, 'b');
  EXPECT_EQ(e.order, "");
  e.executor.run_posted();
  e.executor.run_posted();
  EXPECT_EQ(e.order, "ab");
}

TEST(InlineExecutorTest, ReplacesTheQueuedTaskOfASlot) {
  Executed e;
  e.post(0, 'a', 2);
  e.post(1, 'b');
  e.post(0, 'c');
  e.executor.run_posted();
  EXPECT_EQ(e.order, "bc");
}

TEST(InlineExecutorTest, WaitsForFurtherFrames) {
  Executed e;
  e.post(0, 'a', 2);
  e.executor.run_posted();
  for (int i = 0; i < 4; ++i) e.next_frame();
  EXPECT_EQ(e.order, "||a||") << "two frames begin before it runs";
  e.order.clear();
  e.post(0, 'b', 8);
  e.next_frame(true);
  EXPECT_EQ(e.order, "b|") << "without delay";
}

TEST(InlineExecutorTest, RunsTasksThatATaskPosts) {
  Executed e;
  e.executor.post(&e.slots[0], Priority::normal, [&] {
    e.order += 'a';
    e.post(1, 'b');
  });
  e.executor.run_posted();
  EXPECT_EQ(e.order, "ab");
}

TEST(InlineExecutorTest, DropsTheTaskOfARemovedSlot) {
  Executed e;
  e.post(0, 'a');
  e.post(1, 'b');
  e.executor.remove(&e.slots[0]);
  e.executor.run_posted();
  EXPECT_EQ(e.order, "b");
}

struct Squared {
  int number = 0;
};

TEST(InlineExecutorTest, GivesASlotTheResultOfItsNewestJob) {
  InlineExecutor executor;
  int begun = 0;
  NewestWins<int, Squared> slot(executor, Priority::background, [&](int job, Squared& out, Progress&) {
    ++begun;
    out.number = job * job;
  });
  slot.post(2);
  slot.post(3);
  EXPECT_TRUE(slot.busy());
  EXPECT_TRUE(executor.busy());
  executor.run_posted();
  EXPECT_FALSE(slot.busy());
  EXPECT_FALSE(executor.busy());
  EXPECT_EQ(executor.ended(), 1U);
  ASSERT_NE(slot.newest(), nullptr);
  EXPECT_EQ(slot.newest()->number, 9);
  EXPECT_EQ(begun, 1);
}

}  // namespace
}  // namespace taxel::studio
