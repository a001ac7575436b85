#include "core/sim/plugin/shared/owned_objects.h"

#include <bit>
#include <stdexcept>

namespace taxel {

OwnedObjects::Place* OwnedObjects::place(std::uint32_t index) const {
  const std::uint64_t shifted = std::uint64_t{index} + (1U << kFirstBits);
  const int block = static_cast<int>(std::bit_width(shifted)) - 1 - kFirstBits;
  if (block >= kBlocks) return nullptr;
  Place* first = blocks_[static_cast<std::size_t>(block)].load(std::memory_order_acquire);
  return first == nullptr ? nullptr : first + (shifted - (std::uint64_t{1} << (block + kFirstBits)));
}

std::uint32_t OwnedObjects::new_index() {
  if (!free_.empty()) {
    const std::uint32_t index = free_.back();
    free_.pop_back();
    return index;
  }
  const std::uint64_t shifted = std::uint64_t{count_} + (1U << kFirstBits);
  if (std::has_single_bit(shifted)) {  // the first place of a block
    const int block = static_cast<int>(std::bit_width(shifted)) - 1 - kFirstBits;
    if (block >= kBlocks) throw std::length_error("too many instances of the plugin");
    blocks_[static_cast<std::size_t>(block)].store(new Place[shifted], std::memory_order_release);
  }
  free_.reserve(count_ + 1);  // so that remove() needs no memory
  return count_++;
}

std::uint64_t OwnedObjects::add(const void* owner, void* object) {
  const std::lock_guard lock(mutex_);
  const std::uint32_t index = new_index();
  Place& p = *place(index);
  p.owner.store(owner, std::memory_order_relaxed);
  p.object.store(object, std::memory_order_relaxed);
  return std::uint64_t{p.generation.load(std::memory_order_relaxed)} << 32 | index;
}

void* OwnedObjects::find(const void* owner, std::uint64_t number) const {
  const auto generation = static_cast<std::uint32_t>(number >> 32);
  const Place* p = generation == 0 ? nullptr : place(static_cast<std::uint32_t>(number));
  if (p == nullptr || p->generation.load(std::memory_order_acquire) != generation) return nullptr;
  return p->owner.load(std::memory_order_relaxed) == owner ? p->object.load(std::memory_order_relaxed) : nullptr;
}

void* OwnedObjects::remove(const void* owner, std::uint64_t number) {
  void* object = find(owner, number);
  if (object == nullptr) return nullptr;
  const std::lock_guard lock(mutex_);
  const auto index = static_cast<std::uint32_t>(number);
  Place& p = *place(index);
  p.owner.store(nullptr, std::memory_order_relaxed);
  p.object.store(nullptr, std::memory_order_relaxed);
  std::uint32_t next = p.generation.load(std::memory_order_relaxed) + 1;
  if (next == 0) next = 1;
  p.generation.store(next, std::memory_order_release);
  free_.push_back(index);
  return object;
}

}  // namespace taxel
