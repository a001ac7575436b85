#include "core/sim/simulator.h"

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/base/text/sensor_names.h"
#include "core/sensor/sensor_model.h"
#include "core/sim/model/geometry.h"
#include "core/sim/model/scene_look.h"
#include "core/sim/model/scene_view.h"
#include "core/sim/plugin/layout_search.h"
#include "core/sim/plugin/pairs/geom_body.h"
#include "core/sim/scene/changed_geoms.h"
#include "core/sim/scene/loaded_scene.h"
#include "core/sim/simulator_impl.h"

namespace taxel {

namespace {

/// Returns the name of the body or actuator to which the index in a warning belongs.
std::string culprit(const mjModel& m, int warning, int number) {
  const auto named = [&m](int type, int id, const char* word) {
    const char* name = id >= 0 ? mj_id2name(&m, type, id) : nullptr;
    return name != nullptr ? fmt::format("{} \"{}\"", word, name) : fmt::format("{} {}", word, id);
  };
  if (warning == mjWARN_BADCTRL && number >= 0 && number < m.nu) return named(mjOBJ_ACTUATOR, number, "actuator");
  if (warning == mjWARN_BADQPOS) {
    int body = -1;
    for (int j = 0; j < m.njnt && m.jnt_qposadr[j] <= number; ++j) body = m.jnt_bodyid[j];
    return named(mjOBJ_BODY, body, "body");
  }
  return number >= 0 && number < m.nv ? named(mjOBJ_BODY, m.dof_bodyid[number], "body") : "an unknown body";
}

/// Returns MuJoCo's first warning of a bad number, with its body or actuator: "at body \"finger\": Nan, ...". Empty if
/// there is no warning.
std::string instability(const mjModel& m, const mjData& d) {
  for (const int kind : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC, mjWARN_BADCTRL}) {
    const mjWarningStat& w = d.warning[kind];
    if (w.number > 0)
      return fmt::format("at {}: {}", culprit(m, kind, w.lastinfo),
                         mju_warningText(kind, static_cast<std::size_t>(w.lastinfo)));
  }
  return {};
}

/// Turns MuJoCo's log off: it would be written into the user's working folder, and our own messages report the same.
void quiet_mujoco() {
  mjLogConfig config = mju_getLogConfig();
  config.logto_console = false;
  config.logto_file = false;
  mju_setLogConfig(config);
}

void prepare_mujoco() {
  quiet_mujoco();
  if (!register_sensor_plugin()) throw Error("the taxel.sensor plugin module is loaded in this process already");
}

/// Returns the path of the finger's lowest point; for a straight path, only its two ends.
std::vector<dvec3> drawn_path(const Motion& motion) {
  constexpr std::uint64_t kMost = 256;
  const bool straight = motion.way_points.size() == 2 && motion.travel;
  const std::uint64_t parts = straight ? 1 : std::clamp<std::uint64_t>(motion.last_step, 1, kMost);
  std::vector<dvec3> path;
  for (std::uint64_t i = 0; i <= parts; ++i) path.push_back(motion.pose(i * motion.last_step / parts) * motion.lead_M);
  return path;
}

}  // namespace

Simulator::Simulator() : impl_(std::make_unique<Impl>()) {}
Simulator::~Simulator() = default;

