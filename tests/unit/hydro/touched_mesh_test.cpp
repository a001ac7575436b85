// Meshes of touched bodies are repaired like the mesh of a skin: whatever their file has wrong, they are the same body.
#include "core/hydro/hydro_body.h"

#include <gtest/gtest.h>

#include "unit/mesh/broken_mesh.h"

namespace taxel {
namespace {

Shape shape_of(const TriMesh& mesh) {
  Shape shape;
  shape.type = ShapeType::mesh;
  shape.mesh = std::make_shared<const TriMesh>(mesh);
  return shape;
}

/// The box with a copy of each face turned over.
TriMesh drawn_from_both_sides(const TriMesh& mesh) {
  std::vector<ivec3> faces = mesh.faces();
  for (const ivec3& f : mesh.faces()) faces.emplace_back(f.x, f.z, f.y);
  return {mesh.vertices(), std::move(faces)};
}

TEST(TouchedMesh, IsTheSameRigidBodyWithAnyFault) {
  const TriMesh box = make_box(dvec3(0.005));
  const TriMesh inner = make_box(dvec3(0.002));
  const std::vector<std::pair<const char*, TriMesh>> broken = {
      {"one face turned", test::with_turned_faces(box, {3})},
      {"half of the faces turned", test::with_turned_faces(box, {0, 1, 2, 3, 4, 5})},
      {"all faces turned", test::with_turned_faces(box, test::all_faces(box))},
      {"both sides", drawn_from_both_sides(box)},
      {"a part inside", test::together(box, inner)},
      {"an open lid", test::without_faces(box, {0, 1})},
      {"a fin", test::with_fin(box, 0, 0.0001)}};
  for (const auto& [fault, mesh] : broken) {
    SCOPED_TRACE(fault);
    Shape shape = shape_of(mesh);
    const RepairedMeshPtr repaired = repair_touched_mesh(shape, {}, TouchedRepair::automatic);
    ASSERT_NE(repaired, nullptr);
    EXPECT_FALSE(repaired->report.steps.empty());
    EXPECT_TRUE(shape.mesh->closed());
    EXPECT_NEAR(shape.mesh->volume(), box.volume(), 1e-12 * box.volume());
    EXPECT_NEAR(shape.mesh->area(), box.area(), 1e-12 * box.area());
    EXPECT_EQ(shape.face_numbers.size(), shape.mesh->faces().size());
  }
}

TEST(TouchedMesh, IsLeftAloneIfSoundOrIfTheRepairIsOff) {
  Shape sound = shape_of(make_box(dvec3(0.005)));
  const TriMeshPtr loaded = sound.mesh;
  EXPECT_EQ(repair_touched_mesh(sound, {}, TouchedRepair::automatic), nullptr);
  EXPECT_EQ(sound.mesh, loaded);
  Shape turned = shape_of(test::with_turned_faces(make_box(dvec3(0.005)), {3}));
  EXPECT_EQ(repair_touched_mesh(turned, {}, TouchedRepair::off), nullptr);
}

TEST(TouchedMesh, KeepsBothSidesOfASheet) {
  const TriMesh sheet({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  for (const TriMesh& both : {drawn_from_both_sides(sheet), drawn_from_both_sides(test::without_faces(sheet, {1}))}) {
    Shape shape = shape_of(both);
    repair_touched_mesh(shape, {}, TouchedRepair::automatic);
    EXPECT_EQ(shape.mesh->area(), both.area());
    EXPECT_EQ(shape.mesh->volume(), 0);
  }
}

TEST(TouchedMesh, MakesARigidSheetTwoSided) {
  const TriMesh sheet({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  Shape shape = shape_of(sheet);
  const RepairedMeshPtr repaired = repair_touched_mesh(shape, {}, TouchedRepair::automatic);
  ASSERT_NE(repaired, nullptr);
  EXPECT_EQ(repaired->report.steps.back().code, "repair_two_sided");
  EXPECT_TRUE(repaired->report.has_sheets);
  double up = 0, down = 0;
  for (int f = 0; f < shape.mesh->face_count(); ++f)
    (shape.mesh->face_normals()[test::slot(f)].z > 0 ? up : down) += shape.mesh->face_areas()[test::slot(f)];
  EXPECT_EQ(up, 1);
  EXPECT_EQ(down, 1);
}

}  // namespace
}  // namespace taxel
