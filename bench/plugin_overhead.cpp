// Cost of the plugin beyond its own work, as a part of a step. Each step of a run is repeated from its recorded state,
// once with the plugin and once without, where the recorded contact forces are applied instead: both compute the same
// step. The plugin's own work is the time that its instances count for contact surfaces, forces and readings. Surfaces
// and readings are also computed without MuJoCo, by calls of the core with the poses of the same steps.
//
//   bench_plugin_overhead SWEEP [ROUNDS]     SWEEP is a folder of `taxel sweep`
#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstring>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "core/base/files.h"
#include "core/hydro/intersect.h"
#include "core/sensor/readout/reading.h"
#include "core/sim/mujoco_handles.h"
#include "core/sim/plugin/plugin_table.h"
#include "fixtures/read_npz.h"

namespace {
using namespace taxel;
using Clock = std::chrono::steady_clock;

/// The functions of the plugin that a step calls. They can be switched off, and the time in them is counted.
struct Callbacks {
  void (*compute)(const mjModel*, mjData*, int, int) = nullptr;
  void (*advance)(const mjModel*, mjData*, int) = nullptr;
  bool on = true;
  double seconds = 0;
} callbacks;

template <class Call>
void time_call(const Call& call) {
  if (!callbacks.on) return;
  const auto begin = Clock::now();
  call();
  callbacks.seconds += std::chrono::duration<double>(Clock::now() - begin).count();
}

void replace_callbacks() {
  register_sensor_plugin();
  auto* plugin = const_cast<mjpPlugin*>(mjp_getPlugin(kPluginName, nullptr));
  callbacks.compute = plugin->compute;
  callbacks.advance = plugin->advance;
  plugin->compute = [](const mjModel* m, mjData* d, int instance, int capability) {
    time_call([&] { callbacks.compute(m, d, instance, capability); });
  };
  plugin->advance = [](const mjModel* m, mjData* d, int instance) {
    time_call([&] { callbacks.advance(m, d, instance); });
  };
}

/// Returns the sums over all sensors [s].
SensorTimes own_work(const mjModel& m, const mjData& d) {
  SensorTimes sum;
  for (int i = 0; i < m.nplugin; ++i) {
    const SensorTimes& times = find_sensor(d, i)->contacts().times;
    sum.surfaces += times.surfaces;
    sum.forces += times.forces;
    sum.readings += times.readings;
  }
  return sum;
}

/// One sensor in one step: its pose, and the poses of the geoms near it.
struct Posed {
  const HydroInstance* sensor = nullptr;
  Pose X_WM;
  std::vector<std::pair<HydroBodyPtr, Pose>> near;
};

/// A run of a scene: the states before its steps, and the contact forces and poses in them.
struct Run {
  ModelHandle model;
  DataHandle data;
  std::vector<std::vector<mjtNum>> states, forces;
  std::vector<Posed> poses;
};

void keep_poses(Run& run) {
  for (int i = 0; i < run.model->nplugin; ++i) {
    const HydroInstance& sensor = *find_sensor(*run.data, i);
    Posed posed{&sensor, sensor.sensed().X_WM, {}};
    for (const std::size_t k : sensor.sensed().near)
      posed.near.emplace_back(sensor.touched()[k].body, sensor.sensed().pairs[k].X_WB);
    run.poses.push_back(std::move(posed));
  }
}

/// Runs a scene. `prepare` sets the inputs of a step, and returns false after the last step.
Run record(const std::string& scene, const std::function<bool(const mjModel&, mjData&, std::size_t)>& prepare) {
  Run run;
  std::string reason(2000, '\0');
  run.model.reset(mj_loadXML(scene.c_str(), nullptr, reason.data(), static_cast<int>(reason.size())));
  if (run.model == nullptr) throw Error(reason.c_str());
  const mjModel& m = *run.model;
  run.data.reset(mj_makeData(&m));
  callbacks.on = true;
  mjData& d = *run.data;
  for (std::size_t n = 0; prepare(m, d, n); ++n) {
    run.states.emplace_back(static_cast<std::size_t>(mj_stateSize(&m, mjSTATE_INTEGRATION)));
    mj_getState(&m, &d, run.states.back().data(), mjSTATE_INTEGRATION);
    mj_step(&m, &d);
    // All passive forces but those of springs, dampers, gravity compensation and fluids come from the plugin.
    run.forces.emplace_back(static_cast<std::size_t>(m.nv));
    for (int i = 0; i < m.nv; ++i)
      run.forces.back()[static_cast<std::size_t>(i)] =
          d.qfrc_passive[i] - d.qfrc_spring[i] - d.qfrc_damper[i] - d.qfrc_gravcomp[i] - d.qfrc_fluid[i];
    keep_poses(run);
  }
  return run;
}

/// Times of a step in microseconds.
struct Times {
  double with = 0;       ///< a step with the plugin
  double without = 0;    ///< a step without the plugin and with the forces of the plugin
  double callbacks = 0;  ///< the plugin's functions
  double forces = 0;     ///< the part of the plugin's work for forces
  double sensing = 0;    ///< the part of the plugin's work for contact surfaces and readings
  double core = 0;       ///< contact surfaces and readings by calls of the core

