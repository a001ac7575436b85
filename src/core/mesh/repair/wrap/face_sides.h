// The sides of the faces of a broken surface: which of them are inside of a body.
#pragma once

#include <optional>
#include <vector>

#include "core/mesh/repair/wrap/winding_number.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

enum class FaceSides : char {
  skin,          ///< the body is behind the face and ends there
  both_inside,   ///< a wall within the body
  both_outside,  ///< a face that winds around nothing
  unknown        ///< faces cross or end here: the winding number of each point decides
};

/// Finds the sides of faces. Between crossing faces and rims the winding number on a side of the surface is constant if
/// the surface is closed, so one face answers for all that are connected to it; if it has rims, the mean of some faces
/// does. It is computed when the first of these faces is asked for. Not for two threads at once.
class FaceSideFinder {
 public:
  /// `crosses` has a nonzero entry for each face that crosses another one. The mesh and its winding number must outlive
  /// this object. O(n).
  FaceSideFinder(const TriMesh& mesh, std::vector<char> crosses, const WindingNumber& winding);

  [[nodiscard]] FaceSides sides_of(int face);

 private:
  [[nodiscard]] FaceSides sides_of_patch(const std::vector<int>& patch) const;

  const TriMesh& mesh_;
  const WindingNumber& winding_;
  std::vector<int> patch_of_face_;               ///< patch of each face, or -1 if its sides are unknown
  std::vector<std::vector<int>> patches_;        ///< faces of each patch, ascending
  std::vector<std::optional<FaceSides>> sides_;  ///< sides of each patch, if they are known
};

}  // namespace taxel