void Simulator::Impl::make_data() {
  data.reset(mj_makeData(compiled.model.get()));
  if (data == nullptr) throw Error(title, "MuJoCo cannot make the simulation data");
  mj_kinematics(&m(), &d());  // computes the poses of fixed geoms
  bodies.clear();
  for (const int i : sensor_instances(m())) {
    bodies.push_back({i, 0});
    const std::string name = instance_name(m(), i);
    const auto handed = compiled.handed.find(name), edited = compiled.edited.find(name);
    if (handed == compiled.handed.end() && edited == compiled.edited.end()) continue;
    try {
      find_sensor(*data, i)->hand_over(m(), handed != compiled.handed.end() ? handed->second : edited->second);
    } catch (const Error& error) {
      throw Error(title, error.where(), error.message());
    }
  }
  bare_models.clear();
  bare_shapes.clear();
  for (const int i : contact_instances(m())) {
    const ContactConfig config = read_contact_config(m(), i);
    const std::vector<ContactSettings>& soft = config.bodies;
    for (std::size_t k = 0; k < soft.size(); ++k) {
      bodies.push_back({i, static_cast<int>(k)});
      const HydroBodyPtr body = find_body(*data, bodies.back())->body();
      bare_models.push_back(bare_model(geom_name(m(), soft[k].geom), drawn_mesh(m(), soft[k].geom), body));
      bare_shapes.push_back(body ? std::make_shared<const Shape>(geom_body_shape(m(), soft[k].geom, config.materials))
                                 : nullptr);
    }
  }
}

int Simulator::Impl::place_of(BodyId id) const {
  const auto found = std::find(bodies.begin(), bodies.end(), id);
  return found != bodies.end() ? static_cast<int>(found - bodies.begin()) : -1;
}

void Simulator::Impl::read_by(const ReadoutChoice& readout) {
  for (std::size_t i = 0; i < sensor_count(); ++i)
    if (model(i) != nullptr) sensor(i)->hand_over(m(), with_readout(*model(i), readout));
}

std::vector<TouchedBody> Simulator::Impl::touched_by(std::size_t number) {
  std::vector<TouchedBody> all;
  for (const TouchedGeom& touched : contacts(number).touched()) {
    TouchedBody& one = all.emplace_back();
    one.body = touched.body;
    one.name = geom_name(m(), touched.geom);
    one.sensor = place_of(touched.role.partner);
    const auto geom = std::find(drawn.begin(), drawn.end(), touched.geom);
    if (one.sensor >= 0) {
      one.mirrored = touched.role.mirrored;
      const SensorModelPtr& partner = model(static_cast<std::size_t>(one.sensor));
      one.body = partner ? partner->body : nullptr;
      if (const auto i = static_cast<std::size_t>(one.sensor); i >= sensor_count())
        one.shape = bare_shapes[i - sensor_count()];
      continue;
    }
    std::shared_ptr<const Shape>& shape = shapes[touched.geom];
    if (shape == nullptr && touched.body)
      shape = std::make_shared<const Shape>(geom_body_shape(m(), touched.geom, contacts(number).settings().materials));
    one.shape = shape;
    if (geom != drawn.end()) {
      one.geom = static_cast<int>(geom - drawn.begin());
    } else if (m().body_weldid[m().geom_bodyid[touched.geom]] == 0) {
      one.X_WB = geom_pose(m(), d(), touched.geom);
    } else {
      one.body = nullptr;  // the geom moves, and its poses are not recorded
    }
  }
  return all;
}

namespace {

/// Returns the path of the layout file that a sensor declares, or an empty text if it declares none.
std::string layout_file(const mjModel& m, const SensorConfig& config) {
  if (config.layout.empty() || config.layout.front() == '{') return "";
  try {
    return std::filesystem::absolute(find_layout(config.layout, layout_folders(m, config.geom)).file)
        .lexically_normal()
        .string();
  } catch (const Error&) {  // the file was deleted after it was read
    return "";
  }
}

/// Returns the absolute path of a file that is relative to the folder of a scene.
std::string in_folder_of(const std::filesystem::path& scene, const std::string& file) {
  std::error_code ignored;
  return (std::filesystem::absolute(scene, ignored).parent_path() / file).lexically_normal().string();
}

}  // namespace

