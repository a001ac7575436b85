// Copies past the caches are correct on every instruction set, for any begin and end.
#include "core/run/history/stream_copy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "fixtures/instruction_sets.h"

namespace taxel {
namespace {

TEST(StreamCopy, CopiesExactlyTheRangeOnEveryInstructionSet) {
  constexpr std::size_t kRoom = 512, kMargin = 64;
  std::vector<std::byte> source(kRoom);
  for (std::size_t i = 0; i < kRoom; ++i) source[i] = static_cast<std::byte>(i * 7 + i / 256 + 1);
  test::for_each_set([&](std::int64_t target) {
    test::on_target(target, [&] {
      for (const std::size_t size : {0U, 1U, 8U, 63U, 64U, 65U, 127U, 128U, 200U, 400U}) {
        for (std::size_t shift = 0; shift < kMargin; shift += 3) {
          std::vector<std::byte> to(kRoom + 2 * kMargin, std::byte{0xee}), expected = to;
          stream_copy(to.data() + shift, source.data() + shift % 5, size);
          std::copy_n(source.begin() + static_cast<std::ptrdiff_t>(shift % 5), size,
                      expected.begin() + static_cast<std::ptrdiff_t>(shift));
          EXPECT_EQ(to, expected) << size << " bytes at " << shift;
        }
      }
      return 0;
    });
  });
}

}  // namespace
}  // namespace taxel
