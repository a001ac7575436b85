// Compiled layouts: rays, the taxels of each sample, depths, problems.
#include "core/sensor/sensor_model.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <set>

#include "core/base/error.h"
#include "core/mesh/make/primitives.h"

namespace taxel {
namespace {

const std::filesystem::path kFinger = std::filesystem::path(TAXEL_SOURCE_DIR) / "assets/layouts/fingertip.taxels.json";

/// Returns a plate of 20 x 20 x 2 h mm with one taxel on top and one on the +x side.
Layout plate_layout(double h) {
  Layout layout;
  layout.mesh.file = "plate";
  layout.sampling.density = 2e6;
  layout.material.thickness = 0.001;
  layout.taxels = {{0, "", dvec3(0, 0, h), dvec3(0, 0, 2), 0.005, {}},
                   {1, "", dvec3(0.002, 0, h), dvec3(0, 1, 9), 0.004, {}}};
  return layout;
}
TriMeshPtr plate(double h) {
  return std::make_shared<TriMesh>(make_box(dvec3(0.010, 0.010, h)));
}

void expect_consistent(const SensorModel& model) {
  ASSERT_EQ(model.readout_table.ray_of_entry.size(), model.fields.entries.size());
  ASSERT_EQ(model.taxels_of_sample.size(), model.samples.size());
  std::vector<std::set<std::pair<double, int>>> users(model.samples.size());
  for (int k = 0; k < model.taxel_count(); ++k) {
    for (int e = model.fields.first[static_cast<std::size_t>(k)];
         e < model.fields.first[static_cast<std::size_t>(k) + 1]; ++e) {
      const auto i = static_cast<std::size_t>(e);
      const SensorRay& ray = model.rays[static_cast<std::size_t>(model.readout_table.ray_of_entry[i])];
      ASSERT_EQ(ray.sample, model.fields.entries[i].sample);
      users[static_cast<std::size_t>(ray.sample)].emplace(model.fields.entries[i].distance, k);
    }
  }
  for (std::size_t s = 0; s < users.size(); ++s) {
    std::vector<int> expected;
    for (const auto& [distance, taxel] : users[s]) expected.push_back(taxel);
    ASSERT_EQ(model.taxels_of_sample[s], expected);
  }
}

TEST(SensorModel, HasOneRayPerUsedSampleAgainstItsNormal) {
  const SensorModelPtr model = build_sensor_model(plate_layout(0.004), plate(0.004), "", "f");
  expect_consistent(*model);
  std::set<int> used;
  for (const ReceptiveFields::Entry& e : model->fields.entries) used.insert(e.sample);
  EXPECT_EQ(model->rays.size(), used.size());
  EXPECT_LT(model->rays.size(), model->fields.entries.size()) << "the two taxels share samples";
  EXPECT_LT(model->rays.size(), model->samples.size()) << "unused samples are dropped";
  for (const SensorRay& ray : model->rays) {
    const SurfaceSample& s = model->samples[static_cast<std::size_t>(ray.sample)];
    EXPECT_EQ(ray.origin, s.position);
    EXPECT_EQ(ray.direction, -s.normal);
    EXPECT_EQ(ray.direction, dvec3(0, 0, -1));
    EXPECT_DOUBLE_EQ(ray.max_depth, 0.002) << "twice the thickness";
  }
}

TEST(SensorModel, EndsRaysHalfwayToTheOppositeSkin) {
  Layout layout = plate_layout(0.0006);
  layout.readout.max_depth = 0.5;
  layout.material.thickness = 0.0003;
  const SensorModelPtr model = build_sensor_model(layout, plate(0.0006), "", "f");
  ASSERT_FALSE(model->rays.empty());
  for (const SensorRay& ray : model->rays) EXPECT_NEAR(ray.max_depth, 0.0006, 1e-15);
}

TEST(SensorModel, CastsRaysAlongTaxelNormalsOnRequest) {
  Layout layout = plate_layout(0.004);
  layout.readout.ray = RayDirection::taxel_normal;
  const SensorModelPtr model = build_sensor_model(layout, plate(0.004), "", "f");
  expect_consistent(*model);
  ASSERT_EQ(model->rays.size(), model->fields.entries.size());
  const auto first_of_second = static_cast<std::size_t>(model->fields.first[1]);
  const dvec3 tilted = -glm::normalize(dvec3(0, 1, 9));
  EXPECT_EQ(model->rays[static_cast<std::size_t>(model->readout_table.ray_of_entry[first_of_second])].direction,
            tilted);
  EXPECT_EQ(model->rays[0].direction, dvec3(0, 0, -1));
}

TEST(SensorModel, HasTheLargestRadiusAsDefaultDepthOfAStar) {
  Layout layout = plate_layout(0.008);
  layout.material.field = FieldKind::star;
  const auto depth = [&] { return build_sensor_model(layout, plate(0.008), "", "f")->rays.at(0).max_depth; };
  EXPECT_DOUBLE_EQ(depth(), 0.005) << "star: the largest radius";
  layout.readout.max_depth = 0.0031;
  EXPECT_DOUBLE_EQ(depth(), 0.0031);
}

TEST(SensorModel, StartsRaysOfARigidSensorJustAboveItsSkin) {
  Layout layout = plate_layout(0.004);
  layout.material.modulus = 0.0;
  const SensorModelPtr model = build_sensor_model(layout, plate(0.004), "", "f");
  EXPECT_FALSE(model->body->soft());
  ASSERT_FALSE(model->rays.empty());
  for (const SensorRay& ray : model->rays) {
    EXPECT_GT(ray.origin.z, 0.004);
    EXPECT_LT(ray.origin.z, 0.004 + 1e-6);
  }
}

TEST(SensorModel, KeepsTheSamplesIfATaxelMoves) {
  Layout layout = plate_layout(0.004);
  const SensorModelPtr before = build_sensor_model(layout, plate(0.004), "", "f");
  layout.taxels[0].center.x = 0.003;
  const SensorModelPtr after = build_sensor_model(layout, plate(0.004), "", "f");
  ASSERT_EQ(before->samples.size(), after->samples.size());
  for (std::size_t i = 0; i < before->samples.size(); ++i)
    EXPECT_EQ(before->samples[i].position, after->samples[i].position);
}

TEST(SensorModel, ThrowsOrListsProblems) {
  Layout layout = plate_layout(0.004);
  layout.taxels[1].radius = -0.006;
  try {
    build_sensor_model(layout, plate(0.004), "", "f.json");
    FAIL();
  } catch (const Error& e) {
    EXPECT_STREQ(e.what(), "f.json: /taxels/1/radius: must be greater than 0, is -0.006 (taxel 1)");
  }
  layout = plate_layout(0.004);
  layout.taxels[1].normal = dvec3(0, 0, -1);
  layout.sampling.density = 2e4;
  layout.taxels[0].radius = 0.001;
  const SensorModelPtr model = build_sensor_model(layout, plate(0.004), "", "f.json");
  std::set<std::string> codes;
  for (const Problem& p : model->problems) codes.insert(p.pointer + " " + p.code);
  EXPECT_EQ(codes, (std::set<std::string>{"/taxels/0 field_without_samples", "/taxels/1 field_empty",
                                          "/taxels/1/normal normal_points_inward"}));
}

TEST(SensorModel, HasEuclideanGeodesicFieldsOnAFlatFace) {
  Layout layout = plate_layout(0.004);
  const SensorModelPtr straight = build_sensor_model(layout, plate(0.004), "", "f");
  layout.receptive_field.metric = Metric::geodesic;
  const SensorModelPtr along = build_sensor_model(layout, plate(0.004), "", "f");
  expect_consistent(*along);
  ASSERT_EQ(along->fields.first, straight->fields.first);
  for (std::size_t e = 0; e < along->fields.entries.size(); ++e) {
    EXPECT_EQ(along->fields.entries[e].sample, straight->fields.entries[e].sample);
    EXPECT_NEAR(along->fields.entries[e].weight, straight->fields.entries[e].weight, 1e-12 * 25e-6);
  }
}

TEST(SensorModel, HasNoProblemsOnOurFingertip) {
  const SensorModelPtr model = load_sensor_model(kFinger);
  expect_consistent(*model);
  EXPECT_EQ(model->taxel_count(), 12);
  EXPECT_EQ(static_cast<int>(model->samples.size()), static_cast<int>(std::round(1e7 * model->mesh->area())));
  for (const Problem& p : model->problems) ADD_FAILURE() << p.pointer << ": " << p.message;
  EXPECT_TRUE(model->body->soft());
  for (int k = 0; k < 12; ++k)
    EXPECT_GT(model->fields.first[static_cast<std::size_t>(k) + 1] - model->fields.first[static_cast<std::size_t>(k)],
              500);
}

/// Returns the faces on the pad's side.
std::vector<int> pad_faces(const TriMesh& mesh) {
  std::vector<int> faces;
  for (int f = 0; f < mesh.face_count(); ++f)
    if (mesh.face_normals()[static_cast<std::size_t>(f)].y < -0.5) faces.push_back(f);
  return faces;
}

TEST(SensorModel, PlacesSamplesInTheRegionOnly) {
  SensorSource source = read_sensor_source(kFinger);
  const TriMesh& mesh = *source.mesh.mesh;
  const std::vector<int> region = pad_faces(mesh);
  double area = 0;
  for (const int f : region) area += mesh.face_areas()[static_cast<std::size_t>(f)];
  ASSERT_GT(area, 0.1 * mesh.area());
  source.layout.sampling.region = region;
  source.layout.sampling.weights = SampleWeights::voronoi;
  for (const SampleQuality quality : {SampleQuality::preview, SampleQuality::polished}) {
    SensorBuild how;
    how.quality = quality;
    const SensorModelPtr model = build_sensor_model(source.layout, source.mesh.mesh, "", "f", how);
    expect_consistent(*model);
    EXPECT_EQ(static_cast<int>(model->samples.size()), static_cast<int>(std::round(1e7 * area)));
    EXPECT_NEAR(model->sampled_area, area, 1e-12 * area);
    double stands_for = 0, shares = 0;
    for (std::size_t s = 0; s < model->samples.size(); ++s) {
      const SurfaceSample& sample = model->samples[s];
      ASSERT_TRUE(std::binary_search(region.begin(), region.end(), sample.face));
      const SurfacePoint nearest = model->skin->closest_point(sample.position);
      ASSERT_LT(nearest.distance, 1e-12);
      ASSERT_LT(glm::distance(sample.normal, mesh.face_normals()[static_cast<std::size_t>(sample.face)]), 1e-12);
      stands_for += sample.area;
      shares += model->sample_share(static_cast<int>(s));
    }
    EXPECT_NEAR(stands_for, area, 1e-9 * area);
    EXPECT_NEAR(shares, static_cast<double>(model->samples.size()), 1e-6 * shares) << "one on average";
    EXPECT_EQ(model->skin->mesh().face_count(), mesh.face_count()) << "touched everywhere";
  }
}

TEST(SensorModel, ReportsARegionOffTheMesh) {
  SensorSource source = read_sensor_source(kFinger);
  const int faces = source.mesh.mesh->face_count();
  const auto problems = [&](std::vector<int> region) {
    source.layout.sampling.region = std::move(region);
    std::set<std::string> codes;
    const SensorModelPtr model = build_sensor_model(source.layout, source.mesh.mesh, "", "f");
    for (const Problem& p : model->problems)
      if (p.pointer == "/sampling/region") codes.insert(p.code);
    return codes;
  };
  EXPECT_EQ(problems({0, faces - 1}), std::set<std::string>{});
  EXPECT_EQ(problems({0, faces}), std::set<std::string>{"region_off_mesh"});
  EXPECT_EQ(problems({faces}), (std::set<std::string>{"region_off_mesh", "region_empty"}));
  EXPECT_THROW(problems({3, 1}), Error);
}

TEST(SensorModel, HasNoSampleOnTheCavityOfTheRealFingertip) {
  const std::filesystem::path file = std::filesystem::path(TAXEL_REAL_DATA) / "shadow_fingertip.taxels.json";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "absent: " << file;
  const SensorModelPtr model = load_sensor_model(file);
  expect_consistent(*model);
  EXPECT_EQ(model->mesh->face_count() - model->skin->mesh().face_count(), 320);
  const std::vector<int>& shells = model->mesh->shell_of_face();
  const int skin_shell = shells[static_cast<std::size_t>(model->skin_face_of[0])];
  for (const SurfaceSample& s : model->samples) {
    const auto face = static_cast<std::size_t>(model->skin_face_of[static_cast<std::size_t>(s.face)]);
    ASSERT_EQ(shells[face], skin_shell);
    ASSERT_EQ(model->mesh->face_normals()[face], s.normal);
  }
  bool cavity_reported = false;
  for (const Problem& p : model->problems) {
    EXPECT_NE(p.severity, Severity::error);
    cavity_reported |= p.code == "mesh_has_cavity";
  }
  EXPECT_TRUE(cavity_reported);
}

TEST(SensorModel, StopsWhenCancelled) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(load_sensor_model(kFinger, &progress), Cancelled);
}

}  // namespace
}  // namespace taxel