void Simulator::Impl::describe() {
  const auto scene = std::make_shared<SimScene>();
  scene->title = title;
  if (!scenario) scene->files = scene_sources(title, compiled);
  scene->geoms = drawable_geoms(m(), drawn);
  for (SceneGeom& geom : scene->geoms)
    if (!geom.skin.file.empty()) geom.skin.file = in_folder_of(title, geom.skin.file);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const auto g = static_cast<std::size_t>(drawn[i]);
    if (g >= compiled.names.geoms.size()) break;  // the scene was not read from a file
    SceneGeom& geom = scene->geoms[i];
    if (compiled.names.is_label(g)) geom.label = std::exchange(geom.name, compiled.names.sensor_names[g]);
    geom.class_name = compiled.names.geoms[g].class_name;
  }
  if (!scenario) add_look(*compiled.spec, m(), drawn, *scene);
  scene->timestep = m().opt.timestep;
  scene->controls = scene_controls(m());
  scene->marks = scene_marks(m());
  std::vector<int> sensor_geoms;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const int geom = contacts(i).settings().geom;
    sensor_geoms.push_back(geom);
    scene->sensors.push_back(model(i));
    scene->sensor_geoms.push_back(geom_name(m(), geom));
    scene->sensor_layouts.push_back(i < sensor_count() ? layout_file(m(), sensor(i)->config()) : "");
    scene->sensor_slips.push_back(i < sensor_count() && contacts(i).settings().bristles.has_bristles());
    for (std::size_t g = 0; g < drawn.size(); ++g)
      if (drawn[g] == geom) scene->geoms[g].sensor = static_cast<int>(i);
  }
  scene->sensor_labels = short_sensor_names(scene->sensor_geoms);
  for (std::size_t i = 0; i < bodies.size(); ++i) scene->touched.push_back(touched_by(i));
  if (!scenario) mark_covered_geoms(m(), d(), drawn, sensor_geoms, *scene);
  if (scenario) {
    const Motion& motion = scenario->motion;
    scene->duration = static_cast<double>(motion.last_step) * m().opt.timestep;
    scene->lead_M = motion.lead_M;
    scene->way_points = motion.way_points;
    if (motion.pose) scene->path_W = drawn_path(motion);
  }
  shown = scene;
  for (int b = 0; b < m().nbody && mocap < 0; ++b) mocap = m().body_mocapid[b];
  if (mocap >= 0) mocap_start = {d().mocap_pos[3 * mocap], d().mocap_pos[3 * mocap + 1], d().mocap_pos[3 * mocap + 2]};
}

void Simulator::Impl::place_mocap() {
  if (!scenario->motion.pose) return;
  const Pose X = scenario->motion.pose(steps);
  for (int i = 0; i < 3; ++i) d().mocap_pos[3 * mocap + i] = X.p[i];
  mjtNum* q = d().mocap_quat + 4 * mocap;
  q[0] = X.q.w, q[1] = X.q.x, q[2] = X.q.y, q[3] = X.q.z;
}

/// Sets the led controls and poses of the next step. The time counts steps, so that the poses of a recorded run are
/// those of its steps, bit for bit.
void Simulator::Impl::follow_lead() {
  if (lead == nullptr) return;
  const double now = static_cast<double>(steps) * m().opt.timestep;
  for (const ControlTrack& track : lead->controls) set_control(m(), d(), {track.actuator, control_at(track, now)});
  for (const MocapTrack& track : lead->mocaps) {
    put(d().mocap_pos + 3 * track.mocap, position_at(track, now));
    if (!track.rotations_WB.empty()) put(d().mocap_quat + 4 * track.mocap, rotation_at(track, now));
  }
}

/// Evaluates the present state without changing it, so that contacts and readings exist before the first step.
void Simulator::Impl::evaluate_present_state() {
  std::vector<mjtNum> state(static_cast<std::size_t>(mj_stateSize(&m(), mjSTATE_INTEGRATION)));
  mj_getState(&m(), &d(), state.data(), mjSTATE_INTEGRATION);
  mj_forward(&m(), &d());
  mj_setState(&m(), &d(), state.data(), mjSTATE_INTEGRATION);
  check_sensors();
}

