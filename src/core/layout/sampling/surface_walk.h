// Movement over a mesh: straight lines across its edges, and the surface around a point unfolded into the plane.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// A point of the surface and a direction in the plane of its face.
struct SurfaceStep {
  int face = -1;
  dvec3 position{0};
};

/// The adjacency of faces over edges, built in time proportional to the number of faces. The surface ends at edges with
/// more than two faces, or with two faces of opposite winding.
class SurfaceGraph {
 public:
  explicit SurfaceGraph(const TriMesh& mesh);  ///< keeps a reference

  [[nodiscard]] const TriMesh& mesh() const { return mesh_; }
  /// Turns the tangent vector `v` of `from` over the edge at `corner` into the plane of the face across: unfolded, the
  /// two are parallel.
  [[nodiscard]] dvec3 turn(const dvec3& v, int from, int corner) const {
    const Side& out = sides_[side(from, corner)];
    const Side& in = sides_[static_cast<std::size_t>(flat_[side(from, corner)].across)];
    return glm::dot(v, out.along) * out.along - glm::dot(v, out.outward) * in.outward;
  }

  /// Returns the end of the straightest line (Polthier, Schmies 1998) from `start` along `way`, a vector in the plane
  /// of the face whose length is the length of the line. If the surface ends before, the result is on its rim.
  [[nodiscard]] SurfaceStep walk(SurfaceStep start, dvec3 way) const;

 private:
  struct Side {        // of one face
    dvec3 along{0};    // unit vector of the edge
    dvec3 outward{0};  // unit vector in the plane of the face
    double length = 0;
  };
  struct FlatSide {
    dvec2 apex{0};    // the third corner over the edge laid from (0, 0) to (1, 0)
    int across = -1;  // twin of the half-edge
  };
  friend class SurfaceChart;
  void lay_flat();
  static std::size_t side(int face, int corner) { return static_cast<std::size_t>(3 * face + corner); }

  const TriMesh& mesh_;
  std::vector<Side> sides_;
  std::vector<FlatSide> flat_;
};

/// The surface around one point, unfolded into the plane of its face over the edges nearest to the point. On a
/// developable surface distances are preserved, also over creases of any angle and around the rim of a thin plate, and
/// the distance of an opposite wall is the length of the path to it. The chart reuses its memory, so each thread needs
/// its own.
class SurfaceChart {
 public:
  explicit SurfaceChart(const SurfaceGraph& graph);

  /// Unfolds all faces within `radius` of `origin`. `u` and `v` become the axes of the plane, unit vectors at right
  /// angles in the plane of its face.
  void unfold(const SurfaceStep& origin, const dvec3& u, const dvec3& v, double radius);
  /// Finds the position of `place` in the plane. Returns false if its face is beyond the radius.
  [[nodiscard]] bool find(const SurfaceStep& place, dvec2& flat) const;

 private:
  using Image = std::array<dvec2, 3>;  // of the corners of a face in the plane
  struct Entry {
    int side = 0;   // to be passed, of the face entered
    int image = 0;  // of the face left
  };
  void pass(const Entry& entry, double limit);
  void add(int face, const Image& image, double limit);
  [[nodiscard]] bool has(int face) const { return stamp_[static_cast<std::size_t>(face)] == round_; }

  const SurfaceGraph& graph_;
  std::vector<Image> images_;
  // Edges by their squared distance: the nearest are passed first, up to the width of a bucket.
  std::array<std::vector<Entry>, 64> buckets_;
  std::size_t bucket_ = 0;             // being emptied
  std::vector<int> image_of_, stamp_;  // by face
  int round_ = 0;
};

}  // namespace taxel
