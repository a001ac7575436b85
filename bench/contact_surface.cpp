// Time of one contact surface: our kernel, compared with the brute force of the tests, every tet against every
// triangle.
//
// Each benchmark is a class of sizes on a path: `press` deeper and deeper, `slide` along the body, `roll` around it.
// `ratio` is brute force over kernel, on the same poses in the same run.
#include <benchmark/benchmark.h>

#include <chrono>

#include "fixtures/brute_force_contact.h"
#include "fixtures/hydro_bodies.h"

namespace {
using namespace taxel;

constexpr double kRadius = 0.02, kHalf = 0.03, kOther = 0.016, kModulus = 5e4;  // two capsules [m], [Pa]
constexpr int kPoses = 20;

/// Returns a capsule of at most about `faces` triangles.
TriMesh capsule(double radius, int faces) {
  double fine = 0.01 * radius, coarse = 2 * radius;
  for (int i = 0; i < 40; ++i) {
    const double edge = 0.5 * (fine + coarse);
    (make_capsule(radius, kHalf, edge).face_count() > faces ? fine : coarse) = edge;
  }
  return make_capsule(radius, kHalf, coarse);
}

HydroBodyPtr soft_capsule(int tets) {
  Material material = soft_material(kModulus);
  material.field = FieldKind::star;
  return make_mesh_body(capsule(kRadius, tets), material);
}

enum Path { press, slide, roll };

/// Returns the pose of the rigid capsule: across the soft one, and slightly rotated.
Pose rigid_pose(Path path, double t) {
  const double depth = path == press ? 0.0002 + 0.0018 * t : 0.0015;
  const double along = path == press ? 0.003 : 0.02 * (t - 0.5);
  const dquat across = glm::angleAxis(0.5 * kPi, dvec3(1, 0, 0)) * glm::angleAxis(0.3, dvec3(0, 0, 1));
  const dquat turn = glm::angleAxis(path == roll ? along / kOther : 0.0, dvec3(0, 1, 0));
  return {turn * across, dvec3(kRadius + kOther - depth, 0.002, along)};
}

std::vector<Pose> poses_of(Path path) {
  std::vector<Pose> poses;
  for (int i = 0; i < kPoses; ++i) poses.push_back(rigid_pose(path, i / (kPoses - 1.0)));
  return poses;
}

struct Case {
  HydroBodyPtr soft, rigid;
  std::vector<Pose> poses;
  ContactSurface surface;
  IntersectWorkspace workspace;

  explicit Case(const benchmark::State& state)
      : soft(soft_capsule(static_cast<int>(state.range(0)))),
        rigid(make_mesh_body(capsule(kOther, static_cast<int>(state.range(1))))),
        poses(poses_of(static_cast<Path>(state.range(2)))) {}

  /// Reports the actual sizes of the class.
  void describe(benchmark::State& state) const {
    constexpr const char* kNames[] = {"press", "slide", "roll"};
    state.SetLabel(kNames[state.range(2)]);
    state.counters["real_tets"] = static_cast<double>(std::get<SoftBody>(soft->geometry).field->tets().size());
    state.counters["real_triangles"] = std::get<RigidMesh>(rigid->geometry).index->mesh().face_count();
  }
  void run(std::size_t pose) { intersect(*soft, *rigid, Pose{}, poses[pose], surface, workspace); }
  [[nodiscard]] double mean_polygons() {
    double sum = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      run(i);
      sum += static_cast<double>(surface.polygons.size());
    }
    return sum / kPoses;
  }
};

/// Measures the time of one surface, as the mean over the path.
void contact_surface(benchmark::State& state) {
  Case c(state);
  state.counters["polygons"] = c.mean_polygons();
  c.describe(state);
  std::size_t i = 0;
  for (auto _ : state) c.run(i++ % kPoses);
}

/// Measures the time of one brute-force surface at the middle of the path, and that of the kernel at the same pose.
void brute_force(benchmark::State& state) {
  Case c(state);
  const std::size_t middle = kPoses / 2;
  const PressureField& field = *std::get<SoftBody>(c.soft->geometry).field;
  const TriMesh& mesh = std::get<RigidMesh>(c.rigid->geometry).index->mesh();
  using Clock = std::chrono::steady_clock;
  BruteForceContact found;
  double seconds = 0;
  for (auto _ : state) {
    const auto start = Clock::now();
    found = brute_force_contact(field, mesh, c.poses[middle]);
    seconds += std::chrono::duration<double>(Clock::now() - start).count();
  }
  c.run(middle);
  constexpr int kRepeats = 100;
  const auto start = Clock::now();
  for (int i = 0; i < kRepeats; ++i) c.run(middle);
  const double ours = std::chrono::duration<double>(Clock::now() - start).count() / kRepeats;
  c.describe(state);
  state.counters["ratio"] = seconds / static_cast<double>(state.iterations()) / ours;
  state.counters["polygons"] = found.polygons;
  state.counters["area_difference"] = std::abs(c.surface.area() / found.area - 1);
}

void classes(benchmark::internal::Benchmark* b) {
  b->ArgNames({"tets", "triangles", "path"});
  for (const Path path : {press, slide, roll}) {
    b->Args({2000, 8000, path});
    b->Args({2000, 20000, path});
    b->Args({20000, 20000, path});
  }
}
void one_path(benchmark::internal::Benchmark* b) {
  b->ArgNames({"tets", "triangles", "path"});
  b->Args({2000, 8000, slide})->Args({2000, 20000, slide})->Args({20000, 20000, slide});
}
BENCHMARK(contact_surface)->Apply(classes)->Unit(benchmark::kMicrosecond);
BENCHMARK(brute_force)->Apply(one_path)->Iterations(1)->Unit(benchmark::kMicrosecond);

/// Measures the cost of a pair without contact, whose boxes do not overlap.
void no_contact(benchmark::State& state) {
  Case c(state);
  const Pose far{dquat(1, 0, 0, 0), dvec3(1, 0, 0)};
  for (auto _ : state) intersect(*c.soft, *c.rigid, Pose{}, far, c.surface, c.workspace);
}
BENCHMARK(no_contact)->Args({20000, 20000, press})->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
