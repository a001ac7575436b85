// The field of a pad beyond its tets: p = (E/H) D(x), where D is the distance to the skin, positive inside. The tets
// approximate this field near the skin (docs/theory/hydro.md, "Beyond the tets").
#pragma once

#include <memory>
#include <mutex>

#include "core/mesh/query/nearest.h"

namespace taxel {

class DepthField {
 public:
  /// Sets the field of a pad of thickness H [m] and stiffness E/H [Pa/m] below a closed skin.
  DepthField(TriMeshPtr skin, double thickness, double stiffness)
      : skin_(std::move(skin)), thickness_(thickness), stiffness_(stiffness) {}

  struct Sample {
    double depth = 0;   ///< D(x): the distance to the skin, negative outside [m]
    dvec3 gradient{0};  ///< gradient of D: a unit vector that points inward
  };
  /// Returns D at x, frame of the body. `within` is an upper bound of the distance to the skin: it shortens the search
  /// and does not change the result. O(log n).
  [[nodiscard]] Sample at(const dvec3& x, double within = std::numeric_limits<double>::infinity()) const;
  /// Returns the same, faster where many queries are close to each other. `near` is a result of near_faces().
  [[nodiscard]] static Sample at(const dvec3& x, NearFaces& near);
  /// Returns the memory of queries of one thread. This field must outlive it.
  [[nodiscard]] NearFaces near_faces() const;

  [[nodiscard]] const TriMeshPtr& skin() const { return skin_; }
  [[nodiscard]] double thickness() const { return thickness_; }
  [[nodiscard]] double stiffness() const { return stiffness_; }

 private:
  /// Returns the tree of the skin. It is built by the first query, so bodies that are never pressed so deep do not need
  /// it.
  [[nodiscard]] const MeshIndex& index() const;

  TriMeshPtr skin_;
  double thickness_, stiffness_;
  mutable std::once_flag built_;
  mutable std::unique_ptr<const MeshIndex> index_;
};

using DepthFieldPtr = std::shared_ptr<const DepthField>;

}  // namespace taxel
