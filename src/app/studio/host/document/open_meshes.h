// Meshes of an open document, as they were read. Undo restores an earlier mesh even if its file has changed since.
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/layout/layout.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/topology/mesh_report.h"

namespace taxel::studio {

/// A mesh as read, and the findings about it.
struct OpenMesh {
  LoadedMesh loaded;
  MeshFindings findings;
};
using OpenMeshPtr = std::shared_ptr<const OpenMesh>;

/// Reads and inspects a mesh. Throws Error as load_mesh() does, or Cancelled.
OpenMeshPtr read_open_mesh(const MeshRef& mesh, Progress* progress = nullptr);

/// Returns whether two references read the same mesh, whatever their repair.
inline bool same_file(const MeshRef& a, const MeshRef& b) {
  return a.file == b.file && a.scale == b.scale && a.sha256 == b.sha256;
}

/// Meshes by reference. All functions may be called from any thread.
class OpenMeshes {
 public:
  void clear();
  /// Sets the mesh of this reference from now on, whatever its repair.
  void add(const MeshRef& ref, OpenMeshPtr mesh);
  /// Returns the mesh of this reference, or null if it was not read yet.
  [[nodiscard]] OpenMeshPtr known(const MeshRef& ref) const;
  /// Returns the mesh of this reference, and reads it from its file if it is not known. Throws Error as load_mesh()
  /// does.
  OpenMeshPtr get(const MeshRef& ref);

 private:
  /// Maximum number of meshes that are retained: the newest ones.
  static constexpr std::size_t kMost = 16;
  mutable std::mutex mutex_;  // guards the rest
  std::vector<std::pair<MeshRef, OpenMeshPtr>> meshes_;
};

}  // namespace taxel::studio
