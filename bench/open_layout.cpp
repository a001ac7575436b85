// Waiting times of a user: from opening a layout to the first reading on preview samples and on polished samples, and
// from an edit of one taxel to the next model. For comparison, the times without a preview and without a cache. Layouts
// are our own fingertip and those in the arguments. Prints a table in Markdown.
//
//   bench_open_layout [--threads N] [LAYOUT.taxels.json ...]
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <optional>

#include "core/base/error.h"
#include "core/hydro/intersect.h"
#include "core/layout/file/layout_json.h"
#include "core/mesh/mesh_io.h"
#include "core/sensor/readout/reading.h"
#include "core/sensor/sensor_model.h"
#include "layout_arguments.h"

namespace {
using namespace taxel;
using Clock = std::chrono::steady_clock;

/// Wall time, and processor time of all threads, which other programs on the machine do not change [ms].
struct Times {
  std::vector<double> wall, processor;
  [[nodiscard]] static double middle(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
  }
};

class Watch {
 public:
  /// Adds the time since this watch was made.
  void stop(Times& times) const {
    times.wall.push_back(std::chrono::duration<double, std::milli>(Clock::now() - began_).count());
    times.processor.push_back(processor() - spent_);
  }

 private:
  static double processor() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
  }
  Clock::time_point began_ = Clock::now();
  double spent_ = processor();
};

/// A ball pressed 1 mm into the skin at the first taxel.
double first_reading(const SensorModel& model) {
  const double radius = 0.01, depth = 0.001;
  const HydroBodyPtr ball = make_body({ShapeType::sphere, dvec3(radius)}, Material{.friction = 0.5}, "ball");
  const Taxel& taxel = model.layout.taxels.front();
  const SurfacePoint at = model.skin->closest_point(taxel.center);
  Pose X_WB;
  X_WB.p = at.position + (radius - depth) * model.skin->mesh().face_normals()[static_cast<std::size_t>(at.face)];
  ContactSurface surface;
  IntersectWorkspace workspace;
  intersect(*model.body, *ball, Pose{}, X_WB, surface, workspace);
  SensorReading reading;
  const ContactSurface* surfaces[] = {&surface};
  read_sensor(model, surfaces, reading);
  return reading.values.front();
}

double open(const std::filesystem::path& file, SensorCache* cache, SampleQuality quality) {
  SensorBuild how;
  how.cache = cache;
  how.quality = quality;
  return first_reading(*load_sensor_model(file, how));
}

struct Result {
  Times uncached, preview, polished, edit, uncached_edit;
  std::size_t samples = 0, taxels = 0;
};

void measure_once(const std::filesystem::path& file, Result& result) {
  std::optional<Watch> watch;
  watch.emplace();
  open(file, nullptr, SampleQuality::polished);
  watch->stop(result.uncached);

  SensorCache cache;
  SensorBuild how;
  how.cache = &cache;
  watch.emplace();
  open(file, &cache, SampleQuality::preview);
  watch->stop(result.preview);
  open(file, &cache, SampleQuality::polished);  // measured by the same watch, since the file was opened
  watch->stop(result.polished);

  Layout layout = read_layout(file);
  const LoadedMesh loaded = load_mesh(mesh_path(layout, file), layout.mesh.scale);
  for (int i = 1; i <= 5; ++i) {
    layout.taxels.front().center += dvec3(0, 0, 1e-4);
    watch.emplace();
    const auto model = build_sensor_model(layout, loaded.mesh, loaded.sha256, file.string(), how);
    watch->stop(result.edit);
    result.samples = model->samples.size();
    result.taxels = layout.taxels.size();
  }
  watch.emplace();
  build_sensor_model(layout, loaded.mesh, loaded.sha256, file.string());
  watch->stop(result.uncached_edit);
}

void print_row(const char* what, const Times& times, const Times& peer) {
  const double wall = Times::middle(times.wall), processor = Times::middle(times.processor);
  fmt::print("| {} | {:.4g} | {:.4g} | {:.3g} |\n", what, wall, processor, Times::middle(peer.processor) / processor);
}

void print_result(const std::filesystem::path& file) {
  const int rounds = 5;
  Result result;
  for (int i = 0; i < rounds; ++i) measure_once(file, result);
  fmt::print("\n{}: {} taxels, {} samples\n\n", file.filename().string(), result.taxels, result.samples);
  fmt::print("| from | ms | ms of all processors | times less than uncached |\n| --- | --- | --- | --- |\n");
  print_row("opening to a reading, uncached", result.uncached, result.uncached);
  print_row("opening to a reading on preview samples", result.preview, result.uncached);
  print_row("opening to a reading on polished samples, by way of the preview", result.polished, result.uncached);
  print_row("an edit to the next model, uncached", result.uncached_edit, result.uncached_edit);
  print_row("an edit to the next model", result.edit, result.uncached_edit);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const bench::LayoutArguments arguments(argc, argv);
  try {
    for (const std::filesystem::path& file : arguments.files) print_result(file);
  } catch (const Error& error) {
    fmt::print(stderr, "bench_open_layout: {}\n", error.what());
    return 2;
  }
  return 0;
}
