// One or two layers of prisms between the skin of a pad and its inner vertices.
#pragma once

#include <vector>

#include "core/base/index.h"
#include "core/hydro/pad/pad_shape.h"

namespace taxel {

/// The layers of a pad. If an offset vector (leg) has a middle vertex, the prisms around it are divided into an outer
/// prism, from the skin to the middle vertices, and an inner prism, from the middle vertices to the inner vertices. At
/// a leg without a middle vertex, the inner prism ends in a point at the inner vertex, so adjacent prisms share their
/// sides whether they have one layer or two. Gaps between faces whose normals diverge are divided in the same way.
class PadLayers {
 public:
  /// Each leg whose flag in `asked` is set gets a middle vertex at a fraction of its length. Around it, the middle
  /// vertices descend to the inner vertices at 45 degrees or less, so that prisms are well shaped; legs whose prisms
  /// would not be have no middle vertex. Cost: a closest-point query per middle vertex.
  PadLayers(const PadShape& shape, const MeshIndex& index, const std::vector<char>& asked);

  /// Returns the index of a leg's middle vertex, or -1. The indices follow those of the skin and of the inner vertices.
  [[nodiscard]] int middle(int leg) const { return middle_[at(leg)]; }
  /// Returns the legs of the middle vertices, in the order of their indices.
  [[nodiscard]] const std::vector<int>& legs() const { return legs_; }
  /// Returns the distance of the middle vertex along its leg [m].
  [[nodiscard]] double height(int leg) const { return height_[at(leg)]; }
  /// Returns the distance of the middle vertex to the skin [m].
  [[nodiscard]] double depth(int leg) const { return depth_[at(leg)]; }
  /// Returns all tets of the pad. Their volumes are positive.
  [[nodiscard]] const std::vector<ivec4>& tets() const { return tets_; }
  /// Returns true if a face has no prism below it.
  [[nodiscard]] bool bare(int face) const { return single_[at(face)].count == 0; }
  /// Returns the number of faces whose prism has two layers at one leg or more.
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
  std::vector<PrismTets> single_;  ///< for each face, its prism with one layer
  std::vector<double> height_, depth_;
  std::vector<int> middle_;
  std::vector<int> legs_;
  std::vector<ivec4> tets_;
  int two_layer_faces_ = 0;
};

}  // namespace taxel
