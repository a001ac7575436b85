// Edits and the worker that compiles them, in real time and without a window: the interface never waits, and the newest
// edit wins.
#include "app/studio/host/document/edit_session.h"
#include "app/studio/host/jobs/job_executor.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>

#include "app/studio/host/document/documents.h"

namespace taxel::studio {
namespace {

Edit resized(int id, double radius) {
  TaxelChange change;
  change.id = id;
  change.radius = radius;
  return SetTaxels{{change}};
}

class EditSessionTest : public testing::Test {
 protected:
  EditSessionTest() {
    SensorBuild how;
    how.cache = &cache;
    const LoadedDocument document = built_in_fingertip(how);
    edits.open(document.project, document.mesh, "fingertip.taxels.json");
  }
  /// Returns the newest model as soon as nothing is left to build.
  SensorModelPtr settled() {
    SensorModelPtr newest;
    while (edits.models().busy()) {
      edits.models().wait();
      if (SensorModelPtr model = edits.take_model()) newest = model;
    }
    return newest;
  }

  SensorCache cache;
  JobPool pool;
  EditSession edits{pool, cache};
};

TEST_F(EditSessionTest, CompilesTheNewestOfManyEditsInTheBackground) {
  const auto began = std::chrono::steady_clock::now();
  constexpr int kEdits = 200;
  for (int i = 1; i <= kEdits; ++i) edits.edit(resized(3, 1e-3 + 1e-5 * i));
  const double asked = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  const SensorModelPtr model = settled();
  const double built = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  ASSERT_NE(model, nullptr);
  EXPECT_EQ(model->layout, edits.project()->layout);
  EXPECT_EQ(find_taxel(model->layout, 3)->radius, 1e-3 + 1e-5 * kEdits);
  EXPECT_GT(pool.ended(), 0U);
  EXPECT_LT(pool.ended(), std::uint64_t{kEdits}) << "those in between were dropped";
  std::printf("%d edits asked in %.1f ms, the last one compiled after %.1f ms\n", kEdits, 1e3 * asked, 1e3 * built);
}

TEST_F(EditSessionTest, CompilesTheModelAfterUndo) {
  const Layout before = edits.project()->layout;
  edits.edit(DeleteTaxels{{3, 5}});
  EXPECT_EQ(settled()->taxel_count(), 10);
  edits.undo();
  EXPECT_EQ(settled()->layout, before);
  EXPECT_FALSE(edits.dirty());
}

TEST_F(EditSessionTest, ChangesAndBuildsNothingIfAnEditIsRefused) {
  const ProjectPtr before = edits.project();
  EXPECT_THROW(edits.edit(resized(3, -1)), Error);
  EXPECT_THROW(edits.edit(DeleteTaxels{{77}}), Error);
  EXPECT_EQ(edits.project(), before);
  EXPECT_FALSE(edits.models().busy());
}

TEST_F(EditSessionTest, ReportsNoModelAfterClose) {
  edits.edit(resized(3, 2e-3));
  edits.close();
  EXPECT_EQ(settled(), nullptr);
  EXPECT_FALSE(edits.is_open());
  edits.edit(resized(3, 2e-3));
  EXPECT_FALSE(edits.models().busy()) << "there is nothing to edit";
}

}  // namespace
}  // namespace taxel::studio