void Simulator::Impl::check_sensors() const {
  for (const BodyId id : bodies) {
    const BodyContacts& body = *find_body(*data, id);
    if (!body.failure.empty()) throw Error(title, body.failure);
  }
}

void Simulator::Impl::check_stability() const {
  if (const std::string what = instability(m(), d()); !what.empty())
    throw Error(title, fmt::format("the simulation became unstable at {:.6g} s, {}", time, what));
}

/// Starts a run at a keyframe, or at the initial state if `keyframe` is negative.
void Simulator::Impl::start_at(int keyframe) {
  keyframe < 0 ? mj_resetData(&m(), &d()) : mj_resetDataKeyframe(&m(), &d(), keyframe);
  perturbation.end();
  steps = 0;
  time = d().time;
  travel = 0;
  row_due = false;
  if (scenario) place_mocap();
  follow_lead();
  if (!scenario && mocap >= 0) mocap_start = vec3(d().mocap_pos + 3 * mocap);
  evaluate_present_state();
}

std::unique_ptr<Simulator> Simulator::make_scenario(const SensorModelPtr& model, const Scenario& scenario) {
  prepare_mujoco();
  std::unique_ptr<Simulator> simulator(new Simulator);
  Impl& s = *simulator->impl_;
  s.title = "fingertip " + std::string(to_word(scenario.kind())) + ": " + model->layout.name;
  s.scenario = build_scenario_scene(*model, scenario);
  s.compiled = compile_scene(s.scenario->hosted_xml, s.scenario->files.files, s.title);
  for (const int i : sensor_instances(s.m())) s.compiled.handed[instance_name(s.m(), i)] = model;
  s.make_data();
  for (std::size_t i = 0; i < s.sensor_count(); ++i) s.sensor(i)->defer_readings();  // nothing reads sensordata
  s.describe();
  s.back_to_start();
  return simulator;
}

std::unique_ptr<Simulator> Simulator::load(const std::filesystem::path& scene,
                                           const std::vector<SceneAttachment>& attachments,
                                           const ReadoutChoice& readout, const std::vector<GeomChange>& geoms) {
  prepare_mujoco();
  std::unique_ptr<Simulator> simulator(new Simulator);
  Impl& s = *simulator->impl_;
  s.title = scene.string();
  s.compiled = load_scene(scene, attachments);
  s.attachments = attachments;
  if (!geoms.empty()) change_geoms(s.compiled, geoms, s.title);
  s.make_data();
  if (!readout.is_empty()) s.read_by(readout);
  s.describe();
  s.back_to_start();
  return simulator;
}

void Simulator::step() {
  Impl& s = *impl_;
  s.time = s.d().time;
  if (s.scenario) s.place_mocap();
  s.follow_lead();
  if (s.scenario && s.scenario->motion.travel) {
    s.travel = s.scenario->motion.travel(s.steps);
  } else {
    s.travel = s.mocap >= 0 ? glm::distance(mocap_pose().p, s.mocap_start) : 0.0;
  }
  s.row_due = !s.scenario || s.scenario->motion.row_due(s.steps);
  s.perturbation.add_force(s.m(), s.d());
  mj_step(&s.m(), &s.d());
  s.perturbation.clear_force(s.d());
  ++s.steps;
  s.check_stability();
  s.check_sensors();
}

void Simulator::lead(SceneLeadPtr lead) {
  Impl& s = *impl_;
  s.lead = std::move(lead);
  s.follow_lead();
  if (!s.scenario && s.steps == 0 && s.mocap >= 0) s.mocap_start = mocap_pose().p;
  s.time = s.d().time;
  s.evaluate_present_state();
}

void Simulator::reset() {
  impl_->back_to_start();
}

bool Simulator::load_keyframe(int keyframe) {
  if (keyframe < 0 || keyframe >= impl_->m().nkey) return false;
  impl_->start_at(keyframe);
  return true;
}

