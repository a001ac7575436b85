// Memory of depth pieces, kept between calls.
#pragma once

#include <algorithm>
#include <cstdint>
#include <list>
#include <utility>
#include <vector>

#include "core/hydro/kernel/depth_field.h"
#include "core/hydro/kernel/plane/covered_region.h"
#include "core/mesh/query/bvh.h"

namespace taxel {

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

}  // namespace taxel
