// Compiles the edited layout on a worker: the newest layout wins, so that models follow a drag without delay.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/studio/host/document/open_meshes.h"
#include "app/studio/host/jobs/newest_wins.h"
#include "core/document/project.h"
#include "core/sensor/sensor_model.h"

namespace taxel::studio {

/// A layout to compile.
struct ModelInput {
  std::uint64_t number = 0;  ///< unique number, given by the caller
  ProjectPtr project;
  std::shared_ptr<OpenMeshes> meshes;  ///< read meshes, to which the mesh of the project is added if it is absent
  std::string file;                    ///< name of the layout in messages
  SampleQuality quality = SampleQuality::preview;
  bool operator==(const ModelInput& other) const { return number == other.number && quality == other.quality; }
};

struct BuiltModel {
  std::uint64_t number = 0;  ///< number of the input
  SensorModelPtr model;      ///< the model, or null if `problem` is set
  std::string problem;       ///< reason why the layout cannot be compiled or simulated, or empty
};

class ModelSlot {
 public:
  using Built = std::function<void(const SensorModelPtr&)>;
  /// `built` is called on the worker with each model, before take() has it.
  ModelSlot(JobExecutor& executor, SensorCache& cache, Built built = {});

  /// Compiles a preview of the layout and, once that was taken, the same layout with polished samples, unless the cache
  /// had them. An input that has not begun is dropped. A preview under way is finished, unless it repairs the mesh in
  /// another way, which may take seconds; polishing is cancelled.
  void build(ModelInput input);
  /// Cancels everything; take() returns nothing of earlier inputs.
  void clear() { slot_.post(std::nullopt, Superseded::cancel); }
  /// The newest result, once.
  std::optional<BuiltModel> take();
  /// Waits until no model is compiled.
  void wait() const { slot_.wait(); }
  /// Whether a model is compiled or was not taken yet.
  [[nodiscard]] bool busy() const { return slot_.busy() || slot_.posted(); }
  /// Whether the samples of the model that was taken last are polished.
  [[nodiscard]] bool polishing() const;
  /// Finished fraction of polishing.
  [[nodiscard]] double fraction() const { return polishing() ? slot_.fraction() : 0; }

 private:
  NewestWins<ModelInput, BuiltModel> slot_;
};

}  // namespace taxel::studio
