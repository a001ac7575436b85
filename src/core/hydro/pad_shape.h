// Where the inner vertices of a pad lie, and the tets between them and the skin.
#pragma once

#include <span>

#include "core/hydro/pad_directions.h"
#include "core/hydro/prism.h"
#include "core/mesh/closest_point.h"

namespace taxel {

/// Every skin vertex has an inner one, offset along its direction by the pad's thickness or by what the body's own
/// thickness allows. Vertices of the skin have their numbers in the mesh; inner ones follow: v + vertex_count().
class PadShape {
 public:
  /// Cost: some closest-point queries per vertex.
  PadShape(const MeshIndex& index, double thickness);

  [[nodiscard]] dvec3 inner_position(int v) const { return moved(v, offset_[at(v)]); }
  [[nodiscard]] double offset(int v) const { return offset_[at(v)]; }
  [[nodiscard]] const PadDirection& direction(int v) const { return inward_[at(v)]; }
  /// Distance of the inner vertex to the skin, not negative [m].
  [[nodiscard]] double depth(int v) const { return depth_[at(v)]; }
  /// Whether the offset is shorter than the thickness asks for.
  [[nodiscard]] bool limited(int v) const { return offset_[at(v)] < 0.999 * full_[at(v)]; }
  /// The offset over what the thickness asks for.
  [[nodiscard]] double part_left(int v) const { return offset_[at(v)] / full_[at(v)]; }
  /// Tets of positive volume, in skin and inner vertex numbers: three; fewer where corners are pinched, none where the
  /// face has no pad.
  [[nodiscard]] PrismTets tets(int face) const;

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] dvec3 moved(int v, double h) const { return mesh_.vertices()[at(v)] + h * inward_[at(v)].direction; }
  [[nodiscard]] dvec3 position(int v) const;
  [[nodiscard]] int inner(int v) const { return pinched_[at(v)] ? v : v + mesh_.vertex_count(); }
  [[nodiscard]] double own_offset(int v, double most, double& depth) const;
  [[nodiscard]] bool can_be_filled(int face) const;
  [[nodiscard]] PrismTets prism(int face) const;
  [[nodiscard]] bool well_shaped(int face, double part) const;
  [[nodiscard]] std::span<const int> faces_around(int v) const;
  void gather_faces();
  void set_offset(int v);
  void shorten(int v, double offset);
  void smooth();
  void shrink_folded();
  void pinch_folded();
  void set_depths();

  const MeshIndex& index_;
  const TriMesh& mesh_;
  double thickness_;
  std::vector<PadDirection> inward_;
  std::vector<double> offset_, full_;  ///< per vertex: length of the offset, and what it would be without limits [m]
  std::vector<double> depth_;          ///< per vertex; negative where the offset changed since
  std::vector<char> pinched_;          ///< the inner vertex is the skin's own
  std::vector<int> first_face_, faces_at_;  ///< faces around v: faces_at_ from first_face_[v] to first_face_[v + 1]
  std::vector<double> steepest_;            ///< at 3 face + c: how much offsets may differ along the edge from corner c
  std::vector<int> shortened_;              ///< vertices whose neighbours' offsets are still to be compared
};

}  // namespace taxel
