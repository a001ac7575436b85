// Samples: time on one core and evenness, preview and polished, on smooth, creased and real meshes: a table in
// Markdown.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>

#include "core/layout/poisson_disk.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/primitives.h"
#include "core/project/validation/sample_score.h"

namespace {
using namespace taxel;

/// Processor time of this thread: what other programs do on the machine does not count [ms].
double now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

struct Case {
  std::string name;
  TriMesh mesh;
};

TriMesh skin_of(const std::filesystem::path& file, double scale) {
  const TriMesh mesh = *load_mesh(file, dvec3(scale)).mesh;
  return extract_shells(mesh, outer_shells(mesh));
}

std::vector<Case> cases() {
  const std::filesystem::path own = TAXEL_SOURCE_DIR, real = std::filesystem::path(TAXEL_REAL_DATA) / "meshes";
  std::vector<Case> all;
  all.push_back({"sphere", make_icosphere(0.01, 4)});
  all.push_back({"own fingertip", skin_of(own / "assets/meshes/fingertip.obj", 1.0)});
  all.push_back({"box", make_box(dvec3(0.01, 0.008, 0.015))});
  all.push_back({"plate of 0.4 mm", make_box(dvec3(0.01, 0.01, 0.0002))});
  if (!std::filesystem::exists(real)) {
    fmt::print(stderr, "bench_samples: skipped: the real meshes are not in {}\n", real.string());
    return all;
  }
  all.push_back({"Shadow fingertip", skin_of(real / "shadow_f_distal_pst.stl", 0.001)});
  all.push_back({"BioTac", skin_of(real / "shadow_f_distal_bt_sp.stl", 0.001)});
  all.push_back({"kitchen plate", skin_of(real / "plate_8in_col.stl", 1.0)});
  all.push_back({"Spot", skin_of(real / "spot/spot_triangulated.obj", 0.01)});
  return all;
}

void print_row(const Case& c, int count, SampleQuality quality) {
  const int rounds = count > 50000 ? 2 : 7, per_sample = count > 50000 ? 20 : 100;
  std::vector<double> times;
  std::vector<SurfaceSample> samples;
  for (int round = 0; round < rounds; ++round) {
    const double start = now();
    samples = sample_surface(c.mesh, count, 42, nullptr, quality);
    times.push_back(now() - start);
  }
  std::sort(times.begin(), times.end());
  const SampleScore s = score_samples(c.mesh, samples, per_sample);
  fmt::print("| {} | {} | {} | {:.3g} / {:.3g} | {:.2f} / {:.2f} / {:.2f} | {:.3f} | {:.2f} |\n", c.name, count,
             quality == SampleQuality::preview ? "preview" : "polished", times.front(), times[times.size() / 2],
             s.rho_min, s.rho_5_percent, s.rho_mean, s.area_cv, s.gap);
  std::fflush(stdout);
}

}  // namespace

int main() {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  fmt::print("| mesh | samples | quality | ms: best / median | rho: least / 5 % / mean | area CV | gap |\n");
  fmt::print("| --- | --- | --- | --- | --- | --- | --- |\n");
  for (const Case& c : cases())
    for (const int count : {1000, 10000, 100000})
      for (const SampleQuality quality : {SampleQuality::preview, SampleQuality::polished})
        if (count <= 10000 || c.name == "own fingertip") print_row(c, count, quality);
  return 0;
}
