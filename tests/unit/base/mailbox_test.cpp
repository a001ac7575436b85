// The mailbox passes the newest value from one thread to another.
#include "core/base/mailbox.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace taxel {
namespace {

TEST(Mailbox, GivesTheNewestValueOnce) {
  Mailbox<int> box;
  EXPECT_EQ(box.take(), nullptr);
  box.post(std::make_shared<int>(1));
  box.post(std::make_shared<int>(2));
  const auto taken = box.take();
  ASSERT_NE(taken, nullptr);
  EXPECT_EQ(*taken, 2);
  EXPECT_EQ(box.take(), nullptr);
}

TEST(Mailbox, IsFullUntilTheLastValueIsTaken) {
  Mailbox<int> box;
  EXPECT_FALSE(box.full());
  box.post(std::make_shared<const int>(1));
  EXPECT_TRUE(box.full());
  box.take();
  EXPECT_FALSE(box.full());
}

TEST(Mailbox, ReleasesASupersededValue) {
  Mailbox<int> box;
  const auto first = std::make_shared<const int>(1);
  box.post(first);
  EXPECT_EQ(first.use_count(), 2);
  box.post(std::make_shared<const int>(2));
  EXPECT_EQ(first.use_count(), 1);
}

TEST(Mailbox, PassesValuesInOrderAndTheLastOneBetweenThreads) {
  struct Pair {
    int a, b;
  };
  Mailbox<Pair> box;
  constexpr int kLast = 20000;
  std::thread writer([&] {
    for (int i = 1; i <= kLast; ++i) box.post(std::make_shared<const Pair>(Pair{i, -i}));
  });
  int last = 0;
  while (last < kLast) {
    const auto value = box.take();
    if (!value) continue;
    EXPECT_GT(value->a, last);
    EXPECT_EQ(value->b, -value->a);
    last = value->a;
  }
  writer.join();
  EXPECT_EQ(box.take(), nullptr);
}

}  // namespace
}  // namespace taxel
