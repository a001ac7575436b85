// A step as a file: another program reads the same bits, and a damaged file is refused with the name of its array.
#include "core/run/bundle/frame_bundle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/run/recording/recording_files.h"
#include "core/run/step.h"
#include "core/sim/simulator.h"
#include "fixtures/box_sweep.h"
#include "fixtures/complaint.h"
#include "fixtures/same_step.h"
#include "fixtures/sweep_model.h"
#include "fixtures/temp_folder.h"

namespace taxel {
namespace {

constexpr int kInContact = 1100;  // steps of the sweep

class FrameBundleTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const auto simulator = Simulator::make_scenario(test::fingertip_model(1e6), test::box_sweep());
    for (int i = 0; i < kInContact; ++i) simulator->step();
    auto frame = std::make_shared<SimFrame>();
    fill_step(simulator->view(), *frame);
    frame_ = frame;
  }
  static void TearDownTestSuite() { frame_.reset(); }

  std::filesystem::path write(const std::string& bytes) const {
    const std::filesystem::path file = folder_.path() / "press.taxelframe";
    write_file_atomically(file, bytes);
    return file;
  }
  static SimFramePtr frame_;
  test::TempFolder folder_;
};
SimFramePtr FrameBundleTest::frame_;

TEST_F(FrameBundleTest, KeepsTheGroupsOfGeoms) {
  auto scene = std::make_shared<SimScene>(*frame_->scene);
  for (std::size_t g = 0; g < scene->geoms.size(); ++g) scene->geoms[g].group = static_cast<int>(5 - g);
  SimFrame frame = *frame_;
  frame.scene = scene;
  const SimFramePtr opened = read_frame_bundle(write(frame_to_bundle(frame)));
  for (std::size_t g = 0; g < scene->geoms.size(); ++g)
    EXPECT_EQ(opened->scene->geoms.at(g).group, scene->geoms[g].group);
}

TEST_F(FrameBundleTest, OpensWithTheSameBits) {
  ASSERT_FALSE(frame_->sensors[0].surfaces.at(0).empty());
  const SimFramePtr opened = read_frame_bundle(write(frame_to_bundle(*frame_)));
  test::expect_same_step(*opened, *frame_);
  const SimScene &a = *opened->scene, &b = *frame_->scene;
  EXPECT_EQ(a.title, b.title);
  EXPECT_EQ(a.timestep, b.timestep);
  EXPECT_EQ(a.path_W, b.path_W);
  EXPECT_EQ(a.sensor_geoms, b.sensor_geoms);
  ASSERT_EQ(a.geoms.size(), b.geoms.size());
  for (std::size_t g = 0; g < a.geoms.size(); ++g) {
    EXPECT_EQ(a.geoms[g].name, b.geoms[g].name);
    EXPECT_EQ(a.geoms[g].rgba, b.geoms[g].rgba);
    EXPECT_EQ(a.geoms[g].sensor, b.geoms[g].sensor);
    ASSERT_EQ(a.geoms[g].mesh == nullptr, b.geoms[g].mesh == nullptr);
    if (a.geoms[g].mesh) {
      EXPECT_EQ(a.geoms[g].mesh->vertices(), b.geoms[g].mesh->vertices());
    }
  }
  EXPECT_EQ(layout_to_json(a.sensors[0]->layout), layout_to_json(b.sensors[0]->layout));
  ASSERT_EQ(opened->history.lanes->rows(), 1U);
  EXPECT_EQ(opened->history.first, frame_->step);
  EXPECT_GT(opened->history.lanes->sensor(0, 0).area, 0);
}

TEST_F(FrameBundleTest, WritesTheSameFileAfterItIsRead) {
  const std::string bytes = frame_to_bundle(*frame_);
  EXPECT_EQ(frame_to_bundle(*read_frame_bundle(write(bytes))), bytes);
}

TEST_F(FrameBundleTest, ContainsOtherFiles) {
  const std::string bytes = frame_to_bundle(*frame_, {{"state.json", "{\"a\": 1}\n"}});
  EXPECT_NE(bytes.find("{\"a\": 1}\n"), std::string::npos);
  EXPECT_EQ(read_frame_bundle(write(bytes))->step, frame_->step);
}

