// One or two layers of prisms between the skin of a pad and its inner vertices.
#pragma once

#include <vector>

#include "core/base/index.h"
#include "core/hydro/pad/pad_shape.h"

namespace taxel {

/// Where a leg has a middle vertex, the prisms around it are cut there: an outer one from the skin to the middle
/// vertices, an inner one from these to the inner vertices. At a leg without one the inner prism ends in a point, on
/// the inner vertex itself: so a prism of one layer and one of two, or two of them, share their sides. The same holds
/// for the gaps between faces that part.
class PadLayers {
 public:
  /// A leg that is `asked` for (one flag per leg) gets a middle vertex at a part of its length. Around it the middle
  /// vertices go down to the inner ones, at 45 degrees or less, so that prisms stay well shaped; where they would not,
  /// their legs have none. Cost: a closest-point query per middle vertex.
  PadLayers(const PadShape& shape, const MeshIndex& index, const std::vector<char>& asked);

  /// Number of a leg's middle vertex, after those of the skin and the inner ones; -1 where it has none.
  [[nodiscard]] int middle(int leg) const { return middle_[at(leg)]; }
  /// Of the middle vertices, in the order of their numbers.
  [[nodiscard]] const std::vector<int>& legs() const { return legs_; }
  /// How far along its leg the middle vertex lies [m].
  [[nodiscard]] double height(int leg) const { return height_[at(leg)]; }
  /// Distance of the middle vertex to the skin [m].
  [[nodiscard]] double depth(int leg) const { return depth_[at(leg)]; }
  /// All tets of the pad, of positive volume.
  [[nodiscard]] const std::vector<ivec4>& tets() const { return tets_; }
  /// Whether nothing lies below a face.
  [[nodiscard]] bool bare(int face) const { return single_[at(face)].count == 0; }
  /// Faces below which the prism has two layers, at one of its legs or more.
  [[nodiscard]] int two_layer_faces() const { return two_layer_faces_; }

 private:
  [[nodiscard]] bool has(int leg) const { return middle_[at(leg)] >= 0; }
  [[nodiscard]] int top(int leg) const { return has(leg) ? middle_[at(leg)] : shape_.inner(leg); }
  [[nodiscard]] std::array<dvec3, 4> corners(const ivec4& tet) const;
  void spread(const std::vector<char>& asked);
  void place(const MeshIndex& index);
  [[nodiscard]] PrismTets below(const ivec3& legs) const;
  [[nodiscard]] bool add_face(int face);
  [[nodiscard]] bool add_gap(std::vector<ivec4> outer, const std::vector<ivec3>& floor);
  bool cut();
  void number();

  const PadShape& shape_;
  const TriMesh& mesh_;
  std::vector<PrismTets> single_;  ///< per face: its prism in one layer
  std::vector<double> height_, depth_;
  std::vector<int> middle_;
  std::vector<int> legs_;
  std::vector<ivec4> tets_;
  int two_layer_faces_ = 0;
};

}  // namespace taxel
