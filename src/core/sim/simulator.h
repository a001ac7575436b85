// A MuJoCo model with its tactile sensors, stepped deterministically. It has no threads and no clock: the command line
// runs it in a loop, and SimThread runs it in a thread.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/document/batch/scene_job.h"
#include "core/document/scenario/scenario.h"
#include "core/layout/user_choices.h"
#include "core/run/frame.h"
#include "core/run/lead.h"
#include "core/run/step.h"
#include "core/sensor/readout/reading.h"
#include "core/sim/sensor_times.h"

namespace taxel {

struct SceneFiles;

/// A scene with its sensors. Belongs to one thread.
class Simulator {
 public:
  /// Builds the scene of a scenario for any compiled layout: a mocap body moves the sensor, which touches the object of
  /// the scenario. Throws Error as build_scenario_scene() does.
  static std::unique_ptr<Simulator> make_scenario(const SensorModelPtr& model, const Scenario& scenario);
  /// Loads an MJCF file with the sensors that it declares, and attaches layouts to other geoms. `readout` replaces
  /// the aggregate and the method of every layout. `geoms` get other shapes. Throws Error that names the file and
  /// MuJoCo's reason, and the errors of change_geoms().
  static std::unique_ptr<Simulator> load(const std::filesystem::path& scene,
                                         const std::vector<SceneAttachment>& attachments = {},
                                         const ReadoutChoice& readout = {}, const std::vector<GeomChange>& geoms = {});
  ~Simulator();
  Simulator(const Simulator&) = delete;
  Simulator& operator=(const Simulator&) = delete;

  /// Returns the warnings of the sensors about the scene, for example that a mesh differs from the mesh of the layout,
  /// or that MuJoCo computes a contact a second time.
  [[nodiscard]] std::vector<std::string> warnings() const;

  /// Returns the repairs of the meshes that sensors touch, one sentence for each sensor and geom.
  [[nodiscard]] std::vector<std::string> repairs() const;

  /// Returns the wall times of all sensors since the start.
  [[nodiscard]] SensorTimes sensor_times() const;

  /// Makes one mj_step; view() and fill_frame() then return the state that was evaluated, before its integration. In a
  /// scenario they read the sensors first, so that steps that nobody views cost no readings.
  /// Throws Error with the body's name if MuJoCo computed a number that is not finite: the state is then lost until
  /// restore_state() or reset().
  void step();
  /// Replaces the model `replaced` of sensors, and reads the present state again. Throws Error if `model` has another
  /// number of taxels; the sensors then stay as they are.
  void replace_model(const SensorModelPtr& replaced, const SensorModelPtr& model);
  /// Changes the scene between two steps, and evaluates the changed state if geoms may have moved.
  void edit(const SceneEdit& edit);
  /// Starts a run at a keyframe. Returns false if the scene has no keyframe of that number.
  bool load_keyframe(int keyframe);
  /// Leads controls and mocap bodies over the time since the start of the run, in each step before it is made; null
  /// ends this. The values stay in reset(), load_keyframe() and restore_state(). The present state is evaluated again.
  void lead(SceneLeadPtr lead);
  void reset();                         ///< returns to the initial state, bit for bit
  [[nodiscard]] bool finished() const;  ///< the end of the scenario is reached
  [[nodiscard]] bool row_due() const;   ///< the latest step belongs to a recorded row
  /// Copies the latest step with the controls and the dragged body. `hits` is as in fill_step().
  void fill_frame(SimFrame& frame, FilledHits& hits) const;
  /// Returns the latest step without copies. The view is valid until the next step, reset or model.
  [[nodiscard]] StepView view() const;
  void view(StepView& view) const;  ///< reuses the memory of `view`
  /// Saves the state after the latest step, from which restore_state() continues. Reuses the memory of `state`.
  void save_state(SimState& state) const;
  /// Restores a state of this simulator. The next step() is then the same, bit for bit; view() still returns the latest
  /// step. Throws Error if the state does not belong to the scene.
  void restore_state(const SimState& state);
  [[nodiscard]] ControlValues controls_of(const SimState& state) const;  ///< controls in a state of this simulator
  [[nodiscard]] const std::shared_ptr<const SimScene>& scene() const;

  /// Returns the contact of a sensor of scene()->sensors at given poses, with one surface for each body that the sensor
  /// can touch. The same poses give the same bits as step(). `sensors` has X_WM of all sensors, `X_WG` the poses of all
  /// scene()->geoms. Poses have no velocities and no time: force_W, motions, shear and time are left empty. Throws
  /// Error if the sensor touches a moving geom that is not in scene()->geoms.
  [[nodiscard]] SensorStep contact_at(std::size_t sensor, std::span<const Pose> sensors,
                                      std::span<const Pose> X_WG) const;

  /// Returns the scene as files that any program with the plugin can run. The mesh and layout files are next to the
  /// scene, or in `folder` if it is not empty. Throws Error if a file cannot be read.
  [[nodiscard]] SceneFiles files(const std::string& folder = "") const;
  /// Returns the present pose of the first mocap body, or the identity if there is none.
  [[nodiscard]] Pose mocap_pose() const;

 private:
  friend SceneFiles patched_files(const Simulator& simulator, const std::filesystem::path& output);
  Simulator();
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Writes scene.xml with its mesh and layout files into `folder`. Throws the errors of files() and write_scene().
void export_scene(const Simulator& simulator, const std::filesystem::path& folder);
/// Returns the file of the scene as it is on disk with additions for the attached layouts, and the files of edited
/// layouts in place of those that the scene declares, to be written as `output` (scene/scene_patch.h). Throws Error
/// with the reason if that is not possible.
SceneFiles patched_files(const Simulator& simulator, const std::filesystem::path& output);
/// Writes FILE.xml as patched_files() returns it, with the layouts next to it. If the scene cannot be patched,
/// writes all of it again, and the files that it needs into a folder FILE_files, and returns a note with the reason;
/// otherwise returns an empty text. Throws as export_scene() does.
std::string save_scene(const Simulator& simulator, const std::filesystem::path& file);

}  // namespace taxel
