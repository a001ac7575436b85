// The repair of randomly broken meshes always gives a closed solid, without an error.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <set>

#include "core/mesh/mesh_io.h"
#include "core/mesh/repair/repair.h"
#include "core/mesh/repair/steps.h"
#include "unit/mesh/broken_mesh.h"

namespace taxel {
namespace {

TriMesh sound_mesh(int kind) {
  if (kind == 0) return make_icosphere(0.01, 2);
  if (kind == 1) return test::refined_box(0.01, 5);
  if (kind == 2) return test::hollow_sphere(0.01, 0.006);
  return test::closed_ring_of_cubes(0.005);
}

/// Deletes, doubles, reverses, folds and tears faces, and adds faces between any three vertices.
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

/// Returns the mesh after a round trip through a file, which merges separated vertices and rounds to floats.
TriMeshPtr through_stl(const TriMesh& mesh) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "repair_property.stl";
  save_mesh(path, mesh);
  return load_mesh(path).mesh;
}

TEST(RepairProperty, ClosesMeshesWithMissingDoubledReversedOrTornFaces) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const TriMesh sound = sound_mesh(static_cast<int>(seed % 4));
    const RepairedMeshPtr repaired = repair(broken_mesh(seed, false));
    ASSERT_TRUE(repaired->mesh->closed());
    EXPECT_EQ(repair_mesh(repaired->mesh, {}, 0.002)->mesh, repaired->mesh);
    // The ring has 44 faces. With some seeds every fourth face is broken, so that its two sides cannot be
    // distinguished.
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
  // 3000 separate tets with a fin each. A scan per shell or per fin would take minutes.
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
  EXPECT_LT(repaired->report.seconds, 20);  // 0.2 s on an idle machine
}

/// Returns two tets on either side of the plane z = 0 that share the edge from (0, 0, 0) to (1, 0, 0). One face of each
/// tet is in this plane: both faces are at the same angle around the edge, and their third corners differ.
TriMesh touching_tets() {
  return test::welded(test::together(
      TriMesh({{0, 0, 0}, {1, 0, 0}, {0.2, 1, 0}, {0.4, 0.3, 0.5}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}),
      TriMesh({{0, 0, 0}, {1, 0, 0}, {0.7, 0.8, 0}, {0.4, 0.3, -0.6}}, {{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}})));
}

/// Returns the mesh with its faces in another order, each beginning with another corner.
TriMesh shuffled(const TriMesh& mesh, std::uint64_t seed) {
  test::RandomStream random(seed);
  std::vector<ivec3> faces = mesh.faces();
  for (std::size_t i = faces.size(); i > 1; --i)
    std::swap(faces[i - 1], faces[test::slot(random.below(static_cast<int>(i)))]);
  for (ivec3& f : faces)
    for (int turns = random.below(3); turns > 0; --turns) f = {f.y, f.z, f.x};
  return {mesh.vertices(), std::move(faces)};
}

/// Returns the shells into which surfaces are separated, by the positions of their corners. The numbers of faces and
/// points have no effect.
std::multiset<std::multiset<std::vector<double>>> parted_shells(const TriMesh& mesh) {
  Draft draft = make_draft(mesh);
  RepairChanges changes;
  part_touching(draft, changes);
  std::multiset<std::multiset<std::vector<double>>> shells;
  for (const std::vector<int>& shell : find_shells(draft).faces) {
    std::multiset<std::vector<double>> faces;
    for (const int f : shell) {
      std::vector<std::vector<double>> turns;
      for (int first = 0; first < 3; ++first) {
        turns.emplace_back();
        for (int c = 0; c < 3; ++c) {
          const dvec3& p = draft.corner(f, (first + c) % 3);
          turns.back().insert(turns.back().end(), {p.x, p.y, p.z});
        }
      }
      faces.insert(*std::min_element(turns.begin(), turns.end()));
    }
    shells.insert(std::move(faces));
  }
  return shells;
}

TEST(RepairProperty, SeparatesAlikeInAnyOrderOfFaces) {
  const auto tets = parted_shells(touching_tets());
  ASSERT_EQ(tets.size(), 2U);
  for (const auto& shell : tets) EXPECT_EQ(shell.size(), 4U);
  for (const TriMesh& mesh : {touching_tets(), test::closed_ring_of_cubes(0.005)}) {
    const auto expected = parted_shells(mesh);
    for (std::uint64_t seed = 0; seed < 100; ++seed) EXPECT_EQ(parted_shells(shuffled(mesh, seed)), expected) << seed;
  }
}

}  // namespace
}  // namespace taxel
