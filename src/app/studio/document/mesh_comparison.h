// A mesh that is open and was replaced on disk: read again in a thread of its own, and compared with what is edited.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "app/studio/document/open_meshes.h"
#include "core/document/moved_surface.h"

namespace taxel::studio {

struct ComparedMesh {
  MeshRef ref;                            ///< with the hash of what was read
  OpenMeshPtr mesh;                       ///< null: see `failure`
  std::shared_ptr<const MeshIndex> skin;  ///< that would be sampled
  SurfaceDistances distances;             ///< of the taxels as they were when this began
  std::string failure;                    ///< why it could not be read
};

/// The same for a mesh that is there already.
ComparedMesh compare_mesh(const MeshRef& ref, const OpenMeshPtr& mesh, const Layout& layout);

class MeshComparison {
 public:
  MeshComparison() = default;
  ~MeshComparison();  ///< cancels and waits
  MeshComparison(const MeshComparison&) = delete;
  MeshComparison& operator=(const MeshComparison&) = delete;

  /// Drops what still runs.
  void start(const Layout& layout);
  void cancel();
  [[nodiscard]] bool busy() const { return job_ != nullptr; }
  void wait() const;  ///< until take() has something, or nothing runs
  std::optional<ComparedMesh> take();

 private:
  struct Job;
  std::shared_ptr<Job> job_;
};

}  // namespace taxel::studio
