// Memory that a caller of the contact kernel keeps between calls.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/index.h"
#include "core/base/math.h"
#include "core/hydro/kernel/depth_workspace.h"

namespace taxel {

/// Pairs of tets that were found in a call, as one list per tet of B. Nothing is cleared between calls, because each
/// list has the number of its call.
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
  struct Entry {
    std::int32_t a, older;
  };
  struct List {
    std::uint32_t call = 0;
    std::int32_t newest = -1, done = -1;  ///< entries; entries from `done` on were visited
    bool waits = false;
  };

  std::vector<Entry> entries_;
  std::vector<List> lists_;  ///< list of each tet of B
  std::vector<std::int32_t> waiting_;
  std::uint32_t call_ = 0;
};

inline void MetPairs::insert(std::int32_t b, std::int32_t a) {
  List& list = lists_[at(b)];
  if (list.call != call_) list = {call_};
  for (std::int32_t e = list.newest; e >= 0; e = entries_[at(e)].older) {
    if (entries_[at(e)].a == a) return;
  }
  entries_.push_back({a, list.newest});
  list.newest = static_cast<std::int32_t>(entries_.size()) - 1;
  if (list.waits) return;
  list.waits = true;
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
  list.waits = false;
}

/// A vertex in the frame of the other body.
struct PlacedVertex {
  dvec3 x{0};
  std::int32_t tet = -1;   ///< tet that contains the point, or -1 if none was found
  std::uint32_t call = 0;  ///< number of the call that wrote this entry
};

/// Memory of intersect(). No step allocates memory after the first steps. Each thread needs its own; the content has no
/// meaning between calls.
struct IntersectWorkspace {
  /// Finds pairs only by trees, without tet-to-tet traversal: the same polygons in another order. For tests.
  bool tree_form = false;
  DepthPieceSize piece_size;

  std::vector<std::int32_t> triangles;  ///< triangles of the rigid mesh, or tets or faces of B, that may touch A
  std::vector<std::int32_t> tets;       ///< tets that may touch one triangle
  std::vector<std::int32_t> found;      ///< faces of the boundary that may
  std::vector<PlacedVertex> placed;     ///< vertices of the rigid mesh, or of B
  std::vector<std::uint32_t> seen_in;   ///< for each tet: last triangle that touched it, counted over all calls
  MetPairs met;
  DepthWorkspace depth;  ///< memory for pairs that reach beyond a pad's tets
  std::uint32_t call = 0, triangle = 0;

  /// Makes room for this number of vertices and tets, and begins a new call.
  void begin_call(std::size_t vertices, std::size_t tets_of_field = 0);
};

}  // namespace taxel
