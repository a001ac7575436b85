// The worker that works out receptive fields, without a window: the same as the geometry it is made of, and an edited
// model comes with its fields.
#include "app/studio/features/fields/field_worker.h"

#include <gtest/gtest.h>

#include <atomic>

#include "app/studio/document/documents.h"

namespace taxel::studio {
namespace {

using ui::FieldMap;

class FieldWorkerTest : public testing::Test {
 protected:
  SensorModelPtr model(Metric metric, double radius_factor = 1) {
    SensorBuild how;
    how.cache = &cache;
    how.quality = SampleQuality::preview;
    const Document fingertip = built_in_fingertip(how);
    Layout layout = fingertip.project->layout;
    layout.receptive_field.metric = metric;
    layout.taxels.front().radius *= radius_factor;
    return build_sensor_model(layout, fingertip.model->mesh, "", "test", how);
  }
  SensorCache cache;
  std::atomic<int> woken = 0;
  FieldWorker worker{[this] { ++woken; }};
};

TEST_F(FieldWorkerTest, TellsTheNumbersOfTheFieldsThemselves) {
  const SensorModelPtr straight = model(Metric::euclidean), along = model(Metric::geodesic);
  worker.ask({{straight, along}, FieldMap::compared});
  worker.wait();
  const ui::ShownFieldsPtr fields = worker.newest();
  ASSERT_NE(fields, nullptr);
  for (const SensorModelPtr& each : {straight, along}) {
    const ui::SensorFields* of = fields->of(each);
    ASSERT_NE(of, nullptr);
    double geodesic = 0, only = 0;
    std::size_t pieces = 0;
    for (const ui::FieldPatch& patch : ui::taxel_patches(*each, ui::FieldPart::geodesic)) {
      geodesic += patch.area;
      pieces += patch.pieces.size();
    }
    for (const ui::FieldPatch& patch : ui::taxel_patches(*each, ui::FieldPart::euclidean_only)) {
      only += patch.area;
      pieces += patch.pieces.size();
    }
    EXPECT_NEAR(of->comparison->geodesic, geodesic, 1e-12 * geodesic);
    EXPECT_NEAR(of->comparison->euclidean_only, only, 1e-12 * geodesic);
    EXPECT_EQ(of->triangles.size(), 3 * pieces);
    EXPECT_EQ(of->rings->size(), each->layout.taxels.size());
    EXPECT_FALSE(of->coverage);
  }
  EXPECT_EQ(fields->of(model(Metric::euclidean, 2)), nullptr) << "another model";
}

TEST_F(FieldWorkerTest, StraightRingsAloneAreNoWork) {
  worker.ask({{model(Metric::euclidean)}, FieldMap::none});
  worker.wait();
  EXPECT_EQ(worker.newest(), nullptr);
  worker.ask({{model(Metric::geodesic)}, FieldMap::none});
  worker.wait();
  ASSERT_NE(worker.newest(), nullptr);
  EXPECT_TRUE(worker.newest()->sensors[0].triangles.empty());
}

TEST_F(FieldWorkerTest, AnEditedModelComesWithItsFields) {
  const SensorModelPtr before = model(Metric::geodesic), after = model(Metric::geodesic, 1.3);
  worker.ask({{before}, FieldMap::coverage});
  worker.wait();
  const int woken_before = woken;
  worker.make_now(after);
  worker.ask({{after}, FieldMap::coverage});
  EXPECT_FALSE(worker.busy()) << "nothing is left to do";
  ASSERT_NE(worker.newest()->of(after), nullptr);
  EXPECT_EQ(woken, woken_before);
  ui::FieldMaker anew;  // without what was kept of the model before
  const ui::ShownFieldsPtr expected = anew.make({{after}, FieldMap::coverage});
  EXPECT_EQ(worker.newest()->sensors[0].coverage->area_of_overlap, expected->sensors[0].coverage->area_of_overlap);
  worker.ask({});
  EXPECT_EQ(worker.newest(), nullptr);
}

}  // namespace
}  // namespace taxel::studio
