#include "app/cli/recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <set>

#include "app/cli/signals.h"
#include "core/base/limits.h"
#include "core/sim/compare/error_bars.h"
#include "core/sim/host/follow_simulator.h"

namespace taxel::cli {
namespace {

/// Prints the repairs of touched meshes, and each warning of the sensors once, as soon as it exists.
class SensorWarnings {
 public:
  SensorWarnings(const Simulator& simulator, Console& console) : simulator_(simulator), console_(console) {
    for (const std::string& text : simulator.repairs()) console.note(text);
    print_new();
  }
  void print_new() {
    for (std::string& text : simulator_.warnings()) {
      if (const auto [at, is_new] = printed_.insert(std::move(text)); is_new) console_.warn(*at);
    }
  }

 private:
  const Simulator& simulator_;
  Console& console_;
  std::set<std::string> printed_;
};

/// Throws Error if the run or its recording would be too large, and prints a note for a large recording. `seconds` is 0
/// for a scenario. A scenario records a pose of the mocap body in every step, but a row in few steps.
void check_cost(const SimScene& scene, double seconds, Console& console) {
  constexpr double kAnnounced = 0.25 * static_cast<double>(kMaxRecordingBytes);
  const double steps = std::ceil((seconds > 0 ? seconds : scene.duration) / scene.timestep);
  check_steps(steps, fmt::format("{} s in steps of {} s", seconds, scene.timestep));
  const auto bytes_per_step = static_cast<double>(seconds > 0 ? recorded_row_bytes(scene) : sizeof(Pose));
  check_recording_bytes(steps, bytes_per_step, seconds > 0 ? "give fewer --seconds" : "choose a longer time step");
  if (steps * bytes_per_step > kAnnounced)
    console.note(fmt::format("records {:.3g} steps, which take {:.0f} MiB of memory", steps,
                             steps * bytes_per_step / (1U << 20U)));
}

/// Throws Error if the recording is too large. check_cost() cannot know the number of rows of a scenario.
void check_size(const RunRecorder& recorder) {
  if (recorder.bytes() <= kMaxRecordingBytes) return;
  throw Error(fmt::format("the recording takes more than {} GiB of memory after {} rows: record fewer rows",
                          kMaxRecordingBytes >> 30U, recorder.recording().rows.size()));
}

/// Throws Error if a number of the last recorded row is not finite.
void check_row(const Recording& recording, long step) {
  if (recording.rows.empty()) return;
  const std::vector<SensorRecord>& sensors = recording.rows.back().sensors;
  for (std::size_t s = 0; s < sensors.size(); ++s) {
    const auto refuse = [&](const std::string& what) {
      throw Error(fmt::format("{}: {} is not finite at step {}: a modulus, velocity or size is too large",
                              recording.sensors[s].geom, what, step));
    };
    if (!is_finite(sensors[s].force_W)) refuse("the contact force");
    for (std::size_t k = 0; k < sensors[s].readings.size(); ++k)
      if (!std::isfinite(sensors[s].readings[k]))
        refuse(fmt::format("the reading of taxel {}", recording.sensors[s].taxel_ids[k]));
  }
}

/// Warns of sensors that have no contact, or read nothing in contact, in any row.
void warn_of_no_contact(const Recording& recording, Console& console) {
  for (std::size_t s = 0; s < recording.sensors.size(); ++s) {
    const bool touched = std::any_of(recording.rows.begin(), recording.rows.end(),
                                     [s](const RecordedRow& row) { return row.sensors[s].polygons > 0; });
    const bool read = std::any_of(recording.rows.begin(), recording.rows.end(), [s](const RecordedRow& row) {
      const std::vector<double>& readings = row.sensors[s].readings;
      return std::any_of(readings.begin(), readings.end(), [](double reading) { return reading != 0; });
    });
    const std::string& geom = recording.sensors[s].geom;
    if (!touched)
      console.warn(fmt::format("{}: touches nothing in any of the {} rows", geom, recording.rows.size()));
    else if (!read && !recording.sensors[s].taxel_ids.empty())
      console.warn(
          fmt::format("{}: is in contact, but every taxel reads 0 in all {} rows: no receptive field is at the contact",
                      geom, recording.rows.size()));
  }
}

}  // namespace

CheckedRecorder::CheckedRecorder(const SimScene& scene, double seconds, Console& console,
                                 std::shared_ptr<ErrorBarSource> errors)
    : recorder_(scene, std::move(errors)) {
  check_cost(scene, seconds, console);
}

void CheckedRecorder::follow(const Simulator& simulator) {
  ++steps_;
  if (follow_latest_step(simulator, recorder_, view_)) check_row(recorder_.recording(), steps_);
  check_size(recorder_);
}

std::shared_ptr<ErrorBarSource> error_bars_of(const Simulator& simulator, Console& console) {
  const SimScene& scene = *simulator.scene();
  auto errors = std::make_shared<ErrorBars>(simulator.scene());
  for (std::size_t s = 0; s < scene.sensors.size(); ++s)
    if (const std::string why = errors->missing(s); !why.empty() && !scene.sensors[s]->layout.taxels.empty())
      console.warn(fmt::format("{}: has no error bars: {}", scene.sensor_geoms[s], why));
  return errors;
}

Recording record(Simulator& simulator, double seconds, Console& console, RunCost& cost, KeptRun* kept,
                 std::shared_ptr<ErrorBarSource> errors) {
  const SimScene& scene = *simulator.scene();
  CheckedRecorder recorder(scene, seconds, console, std::move(errors));
  const double limit = seconds > 0 ? seconds : scene.duration;
  const long last = seconds > 0 ? std::lround(seconds / scene.timestep) : -1;
  SensorWarnings warnings(simulator, console);
  const SensorTimes before = simulator.sensor_times();
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpu_start = std::clock();
  for (long step = 0; step != last && !simulator.finished() && received_signal() == 0; ++step) {
    simulator.step();
    warnings.print_new();
    recorder.follow(simulator);
    if (kept != nullptr) kept->follow(recorder.recording());
    cost.steps = step + 1;
    cost.simulated = static_cast<double>(cost.steps) * scene.timestep;
    if (limit > 0) console.progress(std::min(0.99, cost.simulated / limit));
  }
  console.progress(1);
  if (const int number = received_signal(); number != 0)
    console.warn(fmt::format("ended by {} after {} steps, {:.6g} s: the result has only these steps",
                             name_of_signal(number), cost.steps, cost.simulated));
  cost.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const SensorTimes after = simulator.sensor_times();
  cost.sensors = {after.surfaces - before.surfaces, after.forces - before.forces, after.readings - before.readings};
  cost.cpu = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
  Recording recording = recorder.take();
  warn_of_no_contact(recording, console);
  return recording;
}

}  // namespace taxel::cli
