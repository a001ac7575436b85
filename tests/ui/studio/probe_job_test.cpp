// The job that presses the probe, without a window: the newest pose wins, and a new model arrives with its reading.
#include "app/studio/nouns/probe/probe_job.h"
#include "app/studio/host/jobs/job_executor.h"

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>

#include "app/studio/host/document/documents.h"
#include "app/studio/host/document/edit_session.h"
#include "core/mesh/mesh_io.h"
#include "fixtures/temp_folder.h"

namespace taxel::studio {
namespace {

class ProbeJobTest : public testing::Test {
 protected:
  ProbeJobTest() {
    SensorBuild how;
    how.cache = &cache;
    document = built_in_fingertip(how);
    probe.point = document.model->layout.taxels.front().center;
  }
  SensorCache cache;
  LoadedDocument document;
  Probe probe;
  JobPool pool;
  ProbeJob job{pool};
};

TEST_F(ProbeJobTest, ReportsTheReadingOfAPress) {
  job.press(document.model, probe);
  job.wait();
  const ui::PressedProbePtr pressed = job.newest();
  ASSERT_NE(pressed, nullptr);
  EXPECT_EQ(pressed->problem, "");
  ProbePress expected;
  taxel::press(*document.model, probe, expected);
  EXPECT_EQ(pressed->state.readings, expected.reading.values);
  EXPECT_EQ(pressed->force, glm::length(expected.wrench.force));
  EXPECT_EQ(pressed->area, expected.surface.area());
  EXPECT_EQ(pressed->polygons, static_cast<int>(expected.surface.polygons.size()));
  EXPECT_EQ(pressed->state.hits.size(), document.model->rays.size());
  EXPECT_GT(pressed->force, 0.1);
  EXPECT_EQ(pool.ended(), 1U);
}

TEST_F(ProbeJobTest, PressesTheNewestOfManyPosesAndAnEqualPoseOnce) {
  for (int i = 1; i <= 100; ++i) {
    probe.depth = 1e-5 * i;
    job.press(document.model, probe);
  }
  job.wait();
  EXPECT_EQ(job.newest()->probe, probe);
  EXPECT_LT(pool.ended(), 100U) << "those in between were dropped";
  const std::uint64_t before = pool.ended();
  job.press(document.model, probe);
  job.wait();
  EXPECT_EQ(pool.ended(), before);
}

TEST_F(ProbeJobTest, GivesTheNewModelItsReading) {
  EditSession edits(pool, cache, [this](const SensorModelPtr& model) { job.model_built(model); });
  edits.open(document.project, document.mesh, "");
  job.press(document.model, probe);
  job.wait();
  TaxelChange change;
  change.id = document.model->layout.taxels.front().id;
  change.radius = 0.5 * document.model->layout.taxels.front().radius;
  edits.edit(SetTaxels{{change}});
  SensorModelPtr model;
  while (!model) {
    edits.models().wait();
    model = edits.take_model();
  }
  const ui::PressedProbePtr pressed = job.newest();
  EXPECT_EQ(pressed->model, model) << "read before it was reported";
  const std::uint64_t before = pool.ended();
  job.press(model, probe);
  EXPECT_FALSE(job.busy());
  EXPECT_EQ(pool.ended(), before);
}

TEST_F(ProbeJobTest, ReportsWhyItCannotPress) {
  const test::TempFolder folder;
  const std::string file = (folder.path() / "flat.off").string();
  std::ofstream(file) << "OFF\n3 2 0\n0 0 0\n0.01 0 0\n0 0.01 0\n3 0 1 2\n3 0 2 1\n";
  const auto problem = [&](const ProbeShape& shape) {
    probe.shape = shape;
    job.press(document.model, probe);
    job.wait();
    return job.newest()->problem;
  };
  EXPECT_NE(problem(ProbeSphere{-1}).find("radius"), std::string::npos);
  EXPECT_NE(problem(ProbeMesh{nullptr, ""}).find("choose a mesh file"), std::string::npos);
  EXPECT_NE(problem(ProbeMesh{nullptr, "no such.obj"}).find("no such.obj"), std::string::npos);
  const std::string flat = problem(ProbeMesh{nullptr, file});
  EXPECT_NE(flat.find("encloses nothing"), std::string::npos) << flat;
  EXPECT_EQ(problem(ProbeMesh{nullptr, TAXEL_SOURCE_DIR "/assets/meshes/fingertip.obj"}), "");
  EXPECT_GT(job.newest()->area, 0);
}

TEST_F(ProbeJobTest, PressesAnOpenMeshAsItsRepairClosesIt) {
  const test::TempFolder folder;
  const TriMesh whole = *load_mesh(TAXEL_SOURCE_DIR "/assets/meshes/fingertip.obj").mesh;
  const std::filesystem::path closed = folder.path() / "closed.obj", open = folder.path() / "open.obj";
  save_mesh(closed, whole);
  // The hole is where nothing touches: the highest face of the probe.
  std::vector<ivec3> faces = whole.faces();
  const auto height = [&](const ivec3& f) {
    return std::min({whole.vertices()[static_cast<std::size_t>(f.x)].z,
                     whole.vertices()[static_cast<std::size_t>(f.y)].z,
                     whole.vertices()[static_cast<std::size_t>(f.z)].z});
  };
  faces.erase(std::max_element(faces.begin(), faces.end(),
                               [&](const ivec3& a, const ivec3& b) { return height(a) < height(b); }));
  save_mesh(open, TriMesh(whole.vertices(), faces));
  ASSERT_FALSE(load_mesh(open).mesh->closed());
  const auto pressed = [&](const std::filesystem::path& file) {
    probe.shape = ProbeMesh{nullptr, file.string()};
    job.press(document.model, probe);
    job.wait();
    return job.newest();
  };
  const ui::PressedProbePtr by_closed = pressed(closed), by_open = pressed(open);
  EXPECT_EQ(by_open->problem, "");
  ASSERT_NE(by_open->mesh, nullptr);
  EXPECT_TRUE(by_open->mesh->closed());
  EXPECT_EQ(by_open->mesh->face_count(), whole.face_count());
  EXPECT_GT(by_closed->force, 0.01);
  EXPECT_NEAR(by_open->force, by_closed->force, 1e-9 * by_closed->force);
  EXPECT_EQ(by_open->polygons, by_closed->polygons);
}

TEST_F(ProbeJobTest, HasNoReadingWithoutARequest) {
  job.press(document.model, probe);
  job.press(document.model, std::nullopt);
  job.wait();
  EXPECT_EQ(job.newest(), nullptr);
}

}  // namespace
}  // namespace taxel::studio
