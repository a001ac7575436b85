// The worker thread that compiles what is edited: the newest layout wins, so that a drag is followed as fast as models
// can be built, and nobody waits for those in between.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "app/studio/document/open_meshes.h"
#include "core/document/project.h"
#include "core/sensor/sensor_model.h"

namespace taxel::studio {

/// What is to be compiled.
struct ModelJob {
  std::uint64_t number = 0;  ///< given by who asks
  ProjectPtr project;
  std::shared_ptr<OpenMeshes> meshes;  ///< where that of the project is found, or else kept
  std::string file;                    ///< names the layout in messages
};

/// What came of it.
struct BuiltModel {
  std::uint64_t number = 0;  ///< of the job
  SensorModelPtr model;      ///< null: see `problem`
  std::string problem;       ///< why the layout cannot be compiled, or simulated
};

class ModelWorker {
 public:
  using Built = std::function<void(const SensorModelPtr&)>;
  /// `wake` is called from the worker when there is something to take, and before it `built` with each model.
  ModelWorker(SensorCache& cache, std::function<void()> wake, Built built = {});
  ~ModelWorker();  ///< cancels and waits
  ModelWorker(const ModelWorker&) = delete;
  ModelWorker& operator=(const ModelWorker&) = delete;

  /// A preview of it comes first where polished samples are not at hand, and then the same polished. A job that has not
  /// begun is dropped for this one, a preview under way is finished and told unless it repairs the mesh in another way,
  /// which may take seconds; polishing is cancelled.
  void build(ModelJob job);
  void clear();  ///< no job any more: nothing that was asked for is told
  /// The newest result, once.
  std::optional<BuiltModel> take();
  void wait();                            ///< until take() has something, or nothing is to be done
  [[nodiscard]] bool busy() const;        ///< something is built, or lies ready
  [[nodiscard]] bool polishing() const;   ///< the samples of what was told last
  [[nodiscard]] double fraction() const;  ///< of polishing

 private:
  void run();
  void compile(const ModelJob& job, std::unique_lock<std::mutex>& lock);
  /// Without the lock; null: cancelled.
  std::optional<BuiltModel> attempt(const ModelJob& job, SampleQuality quality, Progress& progress);

  SensorCache& cache_;
  std::function<void()> wake_;
  Built built_;
  mutable std::mutex mutex_;  // guards the rest
  std::condition_variable asked_, told_;
  std::optional<ModelJob> next_;
  std::optional<BuiltModel> ready_;
  std::shared_ptr<Progress> preview_;  ///< of the preview under way
  RepairRecipe repair_;                ///< by which it repairs the mesh
  std::shared_ptr<Progress> polish_;   ///< of the polishing under way
  std::uint64_t dropped_ = 0;          ///< counts clear(): what began before is not told
  bool working_ = false, ending_ = false;
  std::thread thread_;
};

}  // namespace taxel::studio
