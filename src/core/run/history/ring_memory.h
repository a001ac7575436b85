// Memory for pieces of any size that are freed oldest first or newest first.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <deque>
#include <future>
#include <memory>

namespace taxel {

/// Pieces are placed one after the other in large blocks, which are reused when they are empty: a full ring allocates
/// no memory. While the ring grows, a separate thread prepares the next block, because the first access to new memory
/// costs more than filling it and evicts the caches of the thread that fills. Pieces do not move.
class RingMemory {
 public:
  static constexpr std::size_t kBlock = std::size_t{1} << 21;  ///< a huge page [bytes]

  /// Adds a piece with uninitialized bytes.
  std::byte* push(std::size_t size);
  /// Reduces the newest piece from `size` to `used` bytes.
  void shrink_back(std::size_t size, std::size_t used) { blocks_.back().used -= size - used; }
  /// Frees the oldest piece. Needs a piece.
  void pop_front();
  /// Frees the newest piece, which has `size` bytes. Needs a piece.
  void pop_back(std::size_t size);
  void clear();

  [[nodiscard]] std::size_t bytes() const;  ///< size of all blocks

 private:
  struct Free {
    void operator()(std::byte* block) const { std::free(block); }
  };
  struct Block {
    std::unique_ptr<std::byte[], Free> data;
    std::size_t size = 0, used = 0, pieces = 0;
  };
  static Block make_block(std::size_t size);
  [[nodiscard]] Block take_block(std::size_t size);
  void retire(Block block);

  std::deque<Block> blocks_;  // blocks with at least one piece
  Block spare_;               // the block that became empty last
  std::future<Block> next_;   // the block that is being prepared
};

}  // namespace taxel
