// Samples: time on one core and evenness, preview and polished, on smooth, creased and real meshes. Prints a table in
// Markdown. bench/samples/run compares it with other samplers:
//   bench_samples                 prints our rows
//   bench_samples export FOLDER   writes the meshes to the folder, for peer.py
//   bench_samples table FOLDER    prints our rows, and those of the points that peer.py wrote to the folder
// A part of a name after the folder selects the meshes whose names contain it.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/validate/sample_score.h"
#include "core/base/files.h"
#include "core/layout/sampling/poisson_disk.h"
#include "core/mesh/make/primitives.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/query/closest_point.h"

namespace {
using namespace taxel;

/// Returns the processor time of this thread, which other programs do not change [ms].
double now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

constexpr std::array kCounts{1000, 10000, 100000};
constexpr int kMost = 10000;                     // largest number of samples of each mesh
constexpr const char* kLarge = "own fingertip";  // mesh without this limit

/// Returns the number of points of the scorer's lattice per sample.
int per_sample(int count) {
  return count > 50000 ? 20 : 100;
}

struct Case {
  std::string name;
  TriMesh mesh;
};

TriMesh skin_of(const std::filesystem::path& file, double scale) {
  const TriMesh mesh = *load_mesh(file, dvec3(scale)).mesh;
  return extract_shells(mesh, outer_shells(mesh));
}

std::vector<Case> every_case() {
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

std::vector<Case> cases(const std::string& part_of_name) {
  std::vector<Case> some = every_case();
  std::erase_if(some, [&](const Case& c) { return c.name.find(part_of_name) == std::string::npos; });
  return some;
}

struct Row {
  std::string method;
  std::size_t got = 0;
  double milliseconds = 0;
  SampleScore score;
};

Row own_row(const Case& c, int count, SampleQuality quality) {
  const int rounds = count > 50000 ? 2 : 7;
  Row row{quality == SampleQuality::preview ? "ours, preview" : "ours, polished", 0, 1e9, {}};
  std::vector<SurfaceSample> samples;
  for (int round = 0; round < rounds; ++round) {
    const double start = now();
    samples = sample_surface(c.mesh, count, 42, nullptr, quality);
    row.milliseconds = std::min(row.milliseconds, now() - start);
  }
  row.got = samples.size();
  row.score = score_samples(c.mesh, samples, per_sample(count));
  return row;
}

/// Returns the rows of other samplers. A line of peers.txt is "mesh|count|method|milliseconds|file of points"; each
/// line of the file of points has x y z.
std::vector<Row> peer_rows(const Case& c, int count, const std::filesystem::path& folder) {
  std::vector<Row> rows;
  std::ifstream list(folder / "peers.txt");
  const MeshIndex index(std::make_shared<TriMesh>(c.mesh));
  for (std::string line; std::getline(list, line);) {
    std::istringstream fields(line);
    std::string mesh, asked, method, milliseconds, file;
    for (std::string* field : {&mesh, &asked, &method, &milliseconds, &file}) std::getline(fields, *field, '|');
    if (mesh != c.name || std::stoi(asked) != count) continue;
    std::ifstream points(folder / file);
    std::vector<SurfacePlace> places;
    for (dvec3 p; points >> p.x >> p.y >> p.z;) {
      const int face = index.closest_point(p).face;
      places.push_back({p, c.mesh.face_normals()[static_cast<std::size_t>(face)]});
    }
    const auto score = score_samples(c.mesh, std::span<const SurfacePlace>(places), per_sample(count));
    rows.push_back({method, places.size(), std::stod(milliseconds), score});
  }
  return rows;
}

/// Prints a row. `polished` is our time for polished samples, to which all times are compared [ms].
void print_row(const Case& c, int count, const Row& row, double polished) {
  const SampleScore& s = row.score;
  fmt::print("| {} | {} / {} | {} | {:.3g} | {:.2f} | {:.2f} / {:.2f} / {:.2f} | {:.3f} | {:.2f} |\n", c.name, count,
             row.got, row.method, row.milliseconds, row.milliseconds / polished, s.rho_min, s.rho_5_percent, s.rho_mean,
             s.area_cv, s.gap);
  std::fflush(stdout);
}

void print_table(const std::vector<Case>& all, const std::filesystem::path& peers) {
  fmt::print(
      "| mesh | samples: asked / got | method | ms | over polished | rho: least / 5 % / mean | area CV | gap |\n");
  fmt::print("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const Case& c : all)
    for (const int count : kCounts) {
      if (count > kMost && c.name != kLarge) continue;
      const Row preview = own_row(c, count, SampleQuality::preview), row = own_row(c, count, SampleQuality::polished);
      print_row(c, count, preview, row.milliseconds);
      print_row(c, count, row, row.milliseconds);
      if (peers.empty()) continue;
      for (const Row& peer : peer_rows(c, count, peers)) print_row(c, count, peer, row.milliseconds);
    }
}

/// Writes NAME.vertices and NAME.faces, and the list of cases to sample, cases.txt, with lines "mesh|count|file".
void export_meshes(const std::vector<Case>& all, const std::filesystem::path& folder) {
  std::string list;
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::string vertices, faces;
    for (const dvec3& p : all[i].mesh.vertices()) vertices += fmt::format("{} {} {}\n", p.x, p.y, p.z);
    for (const ivec3& f : all[i].mesh.faces()) faces += fmt::format("{} {} {}\n", f.x, f.y, f.z);
    write_file_atomically(folder / fmt::format("{}.vertices", i), vertices);
    write_file_atomically(folder / fmt::format("{}.faces", i), faces);
    for (const int count : kCounts)
      if (count <= kMost || all[i].name == kLarge) list += fmt::format("{}|{}|{}\n", all[i].name, count, i);
  }
  write_file_atomically(folder / "cases.txt", list);
}

}  // namespace

int main(int argc, char** argv) {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const std::string task = argc > 2 ? argv[1] : "table";
  const std::filesystem::path folder = argc > 2 ? argv[2] : "";
  const std::string part_of_name = argc > 3 ? argv[3] : "";
  if (task == "export")
    export_meshes(cases(part_of_name), folder);
  else
    print_table(cases(part_of_name), folder);
  return 0;
}
