// The job that computes receptive fields, without a window: its results equal those of the geometry functions, and an
// edited model arrives with its fields.
#include "app/studio/host/jobs/job_executor.h"
#include "app/studio/nouns/fields/fields.h"

#include <gtest/gtest.h>

#include <atomic>

#include "app/studio/host/document/documents.h"

namespace taxel::studio {
namespace {

using ui::FieldMap;

class FieldJobTest : public testing::Test {
 protected:
  SensorModelPtr model(Metric metric, double radius_factor = 1) {
    SensorBuild how;
    how.cache = &cache;
    how.quality = SampleQuality::preview;
    const LoadedDocument fingertip = built_in_fingertip(how);
    Layout layout = fingertip.project->layout;
    layout.receptive_field.metric = metric;
    layout.taxels.front().radius *= radius_factor;
    return build_sensor_model(layout, fingertip.model->mesh, "", "test", how);
  }
  SensorCache cache;
  JobPool pool;
  FieldJob job{pool};
};

TEST_F(FieldJobTest, ReportsTheNumbersOfTheFieldGeometry) {
  const SensorModelPtr straight = model(Metric::euclidean), along = model(Metric::geodesic);
  job.show({{straight, along}, FieldMap::compared});
  job.wait();
  const ui::ShownFieldsPtr fields = job.newest();
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

TEST_F(FieldJobTest, NeedsNoJobForStraightRingsAlone) {
  job.show({{model(Metric::euclidean)}, FieldMap::none});
  job.wait();
  EXPECT_EQ(job.newest(), nullptr);
  job.show({{model(Metric::geodesic)}, FieldMap::none});
  job.wait();
  ASSERT_NE(job.newest(), nullptr);
  EXPECT_TRUE(job.newest()->sensors[0].triangles.empty());
}

TEST_F(FieldJobTest, GivesAnEditedModelItsFields) {
  const SensorModelPtr before = model(Metric::geodesic), after = model(Metric::geodesic, 1.3);
  job.show({{before}, FieldMap::coverage});
  job.wait();
  const std::uint64_t ended_before = pool.ended();
  job.model_built(after);
  job.show({{after}, FieldMap::coverage});
  EXPECT_FALSE(job.busy()) << "nothing is left to do";
  ASSERT_NE(job.newest()->of(after), nullptr);
  EXPECT_EQ(pool.ended(), ended_before);
  ui::FieldMaker fresh;  // without the fields of the earlier model
  ui::ShownFields expected;
  fresh.make({{after}, FieldMap::coverage}, expected);
  EXPECT_EQ(job.newest()->sensors[0].coverage->area_of_overlap, expected.sensors[0].coverage->area_of_overlap);
  job.show({});
  EXPECT_EQ(job.newest(), nullptr);
}

}  // namespace
}  // namespace taxel::studio
