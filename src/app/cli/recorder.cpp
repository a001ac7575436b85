#include "app/cli/recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <set>
#include <utility>

#include "app/cli/signals.h"
#include "core/base/error.h"
#include "core/base/limits.h"
#include "core/run/recording/recording_files.h"
#include "core/sim/compare/error_bars.h"
#include "core/sim/host/scene_run.h"

namespace taxel::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBase = "unfinished";

}  // namespace

KeptRun::KeptRun(const std::string& out, Console& console) : out_(out), console_(console) {
  if (out.empty()) return;
  const fs::path base = fs::path(out) / kBase;
  const std::string target = fs::absolute(out).lexically_normal().string();
  try {
    if (std::optional<LeftRecording> left = read_recording_journal(base)) {
      left->target = target;  // the journal may come from elsewhere and name any path
      const std::string written = write_left_recording(*left).string();
      console.warn(fmt::format("{}: an earlier run was killed: its {} rows are in {}", out, left->recording.rows.size(),
                               written));
    }
    journal_ = std::make_unique<RecordingJournal>(base, target);
  } catch (const Error& error) {
    console.warn(fmt::format("rows are in memory only until the run ends: {}", error.what()));
  }
}

KeptRun::~KeptRun() {
  if (journal_ && journal_->rows() == 0) remove_journal();
}

void KeptRun::follow(const Recording& recording) {
  if (!journal_) return;
  const bool is_first = journal_->rows() == 0;
  try {
    journal_->follow(recording);
  } catch (const Error& error) {
    if (!std::exchange(has_warned_, true))
      console_.warn(fmt::format("{}: rows after the first {} are in memory only until they can be written",
                                error.what(), journal_->rows()));
  }
  if (is_first && journal_->rows() > 0) set_last_words("the rows so far are in " + remedy());
}

std::vector<std::string> KeptRun::commit(std::optional<OutputFolder>& folder, const Recording& recording,
                                         const std::function<void(OutputFolder&)>& put) {
  if (!folder) return {};
  try {
    put(*folder);
    std::vector<std::string> files = folder->commit();
    if (journal_) remove_journal();
    return files;
  } catch (const Error&) {
    folder->discard();
    follow(recording);
    throw;
  }
}

void KeptRun::remove_journal() {
  set_last_words("");
  journal_->remove();
  journal_.reset();
}

std::string KeptRun::remedy() const {
  const std::string rows = (fs::path(out_) / kBase).string() + ".rows";
  return fmt::format("{0}: `taxel convert {0} FOLDER` writes them as files, and so does the next run with --out {1}",
                     rows, out_);
}

Error KeptRun::explained(const Error& error) const {
  if (!journal_ || journal_->rows() == 0) return error;
  return {error.file(), error.where(),
          fmt::format("{}; the {} rows so far are in {}", error.message(), journal_->rows(), remedy())};
}

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

std::size_t sensor_of(const Recording& recording, const std::string& geom, const std::string& file) {
  const std::vector<RecordedSensor>& sensors = recording.sensors;
  if (sensors.empty()) throw Error(file, "sensor_geoms", "names no sensor");
  std::vector<std::size_t> with_taxels;
  std::string names;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    if (sensors[i].taxel_ids.empty()) {
      if (sensors[i].geom == geom) throw Error(file, fmt::format("geom \"{}\" is soft, but has no taxels", geom));
      continue;
    }
    if (sensors[i].geom == geom) return i;
    names += (with_taxels.empty() ? "" : ", ") + sensors[i].geom;
    with_taxels.push_back(i);
  }
  if (with_taxels.empty()) throw Error(file, "has only soft geoms without taxels");
  if (geom.empty() && with_taxels.size() == 1) return with_taxels.front();
  throw Error(file, geom.empty() ? "has several sensors: name one by --sensor: " + names
                                 : fmt::format("has no sensor \"{}\", but {}", geom, names));
}

RecordedRun read_run(const std::filesystem::path& path, const std::string& geom) {
  RecordedRun run;
  run.file = recording_file(path).string();
  run.recording = read_recording(path);
  run.sensor = sensor_of(run.recording, geom, run.file);
  return run;
}

void load_scene(RecordedRun& run) {
  const std::filesystem::path scene = std::filesystem::path(run.file).parent_path() / "scene.xml";
  std::error_code unknown;
  if (!std::filesystem::exists(scene, unknown))
    throw Error(scene.string(), "is missing: the contact is computed again from the scene next to the recording");
  run.simulator = Simulator::load(scene);
  const SimScene& made = *run.simulator->scene();
  const auto differs = [&](const std::string& what) {
    throw Error(scene.string(), "is not the recorded scene: " + what);
  };
  if (made.sensors.size() != run.recording.sensors.size())
    differs(fmt::format("it has {} sensors, the recording {}", made.sensors.size(), run.recording.sensors.size()));
  for (std::size_t i = 0; i < made.sensors.size(); ++i) {
    const RecordedSensor& recorded = run.recording.sensors[i];
    if (made.sensor_geoms[i] != recorded.geom)
      differs(
          fmt::format("sensor {} is on \"{}\", in the recording on \"{}\"", i, made.sensor_geoms[i], recorded.geom));
    std::vector<int> ids;
    for (const Taxel& taxel : made.sensors[i]->layout.taxels) ids.push_back(taxel.id);
    if (ids != recorded.taxel_ids) differs(fmt::format("the taxels of \"{}\" differ", recorded.geom));
  }
  std::vector<const SceneGeom*> objects;
  for (const SceneGeom& geom : made.geoms)
    if (geom.sensor < 0) objects.push_back(&geom);
  const auto is_same = [](const SceneGeom* geom, const std::string& recorded_name) {
    const bool has_name = geom->label.empty();  // the other names depend on the version of this program
    return !has_name || geom->name == recorded_name;
  };
  if (!std::ranges::equal(objects, run.recording.objects, is_same)) differs("its geoms differ");
}

RowPoses poses_of(const RecordedRun& run, const RecordedRow& row) {
  RowPoses poses;
  for (const SensorRecord& record : row.sensors) poses.X_WM.push_back(record.X_WM);
  std::size_t object = 0;
  for (const SceneGeom& geom : run.simulator->scene()->geoms)
    poses.X_WG.push_back(geom.sensor < 0 ? row.objects[object++] : Pose{});
  return poses;
}

}  // namespace taxel::cli
