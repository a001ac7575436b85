// Sensor models on meshes that need repair: faces keep the numbers of the file, and written files give the same
// readings.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/math.h"
#include "core/layout/file/layout_json.h"
#include "core/mesh/formats/polygon_soup.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/repair/repaired_mesh.h"
#include "core/sensor/sensor_model.h"
#include "fixtures/complaint.h"
#include "fixtures/temp_folder.h"

namespace taxel {
namespace {

const std::filesystem::path kFingerFile =
    std::filesystem::path(TAXEL_SOURCE_DIR) / "assets" / "layouts" / "fingertip.taxels.json";
constexpr int kMissing = 100;  // the face of our fingertip that the broken finger lacks

Layout finger_layout() {
  Layout layout = read_layout(kFingerFile);
  layout.sampling.density = 2e6;
  return layout;
}

TriMeshPtr sound_finger() {
  const Layout layout = read_layout(kFingerFile);
  return load_mesh(mesh_path(layout, kFingerFile), layout.mesh.scale).mesh;
}

/// Returns the project's fingertip with a fin on its first edge as face 0 and without the face kMissing. The faces
/// before kMissing have a number one higher.
TriMeshPtr broken_finger() {
  const TriMeshPtr sound = sound_finger();
  std::vector<dvec3> vertices = sound->vertices();
  std::vector<ivec3> faces = sound->faces();
  const ivec3 first = faces[0];
  vertices.push_back(sound->vertex(0, 0) + 0.001 * sound->face_normals()[0]);
  faces.erase(faces.begin() + kMissing);
  faces.insert(faces.begin(), ivec3(first.x, first.y, sound->vertex_count()));
  return std::make_shared<const TriMesh>(std::move(vertices), std::move(faces));
}

/// Returns two boxes that share an edge, which has four faces.
TriMeshPtr touching_boxes() {
  PolygonSoup soup;
  for (const dvec3& corner : {dvec3(0), dvec3(0.01, 0.01, 0)}) {
    const int first = static_cast<int>(soup.vertices.size());
    for (int i = 0; i < 8; ++i) soup.vertices.push_back(corner + 0.01 * dvec3(i & 1, (i >> 1) & 1, i >> 2));
    for (const ivec3& f :
         {ivec3(0, 2, 3), ivec3(0, 3, 1), ivec3(4, 5, 7), ivec3(4, 7, 6), ivec3(0, 1, 5), ivec3(0, 5, 4),
          ivec3(2, 6, 7), ivec3(2, 7, 3), ivec3(0, 4, 6), ivec3(0, 6, 2), ivec3(1, 3, 7), ivec3(1, 7, 5)})
      soup.triangles.push_back(f + ivec3(first));
  }
  std::vector<std::string> notes;
  return std::make_shared<const TriMesh>(weld(soup, dvec3(1), notes));
}

std::vector<std::string> codes(const SensorModel& model, Severity severity) {
  std::vector<std::string> all;
  for (const Problem& p : model.problems)
    if (p.severity == severity) all.push_back(p.code);
  return all;
}

bool contains(const std::vector<std::string>& all, const std::string& one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

TEST(RepairedModel, UsesASoundMeshUnchanged) {
  const TriMeshPtr mesh = sound_finger();
  SensorCache cache;
  SensorBuild how;
  how.cache = &cache;
  const SensorModelPtr model = build_sensor_model(finger_layout(), mesh, "", "f", how);
  EXPECT_EQ(model->mesh, mesh);
  EXPECT_EQ(model->loaded, mesh);
  EXPECT_TRUE(model->repaired->loaded_face_of.empty());
  EXPECT_EQ(layout_to_json(layout_on_repaired_mesh(*model)), layout_to_json(model->layout));
  const auto equal = std::make_shared<const TriMesh>(mesh->vertices(), mesh->faces());
  EXPECT_EQ(build_sensor_model(finger_layout(), equal, "", "f", how)->mesh, equal) << "not the cached mesh";
}

TEST(RepairedModel, IsSoftOnABrokenMeshAndReportsTheRepair) {
  const SensorSource source{"f", finger_layout(), {broken_finger(), "", {}, {}}};
  const SensorModelPtr model = build_sensor_model(source);
  EXPECT_FALSE(model->loaded->closed());
  EXPECT_TRUE(model->mesh->closed());
  EXPECT_TRUE(model->body->soft());
  EXPECT_EQ(codes(*model, Severity::error), std::vector<std::string>{});
  const std::vector<std::string> notes = codes(*model, Severity::note);
  EXPECT_TRUE(contains(notes, "repair_fin"));
  EXPECT_TRUE(contains(notes, "mesh_open"));
  EXPECT_TRUE(contains(notes, "mesh_nonmanifold"));
  for (const Problem& p : model->problems) {
    if (p.code == "mesh_open") {
      EXPECT_EQ(p.message.find("the file has"), 0U) << p.message;
    }
  }
}

TEST(RepairedModel, CountsTheFacesOfARegionAsLoaded) {
  const TriMeshPtr loaded = broken_finger();
  Layout layout = finger_layout();
  std::vector<int> region;
  for (int f = 0; f < loaded->face_count(); f += 3) region.push_back(f);
  layout.sampling.region = region;
  const SensorModelPtr model = build_sensor_model(layout, loaded, "", "f");
  ASSERT_GT(model->samples.size(), 100U);
  for (const SurfaceSample& sample : model->samples) {
    const int face = model->repaired->loaded_face(model->skin_face_of[at(sample.face)]);
    ASSERT_TRUE(std::binary_search(region.begin(), region.end(), face)) << face;
  }
  double area = 0;
  for (const int f : region)
    if (f != 0) area += loaded->face_areas()[at(f)];  // face 0 is the fin
  EXPECT_NEAR(model->sampled_area, area, 1e-12 * area);
  const std::vector<int> back = loaded_faces(*model->repaired, repaired_faces(*model->repaired, region));
  EXPECT_EQ(back, std::vector<int>(region.begin() + 1, region.end()));
}

TEST(RepairedModel, ReportsItsErrorsAtTheMesh) {
  Layout layout = finger_layout();
  layout.mesh.repair.level = RepairLevel::keep;
  const auto complaint = [&](const TriMeshPtr& mesh) {
    return test::complaint_of([&] { build_sensor_model(layout, mesh, "", "f"); });
  };
  EXPECT_EQ(complaint(broken_finger()).find("f: /mesh/file: must be a closed mesh to be soft: "), 0U);
  EXPECT_EQ(complaint(sound_finger()), "accepted");
  layout.mesh.repair = {};
  layout.mesh.repair.edge = -1e-3;
  EXPECT_EQ(complaint(broken_finger()), "f: /mesh/repair/edge: must be greater than 0, is -0.001");
  layout.taxels[0].radius = -1;
  EXPECT_NE(complaint(broken_finger()).find("/mesh/repair/edge"), std::string::npos) << "values come first";
}

TEST(RepairedModel, LeavesARigidMeshUnchangedUnlessRequested) {
  Layout layout = finger_layout();
  layout.material.modulus = 0;
  const TriMeshPtr broken = broken_finger();
  EXPECT_EQ(build_sensor_model(layout, broken, "", "f")->mesh, broken);
  layout.mesh.repair.level = RepairLevel::keep;
  EXPECT_EQ(build_sensor_model(layout, broken, "", "f")->mesh, broken);
  layout.mesh.repair.level = RepairLevel::exact;
  EXPECT_TRUE(build_sensor_model(layout, broken, "", "f")->mesh->closed());
}

TEST(RepairedModel, IsRepairedOnceForEachRecipe) {
  SensorCache cache;
  const TriMeshPtr broken = broken_finger();
  const Material material = finger_layout().material;
  const RepairedMeshPtr first = cache.repaired(broken, {}, material, nullptr);
  EXPECT_EQ(cache.repaired(broken, {}, material, nullptr), first);
  RepairRecipe other;
  other.refine = 3;
  EXPECT_EQ(cache.repaired(broken, other, material, nullptr), first) << "refine is for the field alone";
  other.join = 1e-6;
  EXPECT_NE(cache.repaired(broken, other, material, nullptr), first);
  Material thicker = material;
  thicker.thickness *= 2;
  EXPECT_NE(cache.repaired(broken, {}, thicker, nullptr), first);
  const TriMeshPtr sound = sound_finger();
  EXPECT_EQ(cache.repaired(sound, {}, thicker, nullptr), cache.repaired(sound, {}, material, nullptr));
}

/// Saves the repaired mesh to a file with its layout, as in the folder of a scene, and returns the model of this file.
SensorModelPtr through_a_file(const SensorModel& model) {
  const test::TempFolder folder;
  save_mesh(folder.path() / "mesh.obj", *model.mesh);
  Layout layout = layout_on_repaired_mesh(model);
  layout.mesh = {"mesh.obj", dvec3(1), "", layout.mesh.repair};
  write_layout(folder.path() / "l.taxels.json", layout);
  return load_sensor_model(folder.path() / "l.taxels.json");
}

void expect_same_samples(const SensorModel& a, const SensorModel& b) {
  ASSERT_EQ(a.samples.size(), b.samples.size());
  for (std::size_t i = 0; i < a.samples.size(); ++i) {
    ASSERT_EQ(a.samples[i].position, b.samples[i].position) << i;
    ASSERT_EQ(a.samples[i].normal, b.samples[i].normal);
  }
  EXPECT_EQ(a.readout_table.ray_of_entry, b.readout_table.ray_of_entry);
  EXPECT_EQ(std::get<SoftBody>(a.body->geometry).field->tets().size(),
            std::get<SoftBody>(b.body->geometry).field->tets().size());
}

TEST(RepairedModel, ReadsTheSameThroughAFileOfTheRepairedMesh) {
  Layout layout = finger_layout();
  std::vector<int> region;
  for (int f = 0; f < 400; ++f) region.push_back(f);
  layout.sampling.region = region;
  layout.mesh.repair.join = 1e-6;
  layout.mesh.repair.refine = 3;
  const SensorModelPtr model = build_sensor_model(layout, broken_finger(), "", "f");
  const SensorModelPtr again = through_a_file(*model);
  EXPECT_EQ(again->mesh, again->loaded) << "there is nothing left to repair";
  EXPECT_EQ(again->layout.mesh.repair.refine, 3);
  EXPECT_FALSE(again->layout.mesh.repair.join);
  expect_same_samples(*model, *again);
}

TEST(RepairedModel, ReadsTheSameThroughAFileIfPartsTouch) {
  Layout layout;
  layout.sampling.density = 2e6;
  layout.taxels = {{0, "", dvec3(0.005, 0.005, 0.01), dvec3(0, 0, 1), 0.003, {}}};
  layout.mesh.file = "boxes";
  const SensorModelPtr model = build_sensor_model(layout, touching_boxes(), "", "f");
  EXPECT_FALSE(model->loaded->closed());
  EXPECT_TRUE(model->mesh->closed());
  expect_same_samples(*model, *through_a_file(*model));
}

TEST(RepairedModel, SensesNowhereIfNoFaceOfItsRegionIsLeft) {
  Layout layout = finger_layout();
  layout.sampling.region = std::vector<int>{0};  // face 0 is the fin
  const SensorModelPtr model = build_sensor_model(layout, broken_finger(), "", "f");
  EXPECT_TRUE(model->samples.empty());
  EXPECT_TRUE(through_a_file(*model)->samples.empty());
}

}  // namespace
}  // namespace taxel
