// The fingertip: its size, symmetry and smoothness, and its distance from the taxels of the paper.
#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "core/mesh/make/primitives.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/query/closest_point.h"
#include "unit/mesh/dihedral.h"

namespace taxel {
namespace {

TEST(Fingertip, HasTheSizeOfTheFingerOfThePaper) {
  const TriMesh finger = make_fingertip();
  const dvec3 size = finger.bounds().extent();
  EXPECT_NEAR(size.x, 0.018, 0.0003);
  EXPECT_NEAR(size.y, 0.0155, 0.0003);
  EXPECT_NEAR(size.z, 0.0305, 0.0001);
  EXPECT_EQ(finger.bounds().lo.z, 0);
  EXPECT_TRUE(finger.closed());
  EXPECT_EQ(finger.shell_count(), 1);
  EXPECT_GT(finger.volume(), 0);
  EXPECT_NEAR(finger.face_count(), 2000, 100);
}

TEST(Fingertip, IsItsOwnMirrorImageToTheLastBit) {
  const TriMesh finger = make_fingertip();
  std::map<std::tuple<double, double, double>, int> vertex_at;
  for (int v = 0; v < finger.vertex_count(); ++v) {
    const dvec3& p = finger.vertices()[static_cast<std::size_t>(v)];
    vertex_at[{p.x, p.y, p.z}] = v;
  }
  std::vector<int> mirror;
  for (const dvec3& p : finger.vertices()) {
    const auto found = vertex_at.find({-p.x + 0.0, p.y, p.z});
    ASSERT_NE(found, vertex_at.end()) << p.x << ' ' << p.y << ' ' << p.z;
    mirror.push_back(found->second);
  }
  // The mirror image of every face, with the opposite winding, is a face.
  std::map<std::tuple<int, int, int>, int> faces;
  const auto key = [](int a, int b, int c) {
    return a < b && a < c ? std::tuple(a, b, c) : b < c ? std::tuple(b, c, a) : std::tuple(c, a, b);
  };
  for (const ivec3& f : finger.faces()) ++faces[key(f.x, f.y, f.z)];
  for (const ivec3& f : finger.faces()) {
    const auto at = [&](int v) { return mirror[static_cast<std::size_t>(v)]; };
    EXPECT_EQ(faces[key(at(f.x), at(f.z), at(f.y))], 1);
  }
}

TEST(Fingertip, HasEvenTrianglesAndNoSlivers) {
  const TriMesh finger = make_fingertip();
  double smallest = kPi;
  for (int f = 0; f < finger.face_count(); ++f) {
    for (int c = 0; c < 3; ++c) {
      const dvec3 a = finger.vertex(f, (c + 1) % 3) - finger.vertex(f, c);
      const dvec3 b = finger.vertex(f, (c + 2) % 3) - finger.vertex(f, c);
      smallest = std::min(smallest, std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
    }
  }
  EXPECT_GT(smallest * 180 / kPi, 30);
  const auto [least, most] = std::minmax_element(finger.face_areas().begin(), finger.face_areas().end());
  EXPECT_LT(*most / *least, 2.1);
}

TEST(Fingertip, IsSmoothAndConvexExceptAtTheRimOfItsBase) {
  for (const test::InnerEdge& edge : test::inner_edges(make_fingertip())) {
    EXPECT_GT(edge.angle * 180 / kPi, -0.05);
    EXPECT_LT(edge.angle * 180 / kPi, 50);
  }
}

/// Centres [mm] and normals published for the finger of the paper. The other six mirror x.
constexpr double kCenters[6][3] = {{4.1518, -6.1507, 14.6462}, {8.6195, 0.4629, 13.1657}, {8.3022, 0.7405, 19.4511},
                                   {3.5417, -5.0062, 23.8569}, {2.6699, 0.5571, 30.2862}, {7.1384, 0.9784, 25.8859}};
constexpr double kNormals[6][3] = {{0.3739, -0.9233, 0.0878}, {0.9990, -0.0327, 0.0315}, {0.9954, -0.0372, 0.0879},
                                   {0.3660, -0.8935, 0.2603}, {0.3521, -0.1378, 0.9257}, {0.9230, -0.0631, 0.3795}};

TEST(Fingertip, PassesTheTaxelsOfThePaper) {
  const MeshIndex index(std::make_shared<const TriMesh>(make_fingertip()));
  for (int i = 0; i < 12; ++i) {
    const double side = i < 6 ? 1 : -1;
    const double *c = kCenters[i % 6], *n = kNormals[i % 6];
    const SurfacePoint q = index.closest_point(1e-3 * dvec3(side * c[0], c[1], c[2]));
    EXPECT_LT(q.distance, 0.35e-3) << "taxel " << i;
    const dvec3& normal = index.mesh().face_normals()[static_cast<std::size_t>(q.face)];
    const double cosine = glm::dot(normal, glm::normalize(dvec3(side * n[0], n[1], n[2])));
    EXPECT_LT(std::acos(std::min(1.0, cosine)) * 180 / kPi, 10) << "taxel " << i;
  }
}

TEST(Fingertip, EqualsTheFilesOfTheAssets) {
  // After a change of the generator: save_mesh(path, make_fingertip()) for both files.
  const TriMesh finger = make_fingertip();
  const std::string folder = std::string(TAXEL_SOURCE_DIR) + "/assets/meshes/";
  const LoadedMesh obj = load_mesh(folder + "fingertip.obj");
  EXPECT_TRUE(obj.mesh->vertices() == finger.vertices());
  EXPECT_TRUE(obj.mesh->faces() == finger.faces());
  EXPECT_TRUE(obj.notes.empty());
  const LoadedMesh glb = load_mesh(folder + "fingertip.glb");
  EXPECT_TRUE(glb.mesh->faces() == finger.faces());
  ASSERT_EQ(glb.mesh->vertex_count(), finger.vertex_count());
  for (std::size_t v = 0; v < finger.vertices().size(); ++v)
    EXPECT_EQ(glm::vec3(glb.mesh->vertices()[v]), glm::vec3(finger.vertices()[v]));
}

}  // namespace
}  // namespace taxel
