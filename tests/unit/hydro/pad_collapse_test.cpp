// Folded prisms: as few offset vectors as possible are collapsed, so that the faces around a fold keep their tets.
#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/math.h"
#include "core/hydro/pad/pad_shape.h"
#include "core/mesh/mesh_io.h"
#include "fixtures/pad_meshes.h"

namespace taxel {
namespace {

/// Returns a ball with one vertex moved along the surface over one of its neighbours. Some faces around the vertex fold
/// back.
TriMeshPtr make_folded_ball(double by) {
  const TriMesh ball = make_icosphere(0.02, 2);
  const ivec3 face = ball.faces()[7];
  std::vector<dvec3> vertices = ball.vertices();
  const dvec3 from = vertices[at(face.x)], to = vertices[at(face.y)];
  vertices[at(face.x)] = 0.02 * glm::normalize(from + by * (to - from));
  return std::make_shared<const TriMesh>(std::move(vertices), ball.faces());
}

struct Collapsed {
  int offsets = 0;
  int bare_faces = 0;
  double bare = 0;  ///< area of the faces without tets relative to that of the skin
};

Collapsed collapsed(const TriMeshPtr& mesh, double thickness) {
  const MeshIndex index(mesh);
  const PadShape shape(index, thickness);
  Collapsed found;
  for (int offset = 0; offset < shape.offset_count(); ++offset) found.offsets += shape.collapsed(offset) ? 1 : 0;
  for (int f = 0; f < mesh->face_count(); ++f) {
    if (shape.tets(f).count > 0) continue;
    ++found.bare_faces;
    found.bare += mesh->face_areas()[at(f)] / mesh->area();
  }
  return found;
}

/// If all corners of a folded prism are collapsed, the first ball has 5 collapsed offset vectors and 0.36 % of its skin
/// without prisms.
TEST(PadPinch, LeavesTetsToTheFacesAroundAFold) {
  const Collapsed found = collapsed(make_folded_ball(1.1), 0.002);
  EXPECT_EQ(found.offsets, 4);
  EXPECT_LT(found.bare, 0.001);
  const Collapsed farther = collapsed(make_folded_ball(1.6), 0.002);
  EXPECT_EQ(farther.offsets, 3);
  EXPECT_EQ(farther.bare_faces, 0);
}

TEST(PadPinch, ChangesNothingIfNoPrismFolds) {
  for (const TriMesh& mesh : {make_icosphere(0.02, 2), make_box(dvec3(0.02)), make_spool(), make_l_block(0.005, 8)})
    EXPECT_EQ(collapsed(std::make_shared<const TriMesh>(mesh), 0.003).offsets, 0);
}

/// A thumb of 120 triangles. If all corners of a folded prism are collapsed, 0.7 % of the skin have no tets.
TEST(PadPinch, LeavesTetsToEveryFaceOfACoarseThumb) {
  const std::filesystem::path file = std::filesystem::path(TAXEL_REAL_DATA) / "skins/ability_thumb.glb";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  const TriMeshPtr mesh = load_mesh(file, dvec3(1)).mesh;
  EXPECT_EQ(collapsed(mesh, 0.002).bare_faces, 0);
}

}  // namespace
}  // namespace taxel
