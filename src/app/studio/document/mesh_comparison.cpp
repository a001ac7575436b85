#include "app/studio/document/mesh_comparison.h"

#include <condition_variable>

#include "core/sensor/sensor_cache.h"

namespace taxel::studio {

struct MeshComparison::Job {
  Layout layout;
  Progress progress;
  std::mutex mutex;  // guards the next two
  std::condition_variable news;
  std::optional<ComparedMesh> result;
  bool ended = false;
  std::thread thread;

  ~Job() {
    progress.cancel();
    if (thread.joinable()) thread.join();
  }
  void run() {
    std::optional<ComparedMesh> compared;
    try {
      OpenMeshPtr mesh = read_open_mesh(layout.mesh, &progress);
      MeshRef ref = layout.mesh;
      ref.sha256 = mesh->loaded.sha256;
      compared = compare_mesh(ref, mesh, layout);
    } catch (const Cancelled&) {
      return;
    } catch (const std::exception& error) {
      compared = ComparedMesh{layout.mesh, nullptr, nullptr, {}, error.what()};
    }
    const std::lock_guard lock(mutex);
    result = std::move(compared);
    ended = true;
    news.notify_all();
  }
};

ComparedMesh compare_mesh(const MeshRef& ref, const OpenMeshPtr& mesh, const Layout& layout) {
  const SensorSkinPtr skin = make_sensor_skin(mesh->loaded.mesh, layout.sampling.shells);
  return {ref, mesh, skin->sensed, distances_to(*skin->sensed, layout), ""};
}

MeshComparison::~MeshComparison() = default;

void MeshComparison::start(const Layout& layout) {
  job_ = std::make_shared<Job>();
  job_->layout = layout;
  job_->thread = std::thread([job = job_.get()] { job->run(); });
}

void MeshComparison::cancel() {
  job_.reset();
}

void MeshComparison::wait() const {
  if (!job_) return;
  std::unique_lock lock(job_->mutex);
  job_->news.wait(lock, [this] { return job_->ended; });
}

std::optional<ComparedMesh> MeshComparison::take() {
  if (!job_) return std::nullopt;
  std::optional<ComparedMesh> result;
  {
    const std::lock_guard lock(job_->mutex);
    if (!job_->ended) return std::nullopt;
    result = std::move(job_->result);
  }
  job_.reset();
  return result;
}

}  // namespace taxel::studio
