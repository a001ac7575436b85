// Latency from an edit of the layout to the new reading of a pressed probe. As in the window, the edit is applied, the
// model is compiled with the cache of the last model, the probe is pressed, and the taxels are read. This is measured
// in one thread, and through the window's workers: history, hand-over, and back to the thread that draws. 12 taxels on
// 16 000 samples; 200 different edits that move, resize, add and delete, each followed by the reading. Layouts are our
// own fingertip and those in the arguments. Prints a table in Markdown.
//
//   bench_edit_latency [--threads N] [LAYOUT.taxels.json ...]
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <mutex>

#include "../layout_arguments.h"
#include "app/studio/host/document/edit_session.h"
#include "app/studio/host/jobs/job_executor.h"
#include "app/studio/nouns/probe/probe_job.h"
#include "core/base/error.h"
#include "core/base/rng.h"
#include "core/document/edit.h"
#include "core/layout/file/layout_json.h"
#include "core/mesh/mesh_io.h"
#include "core/sensor/probe/probe.h"

namespace {
using namespace taxel;
using Clock = std::chrono::steady_clock;

constexpr int kEdits = 200;
constexpr std::size_t kTaxels = 12;
constexpr double kSamples = 16000;
constexpr double kMedianTarget = 50, kWorstTarget = 80;  // issue: median, 95 % [ms]

/// The stages of one edit, and the whole edit.
enum Stage { kEdit, kModel, kPress, kAll, kWindow, kStages };
constexpr std::array<const char*, kStages> kStageNames{"the edit", "the model", "press and reading", "all in a row",
                                                       "all through the window's workers"};

/// Wall time, and processor time of all threads, which other programs on the machine change less [ms].
struct Time {
  double wall = 0, processor = 0;
  static Time now() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return {std::chrono::duration<double, std::milli>(Clock::now().time_since_epoch()).count(),
            1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec)};
  }
  Time operator-(const Time& b) const { return {wall - b.wall, processor - b.processor}; }
};

double quantile(const std::vector<Time>& times, double Time::*which, double part) {
  std::vector<double> values;
  for (const Time& time : times) values.push_back(time.*which);
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<std::size_t>(part * static_cast<double>(values.size())))];
}

/// The edited project, and its mesh, which does not change.
struct Document {
  Project project;
  LoadedMesh mesh;
  std::string file;
};

/// The layout with 16 000 samples and twelve of its taxels.
Document open_document(const std::filesystem::path& file, Metric metric) {
  Document document{{}, {}, file.string()};
  Layout& layout = document.project.layout;
  layout = read_layout(file);
  document.mesh = load_mesh(mesh_path(layout, file), layout.mesh.scale);
  if (layout.taxels.size() < kTaxels)
    throw Error(document.file, "/taxels", fmt::format("must be {} or more, are {}", kTaxels, layout.taxels.size()));
  layout.taxels.resize(kTaxels);
  layout.receptive_field.metric = metric;
  const SensorSkinPtr skin = make_sensor_skin(document.mesh.mesh, layout.sampling.shells);
  layout.sampling.density = kSamples / skin->sensed->mesh().area();
  return document;
}

/// Edit number i: taxels slide by up to a millimetre along the skin, get another radius, and one is added, which the
/// next edit deletes.
Edit edit_of(int i, const Project& project, const MeshIndex& skin) {
  const CounterRng rng(42, static_cast<std::uint64_t>(i));
  const std::vector<Taxel>& taxels = project.layout.taxels;
  const Taxel& taxel = taxels[static_cast<std::size_t>(rng.uniform(0) * static_cast<double>(taxels.size()))];
  const dvec3 step(rng.uniform(1) - 0.5, rng.uniform(2) - 0.5, rng.uniform(3) - 0.5);
  const SurfacePoint at = skin.closest_point(taxel.center + 2e-3 * step);
  const dvec3 normal = skin.mesh().face_normals()[static_cast<std::size_t>(at.face)];
  switch (i % 4) {
    case 0:
      return SetTaxels{{{taxel.id, {}, at.position, normal, {}, {}, {}}}};
    case 1:
      return SetTaxels{{{taxel.id, {}, {}, {}, taxel.radius * (0.9 + 0.2 * rng.uniform(4)), {}, {}}}};
    case 2:
      return AddTaxels{{{unused_ids(project.layout, 1).front(), "", at.position, normal, taxel.radius, {}}},
                       std::nullopt};
    default:
      return DeleteTaxels{{taxels.back().id}};
  }
}

/// A ball of 5 mm radius pressed 1 mm into the skin at the first taxel.
Probe probe_of(const Project& project) {
  Probe probe;
  probe.point = project.layout.taxels.front().center;
  return probe;
}

struct Result {
  std::array<std::vector<Time>, kStages> stages;
  std::size_t samples = 0, rays = 0, polygons = 0;
};

