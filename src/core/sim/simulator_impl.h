// The members of a simulator: the compiled scene, MuJoCo's data, and the state of the run.
#pragma once

#include <map>
#include <optional>

#include "core/sim/model/scene_view.h"
#include "core/sim/plugin/plugin_table.h"
#include "core/sim/scene/loaded_scene.h"
#include "core/sim/scene/scenario_scene.h"
#include "core/sim/simulator.h"

namespace taxel {

struct Simulator::Impl {
  std::string title;  // name of the scene in messages: its file
  CompiledScene compiled;
  std::vector<SceneAttachment> attachments;  // those that the scene was loaded with
  DataHandle data;
  std::optional<ScenarioScene> scenario;
  std::vector<BodyId> bodies;                             // of scene->sensors: sensors, then soft geoms without taxels
  std::vector<SensorModelPtr> bare_models;                // models of soft geoms without taxels
  std::vector<std::shared_ptr<const Shape>> bare_shapes;  // shapes of their bodies
  std::vector<int> drawn;                                 // geoms of scene->geoms
  std::map<int, std::shared_ptr<const Shape>> shapes;     // of geoms that sensors touch
  std::shared_ptr<const SimScene> shown;                  // description of the scene
  int mocap = -1;                                         // index of the first mocap body, or -1
  dvec3 mocap_start{0};
  Perturbation perturbation;
  SceneLeadPtr lead;  // values that lead the scene, or null

  std::uint64_t steps = 0;      // number of steps of the run
  double time = 0, travel = 0;  // values of the state that was evaluated last
  bool row_due = false;
  std::vector<HydroInstance*> unread;  // scratch memory

  [[nodiscard]] const mjModel& m() const { return *compiled.model; }
  [[nodiscard]] mjData& d() const { return *data; }
  [[nodiscard]] const BodyContacts& contacts(std::size_t i) const { return *find_body(*data, bodies[i]); }
  /// Returns the begin of a message about a sensor or a soft geom without taxels.
  [[nodiscard]] std::string title_of(std::size_t i) const {
    return (i < sensor_count() ? "sensor \"" : "contact \"") + contacts(i).settings().name + "\": ";
  }
  /// Returns null for a soft geom without taxels.
  [[nodiscard]] HydroInstance* sensor(std::size_t i) const { return find_sensor(*data, bodies[i].instance); }
  [[nodiscard]] std::size_t sensor_count() const { return bodies.size() - bare_models.size(); }
  [[nodiscard]] const SensorModelPtr& model(std::size_t i) const {
    return i < sensor_count() ? sensor(i)->model() : bare_models[i - sensor_count()];
  }
  /// Returns the index of a declared body in scene->sensors, or -1.
  [[nodiscard]] int place_of(BodyId id) const;

  void make_data();
  void read_by(const ReadoutChoice& readout);
  void describe();
  [[nodiscard]] std::vector<TouchedBody> touched_by(std::size_t number);
  void place_mocap();
  void follow_lead();
  void evaluate_present_state();
  void check_stability() const;
  void check_sensors() const;
  void read_sensors();  ///< reads those that have not read the present state
  void start_at(int keyframe);
  void back_to_start() { start_at(-1); }
  bool move(const Perturb& asked);
};

}  // namespace taxel
