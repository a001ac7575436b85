#include "core/hydro/kernel/workspace.h"

#include <algorithm>

namespace taxel {

void MetPairs::begin(std::uint32_t call, std::size_t tets_of_b) {
  call_ = call;
  entries_.clear();
  waiting_.clear();
  if (lists_.size() < tets_of_b) lists_.resize(tets_of_b);
}

std::int32_t MetPairs::next() {
  if (waiting_.empty()) return -1;
  const std::int32_t b = waiting_.back();
  waiting_.pop_back();
  return b;
}

void MetPairs::clear() {
  lists_.assign(lists_.size(), {});
}

void IntersectWorkspace::begin_call(std::size_t vertices, std::size_t tets_of_field) {
  if (placed.size() < vertices) placed.resize(vertices);
  if (seen_in.size() < tets_of_field) seen_in.resize(tets_of_field, 0);
  constexpr std::uint32_t kNearEnd = 0x80000000u;  // from here on the counters restart without marks
  if (++call > kNearEnd) {
    placed.assign(placed.size(), {});
    met.clear();
    call = 1;
  }
  if (triangle > kNearEnd) {
    std::fill(seen_in.begin(), seen_in.end(), 0u);
    triangle = 0;
  }
}

}  // namespace taxel
