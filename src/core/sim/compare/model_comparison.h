// Readings of one step by other models of a taxel, for comparison. They have no influence on the simulation.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/run/step.h"
#include "core/sensor/compare.h"
#include "core/sim/mujoco_handles.h"

namespace taxel {

/// Readings of MuJoCo's own tactile sensors for all taxels, in layout order.
struct MujocoReadings {
  std::vector<double> depth;  ///< `<tactile>`: mean depth over the taxel's field [m]
  std::vector<double> touch;  ///< `<touch>`: force in a sphere at the taxel's centre, of the taxel's radius [N]
};

/// A small MuJoCo model of one sensor and the bodies that it touches, which shares nothing with the running scene. The
/// sensor's skin is on a body that slides but does not turn, and MuJoCo uses the convex hull of the skin. The touched
/// bodies are mocap bodies.
///
/// Depth: MuJoCo's signed distance to the other body, at the vertices of a mesh; 0 where MuJoCo finds no contact. If
/// there are several bodies, the deepest counts. The vertices are samples of the taxel, at most kMostVertices, or its
/// centre if it has no samples. The reading is the mean over the vertices, with the weights of the taxel's field.
/// Meshes get an octree of distances (mjsMesh.needsdf).
///
/// Touch: the poses are those of the hydroelastic contact, so MuJoCo's own compliance (solref) has no influence. The
/// constraints of each pair carry, without friction and at rest (solref -0 -0), the force of the contact's elastic
/// pressure. MuJoCo decides where the contact points are, and its solver how the force is shared among them.
class MujocoSensors {
 public:
  /// Builds the model. Throws Error with MuJoCo's reason if a shape cannot be compiled.
  MujocoSensors(const SensorModel& model, const std::vector<TouchedBody>& touched,
                const std::vector<SensorModelPtr>& sensors);

  /// Returns the readings for the pose X_WM of the sensor's mesh frame and the poses X_WB of the bodies, parallel to
  /// `touched`. `load_W` has the force of each body on the sensor [N], zero without contact. The result depends on
  /// these arguments only.
  [[nodiscard]] MujocoReadings read(const Pose& X_WM, const std::vector<Pose>& X_WB, const std::vector<dvec3>& load_W);

 private:
  static constexpr std::size_t kMostVertices = 64;
  /// A vertex of the tactile mesh.
  struct Vertex {
    dvec3 at{0};
    std::size_t taxel = 0;
    double share = 0;  // fraction of the taxel's weights
  };
  void add_taxel_mesh(mjSpec* spec, const SensorModel& model);
  void place(const Pose& X_WM, const std::vector<Pose>& X_WB);
  void add_pair(std::size_t body, const dvec3& load_W, std::vector<double>& depths, MujocoReadings& out);

  std::size_t taxels_ = 0;
  std::vector<Vertex> vertices_;
  ModelHandle model_;
  DataHandle data_;
  int sensor_body_ = 0;
  std::vector<int> geoms_, mocaps_;  // parallel to `touched`; -1 for a body that cannot be touched
  int depths_ = 0, touches_ = 0;     // index of their first values in sensordata
};

/// Comparison of the models for one sensor of a scene. May be used by one thread at a time.
class ModelComparison {
 public:
  /// Compiles the sensor's layout with a star-shaped field, and its bodies for MuJoCo. If a model cannot be built, its
  /// readings have the reason. Throws Error if the scene has no such sensor, and throws Cancelled.
  ModelComparison(std::shared_ptr<const SimScene> scene, std::size_t sensor, Progress* progress = nullptr);
  ~ModelComparison();
  ModelComparison(const ModelComparison&) = delete;
  ModelComparison& operator=(const ModelComparison&) = delete;

  [[nodiscard]] const std::shared_ptr<const SimScene>& scene() const { return scene_; }
  [[nodiscard]] std::size_t sensor() const { return sensor_; }

  /// Returns the readings of a step of the scene by all models of kReadingModels, in their order. The result depends on
  /// the step only.
  [[nodiscard]] ModelReadings read(const StepView& step);

 private:
  [[nodiscard]] ModelReading read_star(const StepView& step) const;
  [[nodiscard]] ModelReading read_exact(const SensorView& view) const;
  void read_mujoco(const StepView& step, ModelReading& depth, ModelReading& touch);

  std::shared_ptr<const SimScene> scene_;
  std::size_t sensor_;
  SensorModelPtr star_;
  std::string no_star_, no_mujoco_;  // reasons why a model could not be built; empty if it was
  std::unique_ptr<MujocoSensors> mujoco_;
};

}  // namespace taxel
