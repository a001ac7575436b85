// Geodesic fields: time of one source of 6 mm on real fingertips, how far Euclidean distances are off, and the time to
// assign samples to taxels. With a folder as argument, writes there what bench/geodesics/run gives to its peer.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <ctime>
#include <filesystem>

#include "core/base/files.h"
#include "core/base/rng.h"
#include "core/layout/field/receptive_field.h"
#include "core/mesh/geodesic.h"
#include "core/mesh/mesh_io.h"

namespace {
using namespace taxel;
namespace fs = std::filesystem;

constexpr double kRadius = 0.006;

double processor_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

template <class Body>
double best_of(int times, const Body& body) {
  double best = 1e9;
  for (int i = 0; i < times; ++i) {
    const double start = processor_seconds();
    body();
    best = std::min(best, processor_seconds() - start);
  }
  return best;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/// A face at each vertex, and 100 of the vertices nearest to even samples: sources that the peer can have too.
struct Sources {
  std::vector<int> face_of_vertex, vertices;
};

Sources sources_on(const TriMesh& mesh) {
  Sources sources;
  sources.face_of_vertex.assign(mesh.vertices().size(), -1);
  for (int f = 0; f < mesh.face_count(); ++f)
    for (int c = 0; c < 3; ++c)
      sources.face_of_vertex[static_cast<std::size_t>(mesh.faces()[static_cast<std::size_t>(f)][c])] = f;
  for (const SurfaceSample& s : sample_surface(mesh, 100, 1))
    sources.vertices.push_back(mesh.faces()[static_cast<std::size_t>(s.face)].x);
  return sources;
}

/// Windows and distances to all vertices within the radius, 5 times each, best: in milliseconds, median and mean.
void time_sources(const std::string& name, const TriMeshPtr& mesh, const fs::path& exchange) {
  const auto unfolded = std::make_shared<const UnfoldedMesh>(mesh);
  GeodesicDistance geodesic(unfolded);
  const Sources sources = sources_on(*mesh);
  std::vector<double> times;
  std::string lines;
  double windows = 0.0;
  for (const int v : sources.vertices) {
    const dvec3& from = mesh->vertices()[static_cast<std::size_t>(v)];
    std::vector<double> distances(mesh->vertices().size());
    times.push_back(1e3 * best_of(5, [&] {
                      geodesic.propagate(sources.face_of_vertex[static_cast<std::size_t>(v)], from, kRadius);
                      for (std::size_t w = 0; w < distances.size(); ++w)
                        distances[w] = geodesic.to(sources.face_of_vertex[w], mesh->vertices()[w]);
                    }));
    windows += geodesic.window_count();
    for (std::size_t w = 0; w < distances.size(); ++w)
      if (distances[w] <= kRadius) lines += fmt::format("{} {} {} {}\n", v, w, distances[w], times.back());
  }
  double sum = 0.0;
  for (const double t : times) sum += t;
  const auto count = static_cast<double>(times.size());
  fmt::print("{} ({} triangles): one source of 6 mm {:.3f} ms in the median, {:.3f} in the mean, {:.0f} windows\n",
             name, mesh->face_count(), median(times), sum / count, windows / count);
  std::vector<double> whole;
  for (std::size_t i = 0; i < 5; ++i) {
    const auto v = static_cast<std::size_t>(sources.vertices[i]);
    whole.push_back(1e3 * best_of(2, [&] {
                      geodesic.propagate(sources.face_of_vertex[v], mesh->vertices()[v],
                                         std::numeric_limits<double>::infinity());
                    }));
  }
  fmt::print("{}: one source over the whole mesh {:.1f} ms\n", name, median(whole));
  if (exchange.empty()) return;
  std::string vertices, faces;
  for (const dvec3& p : mesh->vertices()) vertices += fmt::format("{} {} {}\n", p.x, p.y, p.z);
  for (const ivec3& f : mesh->faces()) faces += fmt::format("{} {} {}\n", f.x, f.y, f.z);
  write_file_atomically(exchange / (name + ".vertices"), vertices);
  write_file_atomically(exchange / (name + ".faces"), faces);
  write_file_atomically(exchange / (name + ".distances"), lines);
}

/// How much longer shortest paths are than straight ways, over samples 1 to 6 mm apart by path, outside of one face.
void tell_difference(const std::string& name, const TriMeshPtr& mesh) {
  GeodesicDistance geodesic(std::make_shared<const UnfoldedMesh>(mesh));
  const std::vector<SurfaceSample> samples = sample_surface(*mesh, 2000, 2);
  double sum = 0.0, worst = 0.0;
  int pairs = 0, lost = 0, gathered = 0;
  for (std::size_t i = 0; i < samples.size(); i += 20) {
    geodesic.propagate(samples[i].face, samples[i].position, kRadius);
    for (const SurfaceSample& s : samples) {
      const double d = geodesic.to(s.face, s.position), straight = glm::distance(s.position, samples[i].position);
      gathered += straight <= kRadius;
      lost += straight <= kRadius && d > kRadius;
      if (!(d >= 0.001 && d <= kRadius)) continue;
      sum += (d - straight) / d;
      worst = std::max(worst, (d - straight) / d);
      ++pairs;
    }
  }
  fmt::print(
      "{}: straight ways of 1 to 6 mm are shorter by {:.1f} % in the mean, {:.0f} % at most; {:.0f} % of the samples "
      "within 6 mm are farther by path\n",
      name, 100 * sum / pairs, 100 * worst, 100.0 * lost / gathered);
}

/// Taxels at even samples; radius 6 mm for 12 and, as dense arrays have them, 2 mm for 700.
void time_assignment(const std::string& name, const MeshIndex& skin) {
  const std::vector<SurfaceSample> samples = sample_surface(skin.mesh(), 16000, 42);
  for (const auto& [count, radius] : {std::pair(12, 0.006), std::pair(700, 0.002), std::pair(700, 0.006)}) {
    Layout layout;
    for (const SurfaceSample& s : sample_surface(skin.mesh(), count, 3))
      layout.taxels.push_back({static_cast<int>(layout.taxels.size()), "", s.position, s.normal, radius, {}});
    for (const Metric metric : {Metric::euclidean, Metric::geodesic}) {
      layout.receptive_field.metric = metric;
      std::size_t entries = 0;
      const double seconds = best_of(5, [&] { entries = make_receptive_fields(layout, samples, skin).entries.size(); });
      fmt::print("{}: 16000 samples to {} taxels of {} mm, {}: {:.2f} ms on one thread, {} entries\n", name, count,
                 1e3 * radius, metric == Metric::geodesic ? "geodesic" : "euclidean", 1e3 * seconds, entries);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const fs::path exchange = argc > 1 ? argv[1] : "";
  const fs::path real = fs::path(TAXEL_REAL_DATA) / "meshes";
  for (const auto& [name, file, scale] :
       {std::tuple("shadow", real / "shadow_f_distal_pst.stl", 1e-3),
        std::tuple("biotac", real / "shadow_f_distal_bt_sp.stl", 1e-3),
        std::tuple("fingertip", fs::path(TAXEL_SOURCE_DIR) / "assets/meshes/fingertip.obj", 1.0)}) {
    if (!fs::exists(file)) {
      fmt::print("{}: skipped: {} is absent\n", name, file.string());
      continue;
    }
    const LoadedMesh loaded = load_mesh(file, dvec3(scale));
    const auto skin = std::make_shared<TriMesh>(extract_shells(*loaded.mesh, outer_shells(*loaded.mesh)));
    time_sources(name, skin, exchange);
    tell_difference(name, skin);
    time_assignment(name, MeshIndex(skin));
  }
  return 0;
}