TEST_F(FrameBundleTest, RefusesOtherFilesByName) {
  const auto said_of = [&](const std::string& bytes) {
    return test::complaint_of([&] { (void)read_frame_bundle(write(bytes)); });
  };
  EXPECT_NE(said_of("nothing").find("press.taxelframe"), std::string::npos);
  const std::string bytes = frame_to_bundle(*frame_);
  EXPECT_NE(said_of(bytes.substr(0, bytes.size() / 2)), "");
  NpzWriter other;
  other.add("time", std::string("now"));
  EXPECT_NE(said_of(other.bytes()).find("is no frame of a simulation"), std::string::npos);
  NpzWriter newer;
  const std::int64_t two = 2;
  newer.add("format", std::string("taxel-frame"));
  newer.add("version", {}, std::span<const std::int64_t>(&two, 1));
  EXPECT_NE(said_of(newer.bytes()).find("version: is 2"), std::string::npos);
}

/// An error names the array of a number out of range inside the archive.
TEST_F(FrameBundleTest, RefusesHitsOfMissingPolygons) {
  SimFrame broken = *frame_;
  SensorStep& sensor = broken.sensors[0];
  const auto hit = std::find_if(sensor.hits.begin(), sensor.hits.end(), [](const RayHit& h) { return h.hit(); });
  ASSERT_NE(hit, sensor.hits.end());
  hit->polygon = 1'000'000;
  const std::string said = test::complaint_of([&] { (void)read_frame_bundle(write(frame_to_bundle(broken))); });
  EXPECT_NE(said.find("sensor0/hit_surface_polygon: 1000000 is not among 0 to"), std::string::npos) << said;
}

TEST_F(FrameBundleTest, RefusesInvalidNumbers) {
  const auto complaint_after = [&](const auto& change) {
    SimFrame broken = *frame_;
    change(broken);
    return test::complaint_of([&] { (void)read_frame_bundle(write(frame_to_bundle(broken))); });
  };
  const auto expect = [](const std::string& said, const std::string& part) {
    EXPECT_NE(said.find(part), std::string::npos) << said;
  };
  const double nan = std::nan("");
  expect(complaint_after([](SimFrame& f) { f.sensors[0].surfaces[0].polygons[0].tet = (1U << 31) - 7; }),
         "sensor0/surface0/polygons: 2147483641 is not among -1 to ");
  expect(complaint_after([](SimFrame& f) { f.sensors[0].surfaces[0].polygons[0].face = -2; }),
         "sensor0/surface0/polygons: -2 is not among -1 to ");
  expect(complaint_after([](SimFrame& f) { f.step = std::uint64_t{1} << 62; }),
         "step: value 0 must be from 0 to 9007199254740992, is 4611686018427387904");
  expect(complaint_after([&](SimFrame& f) { f.geom_poses[1].p.x = nan; }), "geom_pos: value 3 must be finite, is nan");
  expect(complaint_after([](SimFrame& f) { f.geom_poses[1].q = dquat(0, 0, 0, 0); }),
         "geom_quat: quaternion 1 must be of length 1, is of length 0");
  expect(complaint_after([](SimFrame& f) { f.sensors[0].X_WM.q = dquat(0, 0, 0, 0); }),
         "sensor0/quat: quaternion 0 must be of length 1, is of length 0");
  expect(complaint_after([&](SimFrame& f) { f.sensors[0].X_WM.p.z = nan; }),
         "sensor0/pos: value 2 must be finite, is nan");
  expect(complaint_after([&](SimFrame& f) { f.time = nan; }), "time: value 0 must be finite, is nan");
  expect(complaint_after([&](SimFrame& f) { f.sensors[0].surfaces[0].vertices[0].y = nan; }),
         "sensor0/surface0/vertices: value 1 must be finite, is nan");
}

TEST_F(FrameBundleTest, RefusesAChangedByte) {
  std::string bytes = frame_to_bundle(*frame_);
  const std::size_t member = bytes.find("sensor0/readings.npy");
  ASSERT_NE(member, std::string::npos);
  bytes[member + 20 + 128 + 3] ^= 1;  // after its name and the NPY header of 128 bytes
  const std::string said = test::complaint_of([&] { (void)read_frame_bundle(write(bytes)); });
  EXPECT_NE(said.find("sensor0/readings: is broken off or damaged"), std::string::npos) << said;
}

}  // namespace
}  // namespace taxel
