#include "core/hydro/kernel/workspace.h"

#include <algorithm>
#include <utility>

namespace taxel {
namespace {

std::size_t hash_of(std::int32_t b, std::int32_t a) {
  const std::uint64_t key =
      static_cast<std::uint64_t>(static_cast<std::uint32_t>(b)) << 32 | static_cast<std::uint32_t>(a);
  return static_cast<std::size_t>((key * 0x9e3779b97f4a7c15u) >> 32);  // Fibonacci hashing
}

}  // namespace

void MetPairs::begin(std::uint32_t call, std::size_t tets_of_b) {
  call_ = call;
  entries_.clear();
  waiting_.clear();
  in_table_ = 0;
  if (lists_.size() < tets_of_b) lists_.resize(tets_of_b);
}

std::int32_t MetPairs::next() {
  if (waiting_.empty()) return -1;
  const std::int32_t b = waiting_.back();
  waiting_.pop_back();
  return b;
}

bool MetPairs::insert_in_table(std::int32_t b, std::int32_t a) {
  const std::size_t mask = table_.size() - 1;
  for (std::size_t i = hash_of(b, a) & mask;; i = (i + 1) & mask) {
    Slot& slot = table_[i];
    if (slot.call != call_) {
      slot = {b, a, call_};
      ++in_table_;
      return true;
    }
    if (slot.b == b && slot.a == a) return false;
  }
}

bool MetPairs::insert_long(const List& list, std::int32_t b, std::int32_t a) {
  make_room_in_table(kShort + 1);
  if (list.count == kShort) {
    for (std::int32_t e = list.newest; e >= 0; e = entries_[at(e)].older) insert_in_table(b, entries_[at(e)].a);
  }
  return insert_in_table(b, a);
}

void MetPairs::make_room_in_table(std::size_t more) {
  constexpr std::size_t kFewest = 1024;
  if (2 * (in_table_ + more) <= table_.size()) return;
  const std::vector<Slot> old = std::move(table_);
  table_.assign(std::max(kFewest, 2 * old.size()), {});
  in_table_ = 0;
  for (const Slot& slot : old) {
    if (slot.call == call_) insert_in_table(slot.b, slot.a);
  }
}

void MetPairs::clear() {
  lists_.assign(lists_.size(), {});
  table_.assign(table_.size(), {});
}

void KernelMemory::begin_call(std::size_t vertices, std::size_t tets_of_field) {
  if (placed.size() < vertices) placed.resize(vertices);
  if (seen_in.size() < tets_of_field) seen_in.resize(tets_of_field, 0);
  constexpr std::uint32_t kNearEnd = 0x80000000u;  // from here on the counters restart without marks
  if (++call > kNearEnd) {
    placed.assign(placed.size(), {});
    met.clear();
    call = 1;
  }
  if (facet > kNearEnd) {
    std::fill(seen_in.begin(), seen_in.end(), 0u);
    facet = 0;
  }
}

}  // namespace taxel