Result measure(Document document) {
  Result result;
  SensorCache cache;
  SensorBuild how;
  how.cache = &cache;
  const auto build = [&] {
    return build_sensor_model(document.project.layout, document.mesh.mesh, document.mesh.sha256, document.file, how);
  };
  ProbePress pressed;
  SensorModelPtr model = build();
  const Probe probe = probe_of(document.project);
  press(*model, probe, pressed);
  for (int i = 0; i < kEdits; ++i) {
    const Edit edit = edit_of(i, document.project, *model->skin);
    const Time start = Time::now();
    document.project = apply_edit(document.project, edit);
    const Time applied = Time::now();
    model = build();
    const Time built = Time::now();
    press(*model, probe, pressed);
    const Time read = Time::now();
    result.stages[kEdit].push_back(applied - start);
    result.stages[kModel].push_back(built - applied);
    result.stages[kPress].push_back(read - built);
    result.stages[kAll].push_back(read - start);
  }
  result.samples = model->samples.size();
  result.rays = model->rays.size();
  result.polygons = pressed.surface.polygons.size();
  return result;
}

/// A signal for which the drawing thread waits.
class Bell {
 public:
  void ring() {
    {
      const std::lock_guard lock(mutex_);
      rung_ = true;
    }
    heard_.notify_all();
  }
  void wait() {
    std::unique_lock lock(mutex_);
    heard_.wait(lock, [this] { return rung_; });
    rung_ = false;
  }

 private:
  std::mutex mutex_;
  std::condition_variable heard_;
  bool rung_ = false;
};

/// Measures the same edits, each until model and reading are in the thread that requested them.
std::vector<Time> measure_hand_over(const Document& document) {
  Bell bell;
  SensorCache cache;
  studio::JobPool pool;
  pool.set_wake([&] { bell.ring(); });
  studio::ProbeJob probe(pool);
  studio::EditSession edits(pool, cache, [&](const SensorModelPtr& model) { probe.model_built(model); });
  SensorBuild how;
  how.cache = &cache;
  SensorModelPtr model =
      build_sensor_model(document.project.layout, document.mesh.mesh, document.mesh.sha256, document.file, how);
  edits.open(std::make_shared<const Project>(document.project),
             std::make_shared<const studio::OpenMesh>(document.mesh, MeshFindings{}), document.file, "");
  const Probe request = probe_of(document.project);
  probe.press(model, request);
  probe.wait();
  std::vector<Time> times;
  for (int i = 0; i < kEdits; ++i) {
    const Edit edit = edit_of(i, *edits.project(), *model->skin);
    const Time start = Time::now();
    edits.edit(edit);
    while (true) {
      bell.wait();
      SensorModelPtr built = edits.take_model();
      if (!built) continue;
      model = std::move(built);
      probe.press(model, request);
      if (const ui::PressedProbePtr pressed = probe.newest(); pressed && pressed->model == model) break;
    }
    times.push_back(Time::now() - start);
  }
  return times;
}

void print_result(const std::filesystem::path& file, Metric metric) {
  Result result = measure(open_document(file, metric));
  result.stages[kWindow] = measure_hand_over(open_document(file, metric));
  fmt::print("\n{}, {}: {} taxels, {} samples, {} rays, {} polygons, {} edits\n\n", file.filename().string(),
             metric == Metric::geodesic ? "geodesic" : "euclidean", kTaxels, result.samples, result.rays,
             result.polygons, kEdits);
  fmt::print(
      "| ms | median | 95 % | longest | of all processors, median | 95 % |\n| --- | --- | --- | --- | --- | --- |\n");
  for (std::size_t s = 0; s < kStages; ++s) {
    const auto of = [&](double Time::*which, double part) { return quantile(result.stages[s], which, part); };
    fmt::print("| {} | {:.3g} | {:.3g} | {:.3g} | {:.3g} | {:.3g} |\n", kStageNames[s], of(&Time::wall, 0.5),
               of(&Time::wall, 0.95), of(&Time::wall, 1), of(&Time::processor, 0.5), of(&Time::processor, 0.95));
  }
  fmt::print("| target | {} | {} | | | |\n", kMedianTarget, kWorstTarget);
  std::fflush(stdout);
}

/// Prints the number of programs that recently needed a processor, as counted by the system (load).
void print_load(const char* when) {
  std::array<double, 3> load{};
  if (getloadavg(load.data(), 3) == 3) fmt::print("\nLoad {}: {:.1f} (one minute).\n", when, load[0]);
}

}  // namespace

int main(int argc, char** argv) {
  const bench::LayoutArguments arguments(argc, argv);
  try {
    print_load("before");
    for (const std::filesystem::path& file : arguments.files)
      for (const Metric metric : {Metric::euclidean, Metric::geodesic}) print_result(file, metric);
    print_load("after");
  } catch (const Error& error) {
    fmt::print(stderr, "bench_edit_latency: {}\n", error.what());
    return 2;
  }
  return 0;
}
