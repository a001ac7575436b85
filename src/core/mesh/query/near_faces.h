// Nearest points of a mesh for many queries in a small region: the cells of a grid keep the faces that can be nearest.
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

}  // namespace taxel
