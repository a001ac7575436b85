// Memory that a caller of the contact kernel keeps between calls: pairs of tets that were found, depth pieces, and what
// each kernel needs.
#pragma once

#include <algorithm>
#include <cstdint>
#include <list>
#include <utility>
#include <vector>

#include "core/base/math.h"
#include "core/hydro/kernel/covered_region.h"
#include "core/hydro/kernel/depth_field.h"
#include "core/hydro/kernel/law_pass.h"
#include "core/mesh/query/bvh.h"

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

/// Largest difference, in thicknesses, between D at the middle of a piece's edge and the mean of D at its ends. A
/// smaller value makes more pieces. With this one the force is within 1 % of that of far smaller pieces.
inline constexpr double kDepthTolerance = 0.02;
/// Shortest edge of a piece that is divided, in thicknesses. Without this limit, division would never end at the medial
/// axis, across which D is not linear for pieces of any size.
inline constexpr double kMinPieceEdge = 0.25;

/// Sizes at which pieces are divided. Tests use finer pieces.
struct DepthPieceSize {
  double tolerance = kDepthTolerance, min_edge = kMinPieceEdge;
};

/// Values at lattice points, by integer keys. Nothing is cleared between calls.
template <class Value>
class PointCache {
 public:
  /// Forgets all points.
  void begin() {
    used_ = 0;
    if (++epoch_ != 0) return;
    for (Entry& entry : entries_) entry.epoch = 0;
    epoch_ = 1;
  }
  /// Returns the value of a point; `is_new` becomes true if the value is not set yet. Valid until the next call.
  Value& at(std::uint64_t key, bool& is_new) {
    if (2 * (used_ + 1) > entries_.size()) grow();
    Entry& entry = entries_[slot_of(key)];
    is_new = entry.epoch != epoch_;
    if (is_new) {
      entry = {epoch_, key, {}};
      ++used_;
    }
    return entry.value;
  }

 private:
  struct Entry {
    std::uint32_t epoch = 0;
    std::uint64_t key = 0;
    Value value;
  };
  [[nodiscard]] std::size_t slot_of(std::uint64_t key) const {
    std::uint64_t hash = key * 0x9E3779B97F4A7C15u;
    hash = (hash ^ hash >> 29) * 0xBF58476D1CE4E5B9u;
    const std::size_t mask = entries_.size() - 1;
    std::size_t slot = static_cast<std::size_t>(hash >> 20) & mask;
    while (entries_[slot].epoch == epoch_ && entries_[slot].key != key) slot = (slot + 1) & mask;
    return slot;
  }
  void grow() {
    constexpr std::size_t kFirst = 1024;
    std::vector<Entry> old = std::move(entries_);
    entries_.assign(std::max(kFirst, 2 * old.size()), {});
    for (const Entry& entry : old)
      if (entry.epoch == epoch_) entries_[slot_of(entry.key)] = entry;
  }

  std::vector<Entry> entries_;
  std::size_t used_ = 0;
  std::uint32_t epoch_ = 0;
};

/// Pressures of two soft bodies at a point, negative outside of a body [Pa].
struct PressurePair {
  double a = 0, b = 0;
};

/// Area below which a part of a piece is a rounding error, as a fraction of the piece.
inline constexpr double kMinPart = 1e-9;

/// Memory of depth pieces.
struct DepthWorkspace {
  /// A facet that reaches beyond the tets, and its polygons of the tets: [first, last) of the surface.
  struct DeepFacet {
    std::int32_t facet;
    std::size_t first, last;
  };
  /// Returns the queries of a field, which keep their memory while no more than four fields take turns. Valid until the
  /// next call.
  NearFaces& near_faces(const DepthFieldPtr& field) {
    constexpr std::size_t kMostFields = 4;
    auto found = std::find_if(queries.begin(), queries.end(), [&](const auto& query) { return query.first == field; });
    if (found == queries.end()) {
      if (queries.size() == kMostFields) queries.pop_back();
      found = queries.emplace(queries.begin(), field, field->near_faces());
    }
    queries.splice(queries.begin(), queries, found);
    return found->second;
  }

  std::list<std::pair<DepthFieldPtr, NearFaces>> queries;  ///< latest one first
  std::vector<DeepFacet> facets;
  PointCache<DepthField::Sample> samples;  ///< D at the corners of pieces
  PointCache<PressurePair> pressures;      ///< pressures of two soft bodies at the corners of cubes
  CoveredRegion covered;                   ///< polygons of the tets in the coordinates of the plane
  std::vector<FlatPolygon> rest;           ///< parts of a piece outside of the polygons of the tets
  std::vector<FlatPolygon> scratch;
  std::vector<std::int32_t> lists;  ///< numbers of the polygons of pairs of tets near a cube
  std::vector<dvec3> core_points;   ///< middles of the edges at which polygons of pairs of tets end on a core, frame A
  std::vector<Aabb> boxes;          ///< boxes of the polygons of pairs of tets, frame A
  Bvh tree;                         ///< tree over `boxes`
  /// A cube of the lattice that the surface intersects.
  struct Cube {
    ivec3 corner;
    int steps;       ///< number of more cubes to visit from here, if the tets cover them
    unsigned faces;  ///< faces across which the surface continues
    bool is_done;    ///< true if its part of the surface is added
  };
  PointCache<std::int32_t> visited;  ///< indices of `cubes`
  std::vector<Cube> cubes;
  std::vector<std::int32_t> queue;  ///< cubes whose neighbours must still be visited
  /// Length of the difference of the two gradients [Pa/m], for each polygon that add_march() added: the last ones of
  /// the surface. The two gradients differ along the polygon's normal, because the two pressures are equal on it.
  std::vector<double> slopes;
};

/// A vertex in the frame of the other body.
struct PlacedVertex {
  dvec3 x{0};
  std::int32_t tet = -1;   ///< tet that contains the point, or -1 if none was found
  std::uint32_t call = 0;  ///< number of the call that wrote this entry
};

/// Settings and memory of the kernels, which IntersectWorkspace holds.
struct KernelMemory {
  /// Finds pairs only by trees, without tet-to-tet traversal: the same polygons in another order. For tests.
  bool tree_form = false;
  DepthPieceSize piece_size;

  std::vector<std::int32_t> facets;    ///< facets of the rigid mesh, or tets or faces of B, that may touch A
  std::vector<std::int32_t> tets;      ///< tets that may touch one facet
  std::vector<std::int32_t> found;     ///< faces of the boundary that may
  std::vector<PlacedVertex> placed;    ///< vertices of the rigid mesh, or of B
  std::vector<std::uint32_t> seen_in;  ///< for each tet: last facet that touched it, counted over all calls
  MetPairs met;
  DepthWorkspace depth;  ///< memory for pairs that reach beyond a pad's tets
  LawMemory law;         ///< memory for bodies with a pressure law that is not linear
  std::uint32_t call = 0, facet = 0;

  /// Makes room for this number of vertices and tets, and begins a new call.
  void begin_call(std::size_t vertices, std::size_t tets_of_field = 0);
};

}  // namespace taxel