  [[nodiscard]] double own_work() const { return forces + sensing; }
};

/// Computes surfaces and readings of all steps, and returns the time [s].
double call_core(const Run& run) {
  std::vector<ContactSurface> surfaces(1);
  std::vector<const ContactSurface*> all;
  IntersectWorkspace workspace;
  std::vector<SensorReading> readings(static_cast<std::size_t>(run.model->nplugin));
  const auto begin = Clock::now();
  for (std::size_t n = 0; n < run.poses.size(); ++n) {
    const Posed& posed = run.poses[n];
    const SensorModel& model = *posed.sensor->model();
    if (surfaces.size() < posed.near.size()) surfaces.resize(posed.near.size());
    all.clear();
    for (std::size_t k = 0; k < posed.near.size(); ++k) {
      intersect(*model.body, *posed.near[k].first, posed.X_WM, posed.near[k].second, surfaces[k], workspace);
      all.push_back(&surfaces[k]);
    }
    read_sensor(model, all, readings[n % readings.size()]);
  }
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Repeats one step and returns its time [s].
double repeat(Run& run, std::size_t n, bool with_plugin) {
  const mjModel& m = *run.model;
  mjData& d = *run.data;
  mj_setState(&m, &d, run.states[n].data(), mjSTATE_INTEGRATION);
  if (!with_plugin)
    for (int i = 0; i < m.nv; ++i) d.qfrc_applied[i] += run.forces[n][static_cast<std::size_t>(i)];
  callbacks.on = with_plugin;
  const auto begin = Clock::now();
  mj_step(&m, &d);
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

Times measure_round(Run& run) {
  Times sum;
  const SensorTimes before = own_work(*run.model, *run.data);
  callbacks.seconds = 0;
  for (std::size_t n = 0; n < run.states.size(); ++n) {
    const bool first = n % 2 == 0;
    (first ? sum.with : sum.without) += repeat(run, n, first);
    (first ? sum.without : sum.with) += repeat(run, n, !first);
  }
  sum.callbacks = callbacks.seconds;
  const SensorTimes after = own_work(*run.model, *run.data);
  sum.forces = after.forces - before.forces;
  sum.sensing = after.surfaces + after.readings - before.surfaces - before.readings;
  sum.core = call_core(run);
  for (double* time : {&sum.with, &sum.without, &sum.callbacks, &sum.forces, &sum.sensing, &sum.core})
    *time *= 1e6 / static_cast<double>(run.states.size());
  return sum;
}

double median(const std::vector<Times>& all, const std::function<double(const Times&)>& value) {
  std::vector<double> values;
  for (const Times& times : all) values.push_back(value(times));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

void report(const std::string& name, Run run, int rounds) {
  std::vector<Times> all;
  measure_round(run);  // warms up
  for (int round = 0; round < rounds; ++round) all.push_back(measure_round(run));
  const auto column = [&](const auto& value) { return median(all, value); };
  fmt::print("| {}, {} steps | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:+.2f} % | {:+.2f} % |\n", name,
             run.states.size(), column([](const Times& t) { return t.with; }),
             column([](const Times& t) { return t.without; }), column([](const Times& t) { return t.callbacks; }),
             column([](const Times& t) { return t.forces; }), column([](const Times& t) { return t.sensing; }),
             column([](const Times& t) { return t.core; }),
             column([](const Times& t) { return 100 * (t.callbacks - t.own_work()) / t.with; }),
             column([](const Times& t) { return 100 * (t.with - t.without - t.own_work()) / t.with; }));
}

Run record_sweep(const std::string& folder) {
  auto arrays = test::parse_npz(read_file(folder + "/readings.npz"));
  const std::vector<double> positions = arrays.at("mocap_pos").doubles(), turns = arrays.at("mocap_quat").doubles();
  return record(folder + "/scene.xml", [&](const mjModel&, mjData& d, std::size_t n) {
    if (3 * n + 3 > positions.size()) return false;
    std::copy_n(positions.begin() + static_cast<std::ptrdiff_t>(3 * n), 3, d.mocap_pos);
    std::copy_n(turns.begin() + static_cast<std::ptrdiff_t>(4 * n), 4, d.mocap_quat);
    return true;
  });
}

Run record_hand() {
  return record(TAXEL_SOURCE_DIR "/assets/scenes/hand_grasps_ball.xml", [](const mjModel& m, mjData& d, std::size_t n) {
    if (n == 0) mj_resetDataKeyframe(&m, &d, 0);
    return n < 500;
  });
}

int run(int argc, char** argv) {
  int rounds = 15;
  if (argc == 3) std::from_chars(argv[2], argv[2] + std::strlen(argv[2]), rounds);
  if (argc < 2 || rounds < 1) {
    fmt::print(stderr, "bench_plugin_overhead SWEEP [ROUNDS]: SWEEP is a folder of `taxel sweep`\n");
    return 2;
  }
  replace_callbacks();
  fmt::print("Microseconds per step, medians of {} rounds.\n\n", rounds);
  fmt::print(
      "| run | with the plugin | without | its functions | forces | surfaces, readings | the same by the core |"
      " functions - work | with - without - work |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  report("sweep of the fingertip", record_sweep(argv[1]), rounds);
  report("hand of five fingers", record_hand(), rounds);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_plugin_overhead: {}\n", error.what());
    return 1;
  }
}
