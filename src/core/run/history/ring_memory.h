// Memory for pieces of any size that are forgotten in the order in which they came, or the newest first.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <deque>
#include <future>
#include <memory>

namespace taxel {

/// Pieces lie one after the other in large blocks, which are used again when they are empty: a full ring takes no new
/// memory. While it grows, a thread of its own gets the next block ready: the first touch of fresh memory costs more
/// than filling it, and would empty the caches of the one who fills. Pieces do not move.
class RingMemory {
 public:
  static constexpr std::size_t kBlock = std::size_t{1} << 21;  ///< a huge page [bytes]

  /// A new piece after all others; its bytes hold anything.
  std::byte* push(std::size_t size);
  /// The newest piece, pushed with `size`, needs only `used` of it.
  void shrink_back(std::size_t size, std::size_t used) { blocks_.back().used -= size - used; }
  /// Forgets the oldest piece. Needs one.
  void pop_front();
  /// Forgets the newest piece, whose size is `size`. Needs one.
  void pop_back(std::size_t size);
  void clear();

  [[nodiscard]] std::size_t bytes() const;  ///< of all blocks

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

  std::deque<Block> blocks_;  // none of them without pieces
  Block spare_;               // the last one that ran empty
  std::future<Block> next_;   // made ready
};

}  // namespace taxel
