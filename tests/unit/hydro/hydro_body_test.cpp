// Bodies from shapes: rigid and soft kinds, sizes, and errors for unsupported combinations.
#include "core/hydro/hydro_body.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "fixtures/hydro_bodies.h"

namespace taxel {
namespace {

std::string message_of(const Shape& shape, const Material& material) {
  try {
    make_body(shape, material, "thing");
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

const TriMesh& mesh_of(const HydroBody& body) {
  return std::get<RigidMesh>(body.geometry).index->mesh();
}

TEST(MakeBody, GivesRoundRigidShapesTheirTrueVolume) {
  const dvec3 s(0.01, 0.02, 0.03);
  const auto volume = [&](ShapeType type) { return mesh_of(*make_simple_body(type, s)).volume(); };
  EXPECT_NEAR(volume(ShapeType::sphere), 4.0 / 3 * kPi * 1e-6, 1e-15);
  EXPECT_NEAR(volume(ShapeType::capsule), kPi * 1e-4 * (0.04 + 4.0 / 3 * 0.01), 1e-15);
  EXPECT_NEAR(volume(ShapeType::cylinder), kPi * 1e-4 * 0.04, 1e-15);
  EXPECT_NEAR(volume(ShapeType::ellipsoid), 4.0 / 3 * kPi * 6e-6, 1e-15);
  EXPECT_NEAR(volume(ShapeType::box), 8 * 6e-6, 1e-18);
  EXPECT_EQ(mesh_of(*make_simple_body(ShapeType::box, s)).face_count(), 12);
}

TEST(MakeBody, AnnouncesTessellationsThatAreTooFine) {
  Material soft;
  soft.modulus = 1e5;
  const auto shape_of = [](ShapeType type, double resolution) {
    Shape shape;
    shape.type = type;
    shape.size = dvec3(1);
    shape.resolution = resolution;
    return shape;
  };
  // Areas: sphere 4 pi, capsule 8 pi, cylinder 6 pi, ellipsoid 4 pi; a triangle of edge h has sqrt(3)/4 h^2.
  EXPECT_EQ(message_of(shape_of(ShapeType::sphere, 0.002), soft),
            "thing: a sphere would have about 7.3e+06 triangles with edges of 0.002 m, at most 2e+05 are made: "
            "resolution must "
            "be at least 0.012 m");
  EXPECT_EQ(
      message_of(shape_of(ShapeType::cylinder, 0.002), soft),
      "thing: a cylinder would have about 1.1e+07 triangles with edges of 0.002 m, at most 2e+05 are made: resolution "
      "must be at least 0.015 m");
  for (const ShapeType type : {ShapeType::capsule, ShapeType::ellipsoid})
    EXPECT_NE(message_of(shape_of(type, 0.002), {}).find("at most 2e+06 are made"), std::string::npos);
  EXPECT_EQ(message_of(shape_of(ShapeType::cylinder, 0.2), soft), "");
  EXPECT_EQ(message_of(shape_of(ShapeType::box, 1e-9), soft), "");
}

TEST(MakeBody, KeepsTheLengthOfACylinder) {
  const HydroBodyPtr body = make_simple_body(ShapeType::cylinder, dvec3(0.01, 0.2, 0));
  const TriMesh& mesh = mesh_of(*body);
  EXPECT_EQ(mesh.bounds().hi.z, 0.2);
  EXPECT_EQ(mesh.bounds().lo.z, -0.2);
}

TEST(MakeBody, GivesMoreFacesForAFinerResolution) {
  const auto faces = [](double edge) {
    return mesh_of(*make_simple_body(ShapeType::capsule, dvec3(0.01, 0.02, 0), {}, edge)).face_count();
  };
  EXPECT_GT(faces(0.001), 10 * faces(0.004));
}

TEST(MakeBody, MakesSoftBodiesOfSoftMaterials) {
  const auto plane = make_simple_body(ShapeType::plane, dvec3(0), soft_material(1e5, 0.01));
  EXPECT_NEAR(std::get<SoftHalfSpace>(plane->geometry).stiffness, 1e7, 1e-6);
  EXPECT_TRUE(plane->soft());
  EXPECT_TRUE(plane->half_space());
  EXPECT_FALSE(make_simple_body(ShapeType::plane, dvec3(0))->soft());
  const auto finger = make_mesh_body(make_fingertip(), soft_material(1e5, 0.002));
  const PressureField& pad = *std::get<SoftBody>(finger->geometry).field;
  EXPECT_EQ(pad.report().tets, 3 * make_fingertip().face_count());
  Material star = soft_material(1e5);
  star.field = FieldKind::star;
  const auto starred = make_mesh_body(make_fingertip(), star);
  EXPECT_EQ(std::get<SoftBody>(starred->geometry).field->report().tets, make_fingertip().face_count());
}

TEST(MakeBody, GivesACavityNoPad) {
  const TriMesh outside = make_icosphere(0.02, 2), inside = make_icosphere(0.01, 1);
  std::vector<dvec3> vertices = outside.vertices();
  std::vector<ivec3> faces = outside.faces();
  for (const ivec3& f : inside.faces()) faces.push_back(ivec3(f.x, f.z, f.y) + outside.vertex_count());
  vertices.insert(vertices.end(), inside.vertices().begin(), inside.vertices().end());
  const auto body = make_mesh_body({vertices, faces}, soft_material(1e5, 0.004));
  EXPECT_EQ(std::get<SoftBody>(body->geometry).field->report().tets, 3 * outside.face_count());
}

TEST(MakeBody, NamesBadInput) {
  const auto box = std::make_shared<const TriMesh>(make_box(dvec3(1)));
  EXPECT_NE(message_of({ShapeType::sphere, dvec3(0), nullptr, 0}, {}).find("thing: size 0 of a sphere"),
            std::string::npos);
  EXPECT_NE(message_of({ShapeType::box, dvec3(1, -1, 1), nullptr, 0}, {}).find("size 1 of a box"), std::string::npos);
  EXPECT_NE(message_of({ShapeType::mesh, dvec3(0), nullptr, 0}, {}).find("needs a mesh"), std::string::npos);
  EXPECT_NE(message_of({ShapeType::mesh, dvec3(0), box, -1}, {}).find("resolution"), std::string::npos);
  EXPECT_NE(message_of({ShapeType::plane, dvec3(0), nullptr, 0}, soft_material(1)).find("thickness"),
            std::string::npos);
  EXPECT_NE(message_of({ShapeType::tets, dvec3(0), nullptr, 0}, soft_material(1)).find("needs a tetrahedral mesh"),
            std::string::npos);
  Shape hills{ShapeType::mesh, dvec3(0), box, 0};
  hills.rigid_only = "a height field";
  EXPECT_NE(message_of(hills, soft_material(1)).find("a height field can only be rigid"), std::string::npos);
  Material tets = soft_material(1);
  tets.field = FieldKind::tets;
  EXPECT_NE(message_of({ShapeType::mesh, dvec3(0), box, 0}, tets).find("shape of type tets"), std::string::npos);
  EXPECT_NE(message_of({ShapeType::mesh, dvec3(0), box, 0}, soft_material(-1)).find("modulus"), std::string::npos);
  std::vector<ivec3> faces = box->faces();
  for (ivec3& f : faces) std::swap(f.x, f.y);
  const auto turned = std::make_shared<const TriMesh>(box->vertices(), faces);
  EXPECT_NE(message_of({ShapeType::mesh, dvec3(0), turned, 0}, {}).find("inside out"), std::string::npos);
}

}  // namespace
}  // namespace taxel
