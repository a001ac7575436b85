#include "core/hydro/kernel/workspace.h"

#include <algorithm>

namespace taxel {

bool MetPairs::insert(std::int32_t a, std::int32_t b, std::uint32_t call) {
  if (call != last_call_) {
    last_call_ = call;
    count_ = 0;
  }
  if (2 * (count_ + 1) > entries_.size()) grow(call);
  const std::size_t mask = entries_.size() - 1;
  for (std::size_t i = hash(a, b) & mask;; i = (i + 1) & mask) {
    Entry& entry = entries_[i];
    if (entry.call != call) {
      entry = {a, b, call};
      ++count_;
      return true;
    }
    if (entry.a == a && entry.b == b) return false;
  }
}

void MetPairs::clear() {
  entries_.assign(entries_.size(), {});
}

void MetPairs::grow(std::uint32_t call) {
  const std::vector<Entry> old = std::move(entries_);
  entries_.assign(std::max<std::size_t>(1024, 2 * old.size()), {});
  count_ = 0;
  for (const Entry& entry : old) {
    if (entry.call == call) insert(entry.a, entry.b, call);
  }
}

void IntersectWorkspace::begin_call(std::size_t vertices, std::size_t tets_of_field) {
  if (placed.size() < vertices) placed.resize(vertices);
  if (seen_in.size() < tets_of_field) seen_in.resize(tets_of_field, 0);
  constexpr std::uint32_t kNearEnd = 0x80000000u;  // then the counters begin again, and what they marked is forgotten
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
