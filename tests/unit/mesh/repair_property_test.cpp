// Repair of meshes that were broken at random: it never refuses, never hangs, and always ends with a closed solid.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "core/mesh/mesh_io.h"
#include "core/mesh/repair/repair.h"
#include "unit/mesh/broken_mesh.h"

namespace taxel {
namespace {

TriMesh sound_mesh(int kind) {
  if (kind == 0) return make_icosphere(0.01, 2);
  if (kind == 1) return test::refined_box(0.01, 5);
  if (kind == 2) return test::hollow_sphere(0.01, 0.006);
  return test::closed_ring_of_cubes(0.005);
}

/// Deletes, doubles, turns, folds and tears faces, and adds faces between any three vertices.
TriMesh broken_mesh(std::uint64_t seed, bool with_walls) {
  test::RandomStream random(seed);
  const TriMesh sound = sound_mesh(static_cast<int>(seed % 4));
  std::vector<ivec3> faces = sound.faces();
  std::vector<dvec3> vertices = sound.vertices();
  const auto any_vertex = [&] { return random.below(static_cast<int>(vertices.size())); };
  for (int left = 1 + random.below(12); left > 0 && faces.size() > 4; --left) {
    const auto i = test::slot(random.below(static_cast<int>(faces.size())));
    const ivec3 turned(faces[i].x, faces[i].z, faces[i].y), wall(any_vertex(), any_vertex(), any_vertex());
    switch (random.below(with_walls ? 6 : 5)) {
      case 0:
        faces.erase(faces.begin() + static_cast<std::ptrdiff_t>(i));
        break;
      case 1:
        faces.push_back(faces[i]);
        break;
      case 2:
        faces[i] = turned;
        break;
      case 3:
        faces.push_back(turned);
        break;
      case 4:
        vertices.push_back(vertices[test::slot(faces[i].x)] + random.in_cube(1e-7));
        faces[i].x = static_cast<int>(vertices.size()) - 1;
        break;
      default:
        if (glm::length(glm::cross(vertices[test::slot(wall.y)] - vertices[test::slot(wall.x)],
                                   vertices[test::slot(wall.z)] - vertices[test::slot(wall.x)])) > 1e-9)
          faces.push_back(wall);
    }
  }
  return {std::move(vertices), std::move(faces)};
}

RepairedMeshPtr repair(const TriMesh& mesh) {
  RepairRecipe recipe;
  recipe.edge = 1e-3;
  return repair_mesh(std::make_shared<const TriMesh>(mesh), recipe, 0.002);
}

/// The mesh after a round trip through a file, which welds parted vertices and rounds to floats.
TriMeshPtr through_stl(const TriMesh& mesh) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "repair_property.stl";
  save_mesh(path, mesh);
  return load_mesh(path).mesh;
}

TEST(RepairProperty, ClosesMeshesThatLostDoubledTurnedOrTornFaces) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const TriMesh sound = sound_mesh(static_cast<int>(seed % 4));
    const RepairedMeshPtr repaired = repair(broken_mesh(seed, false));
    ASSERT_TRUE(repaired->mesh->closed());
    EXPECT_EQ(repair_mesh(repaired->mesh, {}, 0.002)->mesh, repaired->mesh);
    // The ring has 44 faces: some seeds break every fourth of them, and no side of it can be told from the other.
    if (seed % 4 == 3 && repaired->report.level == RepairLevel::wrap) continue;
    EXPECT_NE(repaired->report.level, RepairLevel::wrap);
    EXPECT_NEAR(repaired->mesh->volume(), sound.volume(), 0.15 * sound.volume());
    const TriMeshPtr read = through_stl(*repaired->mesh);
    EXPECT_EQ(repair(*read)->mesh->face_count(), repaired->mesh->face_count());
  }
}

TEST(RepairProperty, ClosesMeshesWithWallsInAnyPlace) {
  for (std::uint64_t seed = 1000; seed < 1040; ++seed) {
    SCOPED_TRACE(seed);
    const RepairedMeshPtr repaired = repair(broken_mesh(seed, true));
    ASSERT_TRUE(repaired->mesh->closed());
    EXPECT_GT(repaired->mesh->volume(), 0);
  }
}

TEST(RepairProperty, GivesTheSameBytesOnAnyNumberOfThreads) {
  for (const std::uint64_t seed : {5U, 1003U, 1021U}) {
    const TriMesh broken = broken_mesh(seed, seed >= 1000);
    std::vector<RepairedMeshPtr> results;
    for (const std::size_t threads : {1U, 8U}) {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      results.push_back(repair(broken));
    }
    EXPECT_EQ(results[0]->mesh->vertices(), results[1]->mesh->vertices());
    EXPECT_EQ(results[0]->mesh->faces(), results[1]->mesh->faces());
    EXPECT_EQ(results[0]->loaded_face_of, results[1]->loaded_face_of);
    EXPECT_EQ(results[0]->report.distance_rms, results[1]->report.distance_rms);
  }
}

TEST(RepairProperty, IsNotQuadraticInShells) {
  // 3000 separate tets with a fin each: a scan per shell or per fin would take minutes.
  std::vector<dvec3> vertices;
  std::vector<ivec3> faces;
  for (int i = 0; i < 3000; ++i) {
    const int first = static_cast<int>(vertices.size());
    const dvec3 at_place = 0.003 * dvec3(i % 20, i / 20 % 20, i / 400);
    for (const dvec3& v : {dvec3(0), dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1), dvec3(1, 1, 0.1)})
      vertices.push_back(at_place + 0.001 * v);
    for (const ivec3& f : {ivec3(0, 2, 1), ivec3(0, 1, 3), ivec3(0, 3, 2), ivec3(1, 2, 3)}) faces.push_back(f + first);
    if (i % 40 == 0) faces.push_back(ivec3(1, 4, 2) + first);
  }
  const RepairedMeshPtr repaired = repair(TriMesh(vertices, faces));
  EXPECT_TRUE(repaired->mesh->closed());
  EXPECT_EQ(repaired->mesh->shell_count(), 3000);
  EXPECT_EQ(repaired->mesh->face_count(), 12000);
  EXPECT_LT(repaired->report.seconds, 20);  // 0.2 s on a machine that does nothing else
}

}  // namespace
}  // namespace taxel
