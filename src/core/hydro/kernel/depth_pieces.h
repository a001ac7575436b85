// Adds contact beyond a pad's tets, so that contact surfaces have no holes. The part of a rigid surface that reaches
// beyond the tets is divided into pieces on which the depth D below the skin is nearly linear, with p = (E/H) D.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/hydro/kernel/covered_region.h"
#include "core/hydro/kernel/depth_field.h"
#include "core/hydro/kernel/index/field_index.h"
#include "core/hydro/kernel/index/wide_tree.h"
#include "core/hydro/kernel/surface_writer.h"
#include "core/hydro/kernel/workspace.h"

namespace taxel {

/// A corner with integer coordinates, so that pieces of a facet share their corners exactly.
struct LatticeCorner {
  std::int32_t i = 0, j = 0;
  bool operator==(const LatticeCorner&) const = default;
};

inline LatticeCorner middle(const LatticeCorner& a, const LatticeCorner& b) {
  return {(a.i + b.i) / 2, (a.j + b.j) / 2};
}

/// A triangle or a parallelogram, counter-clockwise.
struct LatticePolygon {
  std::array<LatticeCorner, 4> corner;
  int count = 3;  ///< number of corners
};

/// A triangle or a parallelogram with two long edges, cut across them:
///
///     tip --- 1 --- 2 --- 3 --- end of a     Each of the 2^halvings strips has parts of the two long edges as its
///       `---- 1 --- 2 --- 3 --- end of b     sides; strips are as long as the facet is wide, or up to half of that.
///
/// Both edges of a triangle begin at its tip, those of a parallelogram at two corners.
struct LatticeStrips {
  struct LongEdge {
    LatticeCorner begin, end;
  };
  /// Beginning and end of a, then end and beginning of b are counter-clockwise.
  LongEdge a, b;
  int halvings;

  [[nodiscard]] bool has_tip() const { return a.begin == b.begin; }
  /// Returns the corner of strip n, counted from the beginning, on a long edge.
  [[nodiscard]] LatticeCorner on(const LongEdge& edge, std::int32_t n) const {
    const auto between = [&](std::int64_t from, std::int64_t to) {
      return static_cast<std::int32_t>(from + (to - from) * n / (std::int64_t{1} << halvings));
    };
    return {between(edge.begin.i, edge.end.i), between(edge.begin.j, edge.end.j)};
  }
};

/// Returns the edges at which the polygon of a tet ends the part of a plane that the tets cover: they are on faces of
/// the tet without a neighbour. The vertices x are in the frame of the tets [m].
CoveredRegion::Ends ends_of(const PackedTet& tet, std::span<const dvec3> x);

/// A plane x = origin + (i u + j v)/units of lattice points (i, j), frame S of the field.
struct LatticePlane {
  SurfaceTriangle triangle;  ///< corners: origin, origin + u and origin + v
  dvec3 normal{0};           ///< unit normal
  int face = -1;             ///< face of the rigid mesh, -1 for a half-space
  std::int32_t units = 1;
};

/// The depth pieces of one plane: a facet or a half-space, divided until the depth D is nearly linear on each piece.
class PlanePieces {
 public:
  /// All arguments must outlive the object.
  PlanePieces(const DepthFieldPtr& depth, const FieldIndex& tets, const DepthPieceSize& size, const LatticePlane& plane,
              SurfaceWriter& writer, DepthWorkspace& workspace);

  /// Records that the surface's polygons [first, last) lie in the plane. Pieces fill only the part outside of them.
  void cover(std::size_t first, std::size_t last);
  /// Adds the pieces of a part of the plane, which is halved at most `levels` times.
  void add(const LatticePolygon& polygon, int levels) { refine({polygon, levels, all_}); }

