// Memory that a caller of the contact kernel keeps between calls.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/math.h"

namespace taxel {

/// Pairs of tets that were met in a call: a hash table that is never cleared, its entries name the call.
class MetPairs {
 public:
  /// False when the pair is there already. Calls count from 1.
  bool insert(std::int32_t a, std::int32_t b, std::uint32_t call);
  void clear();

 private:
  struct Entry {
    std::int32_t a = -1, b = -1;
    std::uint32_t call = 0;
  };
  static std::size_t hash(std::int32_t a, std::int32_t b) {
    const std::uint64_t key =
        static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32 | static_cast<std::uint32_t>(b);
    return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15u) >> 24);  // golden ratio: Knuth, volume 3, 6.4
  }
  void grow(std::uint32_t call);

  std::vector<Entry> entries_;
  std::size_t count_ = 0;
  std::uint32_t last_call_ = 0;
};

/// A vertex in the frame of the other body.
struct PlacedVertex {
  dvec3 x{0};
  std::int32_t tet = -1;   ///< that holds it; -1: none was found
  std::uint32_t call = 0;  ///< that wrote this
};

/// No step allocates after warm-up. One per thread; its content means nothing between calls.
struct IntersectWorkspace {
  /// Finds pairs by trees alone, without walking from tet to tet: the same polygons in another order. For tests.
  bool tree_form = false;

  struct TetPair {
    std::int32_t a, b;
  };
  std::vector<std::int32_t> triangles;  ///< of the rigid mesh, or tets or faces of A, that may meet the other body
  std::vector<std::int32_t> tets;       ///< that may meet one triangle
  std::vector<std::int32_t> found;      ///< faces of the boundary that may
  std::vector<PlacedVertex> placed;     ///< of the rigid mesh, or of A
  std::vector<std::uint32_t> seen_in;   ///< of each tet: the triangle, counted over all calls, that last met it
  std::vector<TetPair> pairs;           ///< yet to be cut
  MetPairs met;
  std::uint32_t call = 0, triangle = 0;

  /// Makes room for so many vertices and tets, and opens a new call.
  void begin_call(std::size_t vertices, std::size_t tets_of_field = 0);
};

}  // namespace taxel
