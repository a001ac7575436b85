// A MuJoCo model with its tactile sensors, stepped deterministically. No threads, no clock: the command line runs it in
// a loop, sim_thread runs the same in a thread.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/document/scenario/scenario.h"
#include "core/run/frame.h"
#include "core/run/history/step_view.h"
#include "core/sensor/readout/reading.h"
#include "core/sim/sensor_times.h"

namespace taxel {

class Simulator {
 public:
  /// A scenario around any compiled layout: the finger is led, and meets the scenario's object.
  static std::unique_ptr<Simulator> make_scenario(const SensorModelPtr& model, const Scenario& scenario);
  /// Any MJCF with the sensors it declares, and layouts attached to others of its geoms. `aggregate`, where given, goes
  /// over that of every layout.
  /// Throws Error that names the file and MuJoCo's reason.
  static std::unique_ptr<Simulator> load(const std::filesystem::path& scene,
                                         const std::vector<SceneAttachment>& attachments = {},
                                         std::optional<Aggregate> aggregate = std::nullopt);
  ~Simulator();
  Simulator(const Simulator&) = delete;
  Simulator& operator=(const Simulator&) = delete;

  /// What the sensors have to say about the scene: another mesh than the layout's, contacts doubled by MuJoCo's own,
  /// ...
  [[nodiscard]] std::vector<std::string> warnings() const;

  /// Where the time of all sensors went so far.
  [[nodiscard]] SensorTimes sensor_times() const;

  /// Makes one mj_step; view() and fill_frame() then return the state that was evaluated, before its integration.
  /// Throws Error with the body's name if MuJoCo computed a number that is not finite: the state is then lost until
  /// restore_state() or reset().
  void step();
  /// All sensors that read by `replaced` read the present state anew, by `model`. Throws Error where it has another
  /// number of taxels; the sensors then stay as they are.
  void replace_model(const SensorModelPtr& replaced, const SensorModelPtr& model);
  /// Sets what a hand asks for, between two steps; what moves is seen at once, and sensed.
  void edit(const SceneEdit& edit);
  /// Goes to a keyframe, as a start of its own. False: the scene has none of that number.
  bool load_keyframe(int keyframe);
  void reset();                         ///< back to the start, bit for bit
  [[nodiscard]] bool finished() const;  ///< the scenario's path has been run
  [[nodiscard]] bool row_due() const;   ///< the step just made belongs to a recorded row
  void fill_frame(SimFrame& frame) const;
  void fill_frame(SimFrame& frame, FilledHits& hits) const;  ///< see step_view.h
  /// The same without copies: valid until the next step, reset or model.
  [[nodiscard]] StepView view() const;
  void view(StepView& view) const;  ///< keeps the memory of `view`
  /// The state after the step just made, to go on from. Keeps the memory of `state`.
  void save_state(SimState& state) const;
  /// Goes back to a state of this simulator. The sensors still show what they sensed last: the next step() is as it
  /// was.
  void restore_state(const SimState& state);
  [[nodiscard]] ControlValues controls_of(const SimState& state) const;  ///< in a state of this simulator
  [[nodiscard]] Pose pose_of_geom(int geom) const;  ///< X_WG of scene()->geoms[geom], as fill_frame() gives it
  [[nodiscard]] const std::shared_ptr<const SimScene>& scene() const;

  /// Returns the contact of a sensor of scene()->sensors at given poses, with one surface for each body that the sensor
  /// can touch. The same poses give the same bits as step(). `sensors` has X_WM of all sensors, `X_WG` the poses of all
  /// scene()->geoms. Poses have no velocities and no time: force_W, motions, shear and time are left empty. Throws
  /// Error if the sensor touches a moving geom that is not in scene()->geoms.
  [[nodiscard]] SensorStep contact_at(std::size_t sensor, std::span<const Pose> sensors,
                                      std::span<const Pose> X_WG) const;

  /// Writes scene.xml with its mesh and layout files into `folder`, so that the folder runs elsewhere with the plugin.
  void export_scene(const std::filesystem::path& folder) const;
  /// The same as FILE.xml with what it needs in a folder FILE_files beside it.
  void save_scene(const std::filesystem::path& file) const;
  [[nodiscard]] dvec3 mocap_pos() const;
  [[nodiscard]] dquat mocap_quat() const;
  [[nodiscard]] Pose mocap_in(const SimState& state) const;  ///< both of a state of this simulator

 private:
  Simulator();
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace taxel
