// A second layout on the contact of a run: bit for bit the readings of the recorded surfaces, or of its own field in
// the recorded poses, and refused for another mesh.
#include "core/sim/compare/second_sensor.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/layout/file/layout_json.h"
#include "core/sensor/readout/reading.h"
#include "core/sim/simulator.h"
#include "fixtures/box_sweep.h"
#include "fixtures/fill_frame.h"
#include "fixtures/sweep_model.h"
#include "fixtures/temp_folder.h"

namespace taxel {
namespace {

struct SecondLayoutRun : ::testing::Test {
  static void SetUpTestSuite() {
    model_ = test::fingertip_model(5e5);
    simulator_ = Simulator::make_scenario(model_, test::box_sweep());
    for (int i = 0; i < 1300; ++i) simulator_->step();
    test::fill_frame(*simulator_, frame_);
  }
  static void TearDownTestSuite() {
    simulator_.reset();
    model_.reset();
    frame_ = {};
  }
  static std::vector<double> read(const Layout& layout, SecondContact contact) {
    return SecondSensor(model_, layout, contact, "second").read(view_of(frame_), 0)[ReadingModel::second].values;
  }
  /// Returns the layout with every second taxel, other samples and larger fields.
  static Layout other_taxels() {
    Layout layout = model_->layout;
    for (std::size_t k = layout.taxels.size(); k-- > 0;)
      if (k % 2 == 1) layout.taxels.erase(layout.taxels.begin() + static_cast<std::ptrdiff_t>(k));
    for (Taxel& taxel : layout.taxels) taxel.radius *= 1.3;
    layout.sampling.density = 3e5;
    layout.sampling.seed = 7;
    return layout;
  }
  static double largest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

  static inline SensorModelPtr model_;
  static inline std::unique_ptr<Simulator> simulator_;
  static inline SimFrame frame_;
};

TEST_F(SecondLayoutRun, ReadsTheSameBitsWithTheSameLayout) {
  const std::vector<double> readings = read(model_->layout, SecondContact::recorded);
  EXPECT_EQ(readings, frame_.sensors[0].readings);
  EXPECT_GT(largest(readings), 0);
  EXPECT_EQ(read(model_->layout, SecondContact::own), readings) << "an equal field has the recorded surfaces";
}

TEST_F(SecondLayoutRun, ReadsOtherTaxelsOnTheRecordedSurfaces) {
  Layout layout = other_taxels();
  const SensorModelPtr alone = build_sensor_model(layout, model_->loaded, "", "alone");
  SensorReading expected;
  read_sensor(*alone, surface_pointers(frame_.sensors[0]), expected);
  EXPECT_GT(largest(expected.values), 0);
  EXPECT_EQ(read(layout, SecondContact::recorded), expected.values);
  layout.material.field = FieldKind::star;
  layout.material.modulus *= 3;
  EXPECT_EQ(read(layout, SecondContact::recorded), expected.values) << "the field of the second layout is not used";
}

TEST_F(SecondLayoutRun, ReadsItsOwnFieldInTheRecordedPoses) {
  Layout layout = other_taxels();
  layout.material.field = FieldKind::star;
  const SensorModelPtr star = build_sensor_model(layout, model_->loaded, "", "star");
  const auto by_star = Simulator::make_scenario(star, test::box_sweep());
  const std::vector<Pose> X_WM{frame_.sensors[0].X_WM};
  const SensorStep contact = by_star->contact_at(0, X_WM, frame_.geom_poses);
  const std::vector<double> found = read(layout, SecondContact::own);
  EXPECT_EQ(found, contact.readings);
  EXPECT_GT(largest(found), 0);
  EXPECT_NE(found, read(layout, SecondContact::recorded));
}

TEST_F(SecondLayoutRun, RefusesAnotherFieldOfARigidLayout) {
  Layout layout = model_->layout;
  layout.material.modulus = 0;
  try {
    read(layout, SecondContact::own);
    FAIL() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "/material/modulus") << error.what();
  }
}

TEST(ReleasedModel, HasTheSettingOfThePaperOnTheSameTaxels) {
  Layout layout;
  layout.taxels.resize(3);
  layout.receptive_field.metric = Metric::geodesic;
  layout.readout.aggregate = Aggregate::force;
  layout.sampling.weights = SampleWeights::voronoi;
  const Layout paper = released_model_of(layout);
  EXPECT_EQ(paper.taxels, layout.taxels);
  EXPECT_EQ(paper.material.field, FieldKind::star);
  EXPECT_EQ(paper.material.modulus, 5.0e4);
  EXPECT_EQ(paper.material.friction, 0.3);
  EXPECT_EQ(paper.sampling.density, 1.0e6);
  EXPECT_EQ(paper.sampling.weights, SampleWeights::equal);
  EXPECT_EQ(paper.receptive_field.metric, Metric::euclidean);
  EXPECT_EQ(paper.readout.aggregate, Aggregate::weighted_mean);
}

TEST(EqualContact, DependsOnTheFieldAndTheRepairOnly) {
  const Layout first;
  Layout second = first;
  second.material.friction = 0.1;
  second.material.dissipation = 1;
  second.sampling.density = 1;
  EXPECT_TRUE(has_equal_contact(first, second));
  second.material.modulus *= 2;
  EXPECT_FALSE(has_equal_contact(first, second));
  EXPECT_TRUE(has_equal_contact(first, on_contact_of(first, second)));
  second = first;
  second.mesh.repair.refine = 0.5;
  EXPECT_FALSE(has_equal_contact(first, second));
}

struct SecondLayoutFile : ::testing::Test {
  test::TempFolder folder;
  SensorModelPtr first = test::fingertip_model(1e5);

  /// Writes a layout for a mesh, which is moved by `shift`, and returns its file.
  std::filesystem::path written(double shift, std::size_t taxels = 12) {
    std::vector<dvec3> vertices = first->loaded->vertices();
    for (dvec3& v : vertices) v.x += shift;
    save_mesh(folder / "other.obj", TriMesh(vertices, first->loaded->faces()));
    Layout layout = first->layout;
    layout.mesh.file = "other.obj";
    layout.mesh.sha256.clear();
    layout.taxels.resize(taxels);
    write_file_atomically(folder / "other.taxels.json", layout_to_json(layout));
    return folder / "other.taxels.json";
  }
  /// Returns the message with which a file is refused.
  std::string refusal(const std::filesystem::path& file) {
    try {
      static_cast<void>(read_second_layout(file, *first));
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(SecondLayoutFile, IsReadForACopyOfTheMesh) {
  const Layout layout = read_second_layout(written(0), *first);
  EXPECT_EQ(layout.taxels, first->layout.taxels);
}

TEST_F(SecondLayoutFile, IsRefusedForAMovedMesh) {
  const std::string text = refusal(written(1e-4));
  EXPECT_NE(text.find("other.taxels.json: /mesh/file: \"other.obj\""), std::string::npos) << text;
  EXPECT_NE(text.find("is another mesh than that of the run"), std::string::npos) << text;
}

TEST_F(SecondLayoutFile, IsRefusedWithoutTaxels) {
  const std::string text = refusal(written(0, 0));
  EXPECT_NE(text.find("/taxels: has no taxels"), std::string::npos) << text;
}

TEST_F(SecondLayoutFile, IsRefusedIfItIsMissing) {
  EXPECT_NE(refusal(folder / "gone.taxels.json").find("gone.taxels.json"), std::string::npos);
}

}  // namespace
}  // namespace taxel