/// Drags a body, or ends dragging. Returns true if geoms may have moved.
bool Simulator::Impl::move(const Perturb& asked) {
  const bool held = asked.kind != Perturb::Kind::none && asked.geom >= 0;
  if (!held || static_cast<std::size_t>(asked.geom) >= drawn.size()) {
    perturbation.end();
    return false;
  }
  const int geom = drawn[static_cast<std::size_t>(asked.geom)], body = m().geom_bodyid[geom];
  const Pose X_WB = body_pose(d(), body);
  return perturbation.follow(m(), d(), asked, body, X_WB.inverse() * (geom_pose(m(), d(), geom) * asked.point_G));
}

void Simulator::edit(const SceneEdit& edit) {
  struct Apply {
    Impl& s;
    bool operator()(const SetControl& e) const { return set_control(s.m(), s.d(), e); }
    bool operator()(const SetJoint& e) const { return set_joint(s.m(), s.d(), e); }
    bool operator()(const SetMocap& e) const { return set_mocap(s.m(), s.d(), e); }
    bool operator()(const SetEquality& e) const { return set_equality(s.m(), s.d(), e); }
    bool operator()(const SetBody& e) const { return set_body(s.m(), s.d(), e); }
    bool operator()(const Perturb& e) const { return s.move(e); }
  };
  if (!std::visit(Apply{*impl_}, edit)) return;
  impl_->time = impl_->d().time;
  impl_->evaluate_present_state();
}

void Simulator::replace_model(const SensorModelPtr& replaced, const SensorModelPtr& model) {
  Impl& s = *impl_;
  const Material &before = replaced->layout.material, &after = model->layout.material;
  if (before.tangential_stiffness != after.tangential_stiffness || before.bristles != after.bristles)
    throw Error(s.title, "friction that sticks has changed, which needs another scene: start the run again");
  bool another_body = false, any = false;
  for (std::size_t i = 0; i < s.sensor_count(); ++i) {
    HydroInstance& sensor = *s.sensor(i);
    if (sensor.model() != replaced) continue;
    any = true;
    const std::string& name = sensor.config().name;
    (s.compiled.handed.contains(name) ? s.compiled.handed : s.compiled.edited)[name] = model;
    if (sensor.model()->body == model->body) {
      sensor.replace_samples(s.m(), s.d(), model);
    } else {
      sensor.hand_over(s.m(), model);
      another_body = true;
    }
  }
  if (!any) return;
  const auto scene = std::make_shared<SimScene>(*s.shown);
  std::replace(scene->sensors.begin(), scene->sensors.end(), replaced, model);
  ++scene->model_edition;
  s.shown = scene;
  if (another_body) s.evaluate_present_state();
}

ControlValues Simulator::controls_of(const SimState& state) const {
  return control_values(impl_->m(), state.integration);
}

void Simulator::save_state(SimState& state) const {
  const Impl& s = *impl_;
  state.integration.resize(static_cast<std::size_t>(mj_stateSize(&s.m(), mjSTATE_INTEGRATION)));
  mj_getState(&s.m(), &s.d(), state.integration.data(), mjSTATE_INTEGRATION);
  state.step = s.steps;
  state.time = s.time;
  state.travel = s.travel;
  state.row_due = s.row_due;
}

void Simulator::restore_state(const SimState& state) {
  Impl& s = *impl_;
  if (state.integration.size() != static_cast<std::size_t>(mj_stateSize(&s.m(), mjSTATE_INTEGRATION)))
    throw Error(s.title, "the state is another scene's");
  mj_setState(&s.m(), &s.d(), state.integration.data(), mjSTATE_INTEGRATION);
  for (mjWarningStat& warning : s.d().warning) warning.number = 0;
  s.perturbation.end();
  s.steps = state.step;
  s.time = state.time;
  s.travel = state.travel;
  s.row_due = state.row_due;
}

}  // namespace taxel
