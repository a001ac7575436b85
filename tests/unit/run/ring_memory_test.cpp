// Pieces of memory that are added at one end and removed at either end, compared with a deque of vectors.
#include "core/run/history/step_history.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <deque>
#include <vector>

#include "core/base/rng.h"

namespace taxel {
namespace {

TEST(RingMemory, KeepsTheBytesOfAllPieces) {
  const CounterRng rng(3, 1);
  RingMemory memory;
  struct Piece {
    std::byte* at;
    std::vector<unsigned char> bytes;
  };
  std::deque<Piece> pieces;
  std::uint64_t draw = 0;
  for (int i = 0; i < 4000; ++i) {
    const double what = rng.uniform(draw++);
    if (what < 0.55 || pieces.empty()) {
      const double exponent = rng.uniform(draw++);
      const auto size = static_cast<std::size_t>(std::pow(3e6, exponent));  // a few pieces are larger than a block
      const std::size_t spare = i % 7 == 0 ? size / 3 : 0;                  // requested and returned
      std::byte* at = memory.push(size + spare);
      memory.shrink_back(size + spare, size);
      Piece piece{at, std::vector<unsigned char>(size, static_cast<unsigned char>(i))};
      std::memcpy(piece.at, piece.bytes.data(), size);
      pieces.push_back(std::move(piece));
    } else if (what < 0.85) {
      memory.pop_front();
      pieces.pop_front();
    } else {
      memory.pop_back(pieces.back().bytes.size());
      pieces.pop_back();
    }
    if (i % 200 != 0) continue;
    for (const Piece& piece : pieces) EXPECT_EQ(std::memcmp(piece.at, piece.bytes.data(), piece.bytes.size()), 0);
  }
}

TEST(RingMemory, ReusesItsBlocksIfItIsFull) {
  RingMemory memory;
  constexpr std::size_t kPiece = 70001;
  for (int i = 0; i < 100; ++i) memory.push(kPiece);
  const auto turn = [&] {
    for (int i = 0; i < 1000; ++i) {
      memory.pop_front();
      memory.push(kPiece);
    }
    return memory.bytes();
  };
  const std::size_t after_a_turn = turn();
  EXPECT_EQ(turn(), after_a_turn);
  EXPECT_GE(after_a_turn, 100 * kPiece);
  EXPECT_LE(after_a_turn, 100 * kPiece + 4 * RingMemory::kBlock);
  memory.clear();
  EXPECT_EQ(memory.bytes(), 0u);
}

}  // namespace
}  // namespace taxel
