// A probe with the shape of a mesh.
#pragma once

#include "core/sensor/probe/shapes/probe_form.h"

namespace taxel {

/// A closed mesh that is pressed along its -z. The tip is the middle of the box around its lowest vertices.
struct ProbeMesh {
  static constexpr const char *kWord = "mesh", *kLabel = "Mesh file";
  static constexpr bool kIsRound = false;
  static constexpr FieldKind kField = FieldKind::pad;
  TriMeshPtr mesh;        ///< meshes are equal if they are the same object
  std::string file = {};  ///< file that the window reads `mesh` from

  template <class V>
  void visit(const V& v) {
    v(FieldSpec{"file", "File", "Path of a closed mesh, which is pressed along its -z", FieldQuantity::file}, file);
  }
  void shrink_to(double /*radius*/) {}
  /// Throws Error if the mesh has no triangles, is open, or is inside out.
  [[nodiscard]] ProbeForm body() const;
  bool operator==(const ProbeMesh&) const = default;
};

}  // namespace taxel