 private:
  struct Piece {
    LatticePolygon polygon;
    int levels;                ///< halvings that are left
    CoveredRegion::List near;  ///< polygons of the tets near the piece of which this one is a part
  };
  /// A piece, or some of them in a row, in the plane and in space.
  struct Outline {
    FlatPolygon flat;
    std::array<dvec3, 4> x;  ///< frame S
    [[nodiscard]] std::span<const dvec3> corners() const { return {x.data(), static_cast<std::size_t>(flat.count)}; }
  };
  /// The part of a piece that the polygons of the tets leave.
  struct Left {
    bool nothing = true;  ///< the piece is outside of the body or covered
    CoveredRegion::Cover cover = CoveredRegion::Cover::none;
    CoveredRegion::List near;  ///< polygons near the piece; whoever called left_of() removes the list
  };
  /// D at the corners of a piece and at the middles of its edges. Edge k runs from corner k to the next one.
  struct Depths {
    std::size_t count = 3;
    std::array<DepthField::Sample, 4> at_corner, at_middle;
    std::array<double, 4> edge{};  ///< lengths [m]
    double longest = 0;            ///< longest edge or diagonal [m]
  };
  /// The next step for a piece.
  enum class Step { drop, halve, divide, keep };

  [[nodiscard]] dvec2 plane_point(const LatticeCorner& c) const { return {c.i * per_unit_, c.j * per_unit_}; }
  [[nodiscard]] dvec3 point(const LatticeCorner& c) const {
    return plane_.triangle.x_S[0] + (c.i * per_unit_) * u_ + (c.j * per_unit_) * v_;
  }
  [[nodiscard]] Outline outline_of(const LatticePolygon& polygon) const;
  const DepthField::Sample& sample(const LatticeCorner& c);
  [[nodiscard]] bool is_far(std::span<const dvec3> x) const;
  Left left_of(const Outline& outline, const LatticeCorner& first, const CoveredRegion::List& parent);

  void refine(const Piece& piece);
  void refine_left(const Piece& piece, const Outline& outline, const Left& left);
  Step step_of(const Piece& piece, const Outline& outline, Depths& d);
  [[nodiscard]] bool must_divide(const Depths& d) const;
  [[nodiscard]] bool is_cut(const Depths& d) const;
  [[nodiscard]] double longest_piece(bool is_cut) const;

  void halve(const Piece& piece, const CoveredRegion::List& near);
  void divide(const Piece& piece, const Depths& d, const CoveredRegion::List& near);
  void quarter(const Piece& piece, const CoveredRegion::List& near);
  void cut_across(LatticeStrips strips, double long_edge, double width, int levels, const CoveredRegion::List& near);
  void refine_strips(const LatticeStrips& s, std::int32_t begin, std::int32_t end, int levels,
                     const CoveredRegion::List& parent);
  bool are_too_large(const LatticeStrips& s, std::int32_t begin, std::int32_t end, CoveredRegion::Cover cover);

  void keep(const FlatPolygon& flat, const CoveredRegion::List& near, const Depths& d);
  [[nodiscard]] FlatPolygon clip_by_depth(const FlatPolygon& flat, const Depths& d) const;
  [[nodiscard]] dvec3 gradient_of(const PlanePressure& p, const Depths& d) const;

  const DepthField& depth_;
  NearFaces& near_;
  const FieldIndex& tets_;
  const LatticePlane& plane_;
  double per_unit_;
  dvec3 u_, v_;
  double unit_area_;  ///< area of the parallelogram of u and v [m^2]
  double least_depth_, tolerance_, min_edge_;
  SurfaceWriter& writer_;
  DepthWorkspace& w_;
  Aabb body_;
  CoveredRegion::List all_;
};

/// Adds the pieces of the facets in `workspace`, which have pose X_SR in the frame S of the field and of its tets. The
/// polygons of the tets remain, and the pieces fill the rest of the facets. Each piece gets tet -1 and the facet's
/// face.
void add_depth_pieces(const DepthFieldPtr& depth, const FieldIndex& tets, const FacetTree& rigid,
                      const RigidTransform& X_SR, const DepthPieceSize& size, SurfaceWriter& writer,
                      DepthWorkspace& workspace);

/// Adds the pieces of the plane z = 0 of a frame R with pose X_SR. All polygons of the plane must be in the writer's
/// surface.
void add_depth_pieces(const DepthFieldPtr& depth, const FieldIndex& tets, const RigidTransform& X_SR,
                      const DepthPieceSize& size, SurfaceWriter& writer, DepthWorkspace& workspace);

}  // namespace taxel
