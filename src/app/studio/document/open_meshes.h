// The meshes that a document has been on, as they were read: undo brings back the mesh that there was, whatever its
// file holds by now.
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

/// A mesh as read, and what is to be said about it.
struct OpenMesh {
  LoadedMesh loaded;
  MeshFindings findings;
};
using OpenMeshPtr = std::shared_ptr<const OpenMesh>;

/// Reads a mesh and looks it over. Throws Error as load_mesh does, or Cancelled.
OpenMeshPtr read_open_mesh(const MeshRef& mesh, Progress* progress = nullptr);

/// Whether two references read the same mesh, however that is repaired.
inline bool same_file(const MeshRef& a, const MeshRef& b) {
  return a.file == b.file && a.scale == b.scale && a.sha256 == b.sha256;
}

/// From any thread.
class OpenMeshes {
 public:
  void clear();
  /// What this reference means from now on, whatever its repair.
  void add(const MeshRef& ref, OpenMeshPtr mesh);
  /// Null: it was not read yet.
  [[nodiscard]] OpenMeshPtr known(const MeshRef& ref) const;
  /// The same; what is not known is read from its file.
  OpenMeshPtr get(const MeshRef& ref);

 private:
  /// So many are kept: the newest.
  static constexpr std::size_t kMost = 16;
  mutable std::mutex mutex_;  // guards the rest
  std::vector<std::pair<MeshRef, OpenMeshPtr>> meshes_;
};

}  // namespace taxel::studio
