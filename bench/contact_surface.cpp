// Time of one contact surface: our kernel, compared with the brute force of the tests, every tet against every
// triangle.
//
// Each benchmark is a class of sizes on a path: `press` deeper and deeper, `slide` along the body, `roll` around it.
// `primitives` are pairs with tets of very different sizes, half-spaces, and a thin disc whose far face is left out.
// `ratio` is brute force over kernel, on the same poses in the same run.
#include <benchmark/benchmark.h>

#include <chrono>

#include "core/hydro/intersect.h"
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

/// Two bodies and the pose of the second one, which moves to `last`.
struct PrimitivePair {
  const char* name;
  HydroBodyPtr a, b;
  Pose first, last;
};

enum PairNumber {
  fine_on_coarse,
  coarse_under_fine,
  both_fine,
  fine_and_medium,
  rigid_ground,
  thin,
  soft_ground,
  kPairs
};

PrimitivePair make_pair(int number) {
  const auto body = [](ShapeType type, const dvec3& size, double modulus, double edge, double thickness = 0) {
    Material material = soft_material(modulus, thickness);
    material.field = FieldKind::medial_axis;
    return make_simple_body(type, size, material, edge);
  };
  const auto capsule = [&] { return body(ShapeType::capsule, dvec3(0.008, 0.02, 0), 5e4, 0.0006); };
  const auto box = [&] { return body(ShapeType::box, dvec3(0.03, 0.03, 0.01), 2e5, 0.01); };
  const auto ellipsoid = [&] { return body(ShapeType::ellipsoid, dvec3(0.012, 0.01, 0.008), 5e4, 0.0006); };
  const auto sphere = [&](double radius, double edge) { return body(ShapeType::sphere, dvec3(radius), 1e5, edge); };
  const dquat lying = glm::angleAxis(0.5 * kPi, glm::normalize(dvec3(0.1, 1, 0.05)));
  const dquat turned = glm::angleAxis(0.7, glm::normalize(dvec3(0.3, 0.2, 1)));
  const Pose on_box{lying, dvec3(0, 0.0003, 0.0179)}, in_box{lying, dvec3(0.004, 0.0003, 0.017)};
  const Pose on_sphere{turned, dvec3(0, 0.0002, 0.0228)}, in_sphere{turned, dvec3(0.002, 0.0002, 0.0215)};
  const Pose on_ground{turned, dvec3(0, 0, 0.0197)}, in_ground{turned, dvec3(0.004, 0, 0.017)};
  const dquat flat = glm::angleAxis(0.5 * kPi + 0.02, dvec3(0, 1, 0));
  const Pose thin_first{flat, dvec3(0.0078, 0.0003, 0)}, thin_last{flat, dvec3(0.0065, 0.0003, 0.004)};
  switch (number) {
    case fine_on_coarse:
      return {"capsule on box of few tets", capsule(), box(), on_box.inverse(), in_box.inverse()};
    case coarse_under_fine:
      return {"box of few tets under capsule", box(), capsule(), on_box, in_box};
    case both_fine:
      return {"ellipsoid on sphere, 0.6 mm", ellipsoid(), sphere(0.015, 0.0006), on_sphere.inverse(),
              in_sphere.inverse()};
    case fine_and_medium:
      return {"ellipsoid 0.6 mm on sphere 1.2 mm", ellipsoid(), sphere(0.015, 0.0012), on_sphere.inverse(),
              in_sphere.inverse()};
    case rigid_ground:
      return {"sphere on rigid half-space", sphere(0.02, 0.0006), make_simple_body(ShapeType::plane, dvec3(0)),
              on_ground.inverse(), in_ground.inverse()};
    case thin:
      return {"rigid disc of 0.2 mm in capsule", capsule(),
              body(ShapeType::cylinder, dvec3(0.006, 0.0001, 0), 0, 0.0005), thin_first, thin_last};
    default:
      return {"sphere on soft half-space", sphere(0.02, 0.0006), body(ShapeType::plane, dvec3(0), 1e5, 0, 0.01),
              on_ground.inverse(), in_ground.inverse()};
  }
}

/// Measures the time of one surface of two soft primitives, or of one and a half-space, as the mean over the path.
void primitives(benchmark::State& state) {
  const PrimitivePair pair = make_pair(static_cast<int>(state.range(0)));
  ContactSurface surface;
  IntersectWorkspace workspace;
  const auto run = [&](int pose) {
    const double t = pose / (kPoses - 1.0);
    intersect(*pair.a, *pair.b, Pose{}, {pair.first.q, pair.first.p + t * (pair.last.p - pair.first.p)}, surface,
              workspace);
  };
  double polygons = 0;
  for (int i = 0; i < kPoses; ++i) {
    run(i);
    polygons += static_cast<double>(surface.polygons.size()) / kPoses;
  }
  int i = 0;
  for (auto _ : state) run(i++ % kPoses);
  state.SetLabel(pair.name);
  state.counters["polygons"] = polygons;
  state.counters["s_per_polygon"] =
      benchmark::Counter(polygons, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(primitives)->DenseRange(0, kPairs - 1)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
