// Memory of the pairs of tets that the contact kernel has found in a call.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/index.h"

namespace taxel {

/// Pairs of tets that were found in a call, as one list per tet of B. Nothing is cleared between calls, because each
/// list and each slot has the number of its call. A short list is searched, and the pairs of a long one are in a hash
/// table: a large tet of B meets thousands of small tets of A, and each of them is inserted about four times.
class MetPairs {
 public:
  /// Begins a new call and makes room for lists of `tets_of_b` tets of B. Calls are counted from 1.
  void begin(std::uint32_t call, std::size_t tets_of_b);
  void insert(std::int32_t b, std::int32_t a);
  /// Returns a tet of B with pairs that for_each_new() has not visited yet, or -1 if there is none.
  std::int32_t next();
  /// Calls f(a) once for each tet a that is paired with `b`, including pairs that f adds.
  template <class F>
  void for_each_new(std::int32_t b, F&& f);
  /// Forgets all calls.
  void clear();

 private:
  static constexpr std::uint32_t kShort = 12;  ///< longest list that is searched
  struct Entry {
    std::int32_t a, older;
  };
  struct List {
    std::uint32_t call = 0;
    std::int32_t newest = -1, done = -1;  ///< entries; entries from `done` on were visited
    std::uint32_t count : 31 = 0;
    std::uint32_t waits : 1 = 0;  ///< 1 if the list is in `waiting_`
  };
  struct Slot {
    std::int32_t b = 0, a = 0;
    std::uint32_t call = 0;  ///< the slot is free in other calls
  };

  /// Inserts a pair that is not in the table, which has room for it, or returns false if it is there.
  bool insert_in_table(std::int32_t b, std::int32_t a);
  /// Inserts a pair of a long list, as above. Before the first one it inserts the pairs that the list has.
  bool insert_long(const List& list, std::int32_t b, std::int32_t a);
  void make_room_in_table(std::size_t more);

  std::vector<Entry> entries_;
  std::vector<List> lists_;  ///< list of each tet of B
  std::vector<std::int32_t> waiting_;
  std::vector<Slot> table_;  ///< open addressing; the size is a power of two
  std::size_t in_table_ = 0;
  std::uint32_t call_ = 0;
};

inline void MetPairs::insert(std::int32_t b, std::int32_t a) {
  List& list = lists_[at(b)];
  if (list.call != call_) list = {call_};
  if (list.count < kShort) {
    for (std::int32_t e = list.newest; e >= 0; e = entries_[at(e)].older) {
      if (entries_[at(e)].a == a) return;
    }
  } else if (!insert_long(list, b, a)) {
    return;
  }
  entries_.push_back({a, list.newest});
  list.newest = static_cast<std::int32_t>(entries_.size()) - 1;
  ++list.count;
  if (list.waits != 0) return;
  list.waits = 1;
  waiting_.push_back(b);
}

template <class F>
void MetPairs::for_each_new(std::int32_t b, F&& f) {
  List& list = lists_[at(b)];
  while (list.newest != list.done) {
    const std::int32_t newest = list.newest;
    for (std::int32_t e = newest; e != list.done; e = entries_[at(e)].older) f(entries_[at(e)].a);
    list.done = newest;
  }
  list.waits = 0;
}

}  // namespace taxel
