#include "core/run/history/ring_memory.h"

#include <cstring>
#include <new>
#include <utility>

#include "core/base/os/memory.h"

namespace taxel {

RingMemory::Block RingMemory::make_block(std::size_t size) {
  const std::size_t whole = (size + kBlock - 1) / kBlock * kBlock;
  Block block{std::unique_ptr<std::byte[], Free>(static_cast<std::byte*>(std::aligned_alloc(kBlock, whole))), whole};
  if (block.data == nullptr) throw std::bad_alloc();
  os::prefer_huge_pages(block.data.get(), whole);
  std::memset(block.data.get(), 0, whole);
  return block;
}

RingMemory::Block RingMemory::take_block(std::size_t size) {
  if (spare_.size >= size) return std::exchange(spare_, {});
  if (size > kBlock) return make_block(size);
  Block block = next_.valid() ? next_.get() : make_block(kBlock);
  next_ = std::async(std::launch::async, make_block, kBlock);
  return block;
}

void RingMemory::clear() {
  blocks_.clear();
  spare_ = {};
  if (next_.valid()) next_.get();
}

std::byte* RingMemory::push(std::size_t size) {
  if (blocks_.empty() || blocks_.back().used + size > blocks_.back().size) {
    blocks_.push_back(take_block(size));
  }
  Block& block = blocks_.back();
  std::byte* piece = block.data.get() + block.used;
  block.used += size;
  ++block.pieces;
  return piece;
}

void RingMemory::retire(Block block) {
  block.used = block.pieces = 0;
  spare_ = std::move(block);
}

void RingMemory::pop_front() {
  if (--blocks_.front().pieces > 0) return;
  retire(std::move(blocks_.front()));
  blocks_.pop_front();
}

void RingMemory::pop_back(std::size_t size) {
  Block& block = blocks_.back();
  block.used -= size;
  if (--block.pieces > 0) return;
  retire(std::move(block));
  blocks_.pop_back();
}

std::size_t RingMemory::bytes() const {
  std::size_t sum = spare_.size + (next_.valid() ? kBlock : 0);
  for (const Block& block : blocks_) sum += block.size;
  return sum;
}

}  // namespace taxel
