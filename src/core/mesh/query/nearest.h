// Faster nearest points of a mesh for many queries. NearFaces: in a small region, where the cells of a grid keep the
// faces that can be nearest. NearestGuess: for queries that move little, where a few comparisons prove most guesses of
// the face, and only the others need a search in the tree. NearestInTurn: for queries that follow each other closely.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/mesh/query/closest_point.h"

namespace taxel {

/// Finds the same points as MeshIndex::closest_point, bit for bit. The eighth query in a cell lists the faces that can
/// be nearest to a point of the cell, and the next queries only compare these, four at once. Each thread needs its own.
/// All memory is allocated by the constructor, and most of it is touched only when it is needed.
class NearFaces {
 public:
  /// `edge` is the edge of the cells [m]. The index must outlive this object. The mesh must not be empty.
  NearFaces(const MeshIndex& index, double edge);

  [[nodiscard]] const MeshIndex& index() const { return *index_; }
  /// Returns the nearest point; ties go to the lowest face number.
  [[nodiscard]] SurfacePoint closest_point(const dvec3& p);

 private:
  static constexpr int kWidth = 4;
  /// One number of each face: a vector that fits a register of every processor.
  using Lanes [[gnu::vector_size(kWidth * sizeof(float))]] = float;
  using Numbers [[gnu::vector_size(kWidth * sizeof(std::int32_t))]] = std::int32_t;
  struct Planes {
    Lanes nx, ny, nz, offset;  ///< n x + offset, relative to the middle of the cell
  };
  /// The planes of four faces, and for each edge the plane across the face through it, with a normal that leads out of
  /// the triangle.
  struct Block {
    Planes face{}, edge[3]{};  ///< an unused lane of `face` is infinitely far
    std::array<std::int32_t, kWidth> number{};
  };
  struct Bounds {
    Lanes squared;  ///< squared lower bounds of the distances [m^2]
  };
  static constexpr std::uint64_t kNoCell = ~std::uint64_t{0};
  struct Cell {
    std::uint64_t key = kNoCell;
    dvec3 middle{0};
    std::uint32_t queries = 0;
    std::uint32_t first = 0, last = 0;  ///< range of blocks_; empty while the tree is faster
    float rounding = 0;                 ///< upper bound of the rounding errors of n x + offset [m]
  };
  const Cell& cell_of(const dvec3& p);
  void list_faces(const dvec3& middle, Cell& cell);
  void set(const dvec3& middle, int face, int lane, Block& block) const;
  static Lanes squared_bounds(const Cell& cell, const Block& block, const std::array<float, 3>& x);

  const MeshIndex* index_;
  double edge_;
  std::vector<Cell> cells_;  ///< a cell takes the place of an earlier one with the same hash
  std::vector<Block> blocks_;
  std::vector<int> listed_;     ///< faces of a new cell
  std::vector<Bounds> bounds_;  ///< for the faces of a cell
};

/// The faces around each face that may have a nearer point. Immutable.
///
/// Let s be the foot of x on the plane of face f, inside of f and at the distance h <= `most` behind it. A point y is
/// nearer to x than s only if it is inside of the ball about x through s, which touches f from behind. For most faces
/// no such ball of a radius up to `most` reaches them. The others are listed for f, and f has the nearest point if none
/// of their planes is nearer to x than h.
class NearestGuess {
 public:
  /// `most` is the largest distance for which guesses are to be proved [m]. The index must outlive this object.
  NearestGuess(const MeshIndex& index, double most);

  /// Returns index.closest_point(x) up to rounding. `guess` is a face, or -1 without a guess, and gets the face of the
  /// result.
  [[nodiscard]] SurfacePoint closest_point(const dvec3& x, int& guess) const;

 private:
  [[nodiscard]] int nearer_plane(int face, const dvec3& x, double within) const;
  [[nodiscard]] int across(int face, const dvec3& barycentric) const;
  [[nodiscard]] std::vector<int> faces_around(int face) const;
  [[nodiscard]] bool may_be_nearer(int face, int other) const;

  const MeshIndex& index_;
  std::vector<std::uint32_t> first_;  ///< the faces around face f are around_ [first_[f], first_[f + 1]), ascending
  std::vector<int> around_;
  std::vector<double> nx_, ny_, nz_, offset_;  ///< planes of around_: n x + offset = 0
  double most_ = 0, slack_ = 0;
};

/// Finds the same points as MeshIndex::closest_point, faster if each query is near the one before: by the triangle
/// inequality the last distance bounds the next one. Each thread needs its own.
class NearestInTurn {
 public:
  /// The index must outlive this object.
  explicit NearestInTurn(const MeshIndex& index) : index_(&index) {}

  [[nodiscard]] SurfacePoint closest_point(const dvec3& p) {
    constexpr double kRounding = 1 + 1e-9;
    const double most = kRounding * (last_distance_ + glm::distance(p, last_point_));
    SurfacePoint point = index_->closest_point(p, most);
    if (point.face < 0) point = index_->closest_point(p);
    last_point_ = p;
    last_distance_ = point.distance;
    return point;
  }

 private:
  const MeshIndex* index_;
  dvec3 last_point_{0};
  double last_distance_ = std::numeric_limits<double>::infinity();
};

}  // namespace taxel
