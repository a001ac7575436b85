// Repair of meshes: exact steps on 30000 faces, the union of 180 shells, a wrap at 0.3 mm.
#include <benchmark/benchmark.h>

#include "core/mesh/repair/repair.h"
#include "unit/mesh/broken_mesh.h"

namespace taxel {
namespace {

TriMeshPtr torn_box() {
  return std::make_shared<const TriMesh>(test::torn(test::refined_box(0.01, 50), 2e-8));
}

TriMeshPtr perforated_box() {
  const TriMesh box = test::refined_box(0.01, 50);
  std::vector<int> missing;
  for (int f = 0; f < box.face_count(); f += 97) missing.push_back(f);
  return std::make_shared<const TriMesh>(test::without_faces(box, missing));
}

TriMeshPtr many_balls() {
  test::RandomStream random(3);
  const TriMesh ball = make_icosphere(0.004, 2);
  TriMesh all = ball;
  for (int i = 1; i < 180; ++i)
    all = test::together(all, test::moved(ball, random.uniform(0, 0.03) * random.direction()));
  return std::make_shared<const TriMesh>(std::move(all));
}

void run(benchmark::State& state, const TriMeshPtr& mesh, RepairLevel level) {
  RepairRecipe recipe;
  recipe.level = level;
  recipe.edge = 0.3e-3;
  RepairedMeshPtr repaired;
  for (auto _ : state) repaired = repair_mesh(mesh, recipe, 0.002);
  state.counters["faces_before"] = mesh->face_count();
  state.counters["faces_after"] = repaired->mesh->face_count();
}

void sound(benchmark::State& state) {
  run(state, std::make_shared<const TriMesh>(test::refined_box(0.01, 50)), RepairLevel::automatic);
}
void torn_rim(benchmark::State& state) {
  run(state, torn_box(), RepairLevel::automatic);
}
void holes(benchmark::State& state) {
  run(state, perforated_box(), RepairLevel::automatic);
}
void unite_180_shells(benchmark::State& state) {
  run(state, many_balls(), RepairLevel::automatic);
}
void wrap_fingertip(benchmark::State& state) {
  run(state, std::make_shared<const TriMesh>(make_fingertip()), RepairLevel::wrap);
}
BENCHMARK(sound)->Unit(benchmark::kMillisecond);
BENCHMARK(torn_rim)->Unit(benchmark::kMillisecond);
BENCHMARK(holes)->Unit(benchmark::kMillisecond);
BENCHMARK(unite_180_shells)->Unit(benchmark::kMillisecond);
BENCHMARK(wrap_fingertip)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace taxel

BENCHMARK_MAIN();
