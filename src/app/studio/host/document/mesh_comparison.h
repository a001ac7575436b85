// Reads an open mesh again that was replaced on disk, and compares it with the edited layout, on a worker.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/studio/host/document/open_meshes.h"
#include "app/studio/host/jobs/newest_wins.h"
#include "core/document/moved_surface.h"

namespace taxel::studio {

struct ComparedMesh {
  MeshRef ref;                            ///< reference with the hash of the file that was read
  OpenMeshPtr mesh;                       ///< the mesh, or null if `problem` is set
  std::shared_ptr<const MeshIndex> skin;  ///< surface that would be sampled
  SurfaceDistances distances;             ///< distances of the taxels when the comparison began
  std::string problem;                    ///< reason why the file cannot be read, or empty
};

/// Compares a mesh that is already read.
ComparedMesh compare_mesh(const MeshRef& ref, const OpenMeshPtr& mesh, const Layout& layout);

class MeshComparison {
 public:
  explicit MeshComparison(JobExecutor& executor);

  /// Drops what still runs.
  void start(const Layout& layout);
  /// Whether a comparison runs or was not taken yet.
  [[nodiscard]] bool busy() const { return slot_.posted().has_value(); }
  /// Waits until no comparison runs.
  void wait() const { slot_.wait(); }
  /// The result, once.
  std::optional<ComparedMesh> take();

 private:
  NewestWins<std::shared_ptr<const Layout>, ComparedMesh> slot_;
};

}  // namespace taxel::studio
