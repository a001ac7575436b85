// The layout of one hand and its image for the other hand.
#include <gtest/gtest.h>

#include "core/hydro/intersect.h"
#include "core/layout/file/layout_json.h"
#include "core/layout/generators/mirror.h"
#include "core/sensor/readout/reading.h"
#include "fixtures/temp_folder.h"

namespace taxel {
namespace {

constexpr const char* kFingertip = TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json";

Layout half_fingertip() {
  Layout layout = read_layout(kFingertip);
  layout.mesh.file = mesh_path(layout, kFingertip).string();
  layout.readout.method = ReadingMethod::exact;
  layout.sampling.density = 1e5;
  layout.taxels.resize(6);  // those on one side
  return layout;
}

TEST(MirroredLayout, IsItsOwnInverse) {
  const Layout layout = half_fingertip();
  for (int axis = 0; axis < 3; ++axis) {
    const Layout once = mirrored_layout(layout, axis);
    EXPECT_EQ(once.mesh.scale[axis], -1.0);
    EXPECT_EQ(once.taxels[2].center[axis], -layout.taxels[2].center[axis]);
    EXPECT_EQ(once.frame.distal[axis], -layout.frame.distal[axis]);
    Layout twice = mirrored_layout(once, axis);
    twice.name = layout.name;
    EXPECT_EQ(twice, layout);
  }
}

/// A ball next to the middle of the pad presses one finger, and its image the image of the finger.
TEST(MirroredLayout, ReadsAMirroredContactAlike) {
  const HydroBodyPtr ball = make_body({ShapeType::sphere, dvec3(0.006, 0, 0), nullptr, 0.001}, Material{}, "object");
  const Layout layout = half_fingertip();
  const auto readings_of = [&](const Layout& one, double x) {
    const test::TempFolder folder;
    write_layout(folder.path() / "one.taxels.json", one);
    const SensorModelPtr model = load_sensor_model(folder.path() / "one.taxels.json");
    ContactSurface surface;
    IntersectWorkspace workspace;
    const dvec3 place(x, model->mesh->bounds().lo.y - 0.006 + 0.001, 0.012);
    intersect(*model->body, *ball, Pose{}, Pose{dquat(1, 0, 0, 0), place}, surface, workspace);
    SensorReading reading;
    const ContactSurface* list[] = {&surface};
    read_sensor(*model, list, reading);
    return reading.values;
  };
  const std::vector<double> here = readings_of(layout, 0.0015),
                            there = readings_of(mirrored_layout(layout, 0), -0.0015);
  const double largest = *std::max_element(here.begin(), here.end());
  ASSERT_GT(largest, 1000.0);
  ASSERT_EQ(here.size(), there.size());
  for (std::size_t k = 0; k < here.size(); ++k) EXPECT_NEAR(there[k], here[k], 0.01 * largest) << k;
  // The same contact on the image is another one.
  const std::vector<double> other = readings_of(mirrored_layout(layout, 0), 0.0015);
  double difference = 0;
  for (std::size_t k = 0; k < here.size(); ++k) difference = std::max(difference, std::abs(other[k] - here[k]));
  EXPECT_GT(difference, 0.1 * largest);
}

}  // namespace
}  // namespace taxel
