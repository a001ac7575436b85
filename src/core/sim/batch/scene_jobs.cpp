#include "core/sim/batch/scene_jobs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/base/limits.h"
#include "core/base/parallel.h"
#include "core/base/text/json.h"
#include "core/run/recording/recording_files.h"
#include "core/run/recording/run_recorder.h"
#include "core/sim/batch/batch_stopped.h"

namespace taxel {
namespace {

constexpr double kStepRounding = 1e-6;  // relative: times of lists are decimal numbers

std::unique_ptr<Simulator> load(const SceneJob& scene) {
  std::vector<SceneAttachment> attachments;
  for (const JobAttachment& one : scene.attach)
    attachments.push_back({one.geom, one.layout, {}, one.body, one.others, one.keeps_sisters});
  return Simulator::load(scene.file, attachments, {}, scene.geoms);
}

/// Returns a text that equals that of scenes with the same file, attachments, changed geoms, types and numbers of
/// sizes: such scenes have the same names, and are all valid or all invalid but for values.
std::string kind_of(const SceneJob& scene) {
  SceneJob kind;
  kind.file = scene.file;
  kind.attach = scene.attach;
  for (GeomChange change : scene.geoms) {
    std::fill(change.size.begin(), change.size.end(), 1);
    if (change.mass) change.mass = 1;
    if (change.friction) change.friction = 1;
    kind.geoms.push_back(std::move(change));
  }
  return scene_job_to_json(kind);
}

/// Returns the index of a name. Throws Error with the pointer, the names, and the one that may be meant.
std::size_t index_of(const std::string& name, const std::vector<std::string>& names, const std::string& pointer,
                     const char* kind) {
  const auto found = std::ranges::find(names, name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  throw Error("", pointer,
              names.empty()
                  ? fmt::format("is no {}: the scene has none", kind)
                  : fmt::format("is no {}: there are {}{}", kind, quoted_list(names), meant_name(name, names)));
}

/// Returns the number of a body that can be placed.
std::size_t movable_body(const std::string& name, const SceneControls& controls) {
  std::vector<std::string> names;
  for (const SceneBody& body : controls.bodies)
    if (body.free || body.mocap >= 0) names.push_back(body.name);
  const std::string pointer = "/moves/" + escaped_key(name);
  index_of(name, names, pointer, "body with a free joint and no mocap body");
  const auto found = std::ranges::find(controls.bodies, name, &SceneBody::name);
  return static_cast<std::size_t>(found - controls.bodies.begin());
}

void add_table(SceneLead& lead, const ControlTable& table, const SceneControls& controls) {
  std::vector<std::string> names;
  for (const SceneActuator& actuator : controls.actuators) names.push_back(actuator.name);
  for (const auto& [name, values] : table.values) {
    const std::size_t actuator = index_of(name, names, "/controls/" + escaped_key(name), "actuator");
    lead.controls.push_back({static_cast<int>(actuator), table.times, values});
  }
}

SceneLeadPtr lead_of(const SceneJob& scene, const SceneControls& controls) {
  SceneLead lead = *read_lead({scene.controls, scene.mocap, scene.replay}, controls);
  if (scene.table) add_table(lead, *scene.table, controls);
  return std::make_shared<const SceneLead>(std::move(lead));
}

int keyframe_of(const SceneJob& scene, const SceneControls& controls) {
  try {
    return scene.keyframe.empty() ? -1 : keyframe_named(scene.keyframe, controls, "");
  } catch (const Error& e) {
    throw Error("", "/keyframe", e.message());
  }
}

/// Returns the number of time steps between two rows.
long steps_of_row(const SceneJob& scene, double timestep) {
  const double steps = scene.record_interval / timestep;
  if (steps < 0.5 || std::abs(steps - std::round(steps)) > kStepRounding * steps)
    throw Error("", "/record_interval",
                fmt::format("must be a whole number of time steps of {} s, is {} s: a row would lie between two steps",
                            timestep, scene.record_interval));
  return std::lround(steps);
}

/// Returns the number of rows of a run.
long rows_of(const SceneJob& scene, const SceneLead& lead) {
  const double seconds = scene.seconds > 0 ? scene.seconds : end_of(lead);
  return static_cast<long>(std::floor(seconds / scene.record_interval + kStepRounding)) + 1;
}

void check_memory(const SceneJob& scene, const SceneLead& lead, const SimScene& facts) {
  const double bytes = static_cast<double>(recorded_row_bytes(facts)) * static_cast<double>(rows_of(scene, lead));
  if (bytes > static_cast<double>(kMaxRecordingBytes))
    throw Error(
        "", "/seconds",
        fmt::format("gives rows of more than {} GiB: give a longer /record_interval", kMaxRecordingBytes >> 30U));
}

void place_bodies(Simulator& simulator, const SceneJob& scene) {
  if (scene.moves.empty()) return;
  const SceneControls& controls = simulator.scene()->controls;
  const std::vector<Pose> bodies = simulator.view().mark_poses.bodies;
  for (const BodyMove& move : scene.moves) {
    const std::size_t body = movable_body(move.body, controls);
    Pose X_WB = bodies[body];
    X_WB.p += move.shift_W;
    for (int axis = 0; axis < 3; ++axis) {
      dvec3 about(0);
      about[axis] = 1;
      if (move.turn_W_deg[axis] != 0) X_WB.q = glm::angleAxis(glm::radians(move.turn_W_deg[axis]), about) * X_WB.q;
    }
    simulator.edit(SetBody{static_cast<int>(body), X_WB});
  }
}

/// The run of one job.
class SceneRun {
 public:
  SceneRun(const Job& job, bool has_poses, Simulator& simulator, const JobPolicy& policy)
      : job_(job),
        scene_(*job.scene),
        simulator_(simulator),
        policy_(policy),
        facts_(*simulator.scene()),
        columns_(facts_, job.layout_key, std::filesystem::path(scene_.file).filename().string(), has_poses),
        recorder_(facts_) {
    if (!scene_.policy.empty() && !policy_)
      throw Error("", "/scene/policy", "is called by taxel.batch(jobs, out, policy=...) in Python alone");
    simulator_.lead(nullptr);
    const int keyframe = keyframe_of(scene_, facts_.controls);
    if (keyframe < 0 || !simulator_.load_keyframe(keyframe)) simulator_.reset();
    place_bodies(simulator_, scene_);
    lead_ = lead_of(scene_, facts_.controls);
    simulator_.lead(lead_);
  }

  SceneResult run(const std::function<bool()>& is_stopped) {
    const long every = steps_of_row(scene_, facts_.timestep), last = (rows_of(scene_, *lead_) - 1) * every;
    for (long step = 0; step <= last; ++step) {
      if (is_stopped && is_stopped()) throw BatchStopped();
      step % every == 0 ? make_row() : make_step();
    }
    return {recorder_.take(), columns_.episode(), columns_.scene()};
  }

 private:
  void make_row() {
    if (!scene_.policy.empty()) act();
    SimState before, after;
    simulator_.save_state(before);
    simulator_.step();
    simulator_.save_state(after);
    simulator_.view(view_);
    recorder_.follow(view_, simulator_.mocap_pose(), true);
    SceneRow row = row_at(before);
    row.recorded = recorder_.recording().rows.back();
    const ControlValues set = simulator_.controls_of(after);
    row.controls = set.controls;
    row.mocaps = set.mocaps;
    columns_.add(row);
  }

  void make_step() {
    simulator_.step();
    if (!recorder_.needs_every_step()) return recorder_.pass(simulator_.mocap_pose());
    simulator_.view(view_);
    recorder_.follow(view_, simulator_.mocap_pose(), false);
  }

  /// Lets the policy set the controls, after the present state is evaluated.
  void act() {
    simulator_.lead(lead_);  // evaluates the state
    SimState now;
    simulator_.save_state(now);
    simulator_.view(view_);
    SceneColumns one(facts_, "", "", false);
    SceneRow row = row_at(now);
    row.recorded = row_of(view_);
    row.recorded.time = view_.time;
    const ControlValues set = simulator_.controls_of(now);
    row.controls = set.controls;  // those of the step before
    row.mocaps = set.mocaps;
    one.add(row);
    const std::vector<double> controls = policy_(job_, columns_.scene(), one.episode());
    if (controls.size() != facts_.controls.actuators.size())
      throw Error(fmt::format("the policy gave {} numbers, and the scene has {} actuators", controls.size(),
                              facts_.controls.actuators.size()));
    for (std::size_t i = 0; i < controls.size(); ++i) {
      if (!std::isfinite(controls[i]))
        throw Error(fmt::format("the policy gave a number that is not finite for the actuator \"{}\"",
                                facts_.controls.actuators[i].name));
      simulator_.edit(SetControl{static_cast<int>(i), controls[i]});
    }
  }

  /// Returns the parts of a row that are of the evaluated step and of the state before it.
  [[nodiscard]] SceneRow row_at(const SimState& state) const {
    SceneRow row;
    for (const SensorView& sensor : view_.sensors) row.torques_W.push_back(sensor.torque_W);
    row.bodies = view_.mark_poses.bodies;
    row.joints = simulator_.controls_of(state).joints;
    return row;
  }

  const Job& job_;
  const SceneJob& scene_;
  Simulator& simulator_;
  const JobPolicy& policy_;
  const SimScene& facts_;
  SceneColumns columns_;
  RunRecorder recorder_;
  SceneLeadPtr lead_;
  StepView view_;
};

}  // namespace

SceneFacts SceneChecker::check(const SceneJob& scene) {
  std::shared_ptr<const SimScene>& facts = scenes_[kind_of(scene)];
  if (facts == nullptr) {
    std::unique_ptr<Simulator> loaded = load(scene);
    facts = loaded->scene();
    latest_ = std::move(loaded);
  }
  const SceneControls& controls = facts->controls;
  if (facts->sensors.empty())
    throw Error(scene.file, "declares no taxel.sensor and no taxel.contact; attach a layout by /scene/attach");
  keyframe_of(scene, controls);
  for (const BodyMove& move : scene.moves) movable_body(move.body, controls);
  if (!scene.policy.empty() && controls.actuators.empty())
    throw Error("", "/policy", "has nothing to set: the scene has no actuator");
  SceneJob leading;
  leading.file = scene.file;
  leading.attach = scene.attach;
  leading.controls = scene.controls, leading.table = scene.table;
  leading.mocap = scene.mocap, leading.replay = scene.replay;
  SceneLeadPtr lead = leads_[scene_job_to_json(leading)];
  if (lead == nullptr) lead = lead_of(scene, controls);
  if (!scene.table) leads_[scene_job_to_json(leading)] = lead;  // tables of lists may all differ
  steps_of_row(scene, facts->timestep);
  check_memory(scene, *lead, *facts);
  SceneFacts found{facts->files};
  found.files.push_back(scene.file);
  return found;
}

std::unique_ptr<Simulator> SceneRunner::take(const Job& job) {
  {
    const std::scoped_lock lock(mutex_);
    const auto found =
        std::ranges::find(idle_, job.layout_key, [](const auto& one) -> const std::string& { return one.first; });
    if (found != idle_.end()) {
      std::unique_ptr<Simulator> simulator = std::move(found->second);
      idle_.erase(found);
      return simulator;
    }
  }
  const std::scoped_lock lock(compiler_);
  return load(*job.scene);
}

void SceneRunner::keep(const std::string& key, std::unique_ptr<Simulator> simulator) {
  const std::scoped_lock lock(mutex_);
  idle_.emplace_front(key, std::move(simulator));
  if (idle_.size() > kKept) idle_.pop_back();
}

SceneResult SceneRunner::run(const Job& job, bool has_poses, const std::function<bool()>& is_stopped,
                             const JobPolicy& policy) {
  std::unique_ptr<Simulator> simulator = take(job);
  std::optional<SceneResult> result;
  on_this_core([&] { result = SceneRun(job, has_poses, *simulator, policy).run(is_stopped); });
  keep(job.layout_key, std::move(simulator));
  return std::move(*result);
}

}  // namespace taxel
