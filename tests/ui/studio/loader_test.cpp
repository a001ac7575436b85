// Loading in the worker: progress while samples are built, and cancelling.
#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <set>
#include <thread>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/host/document/document.h"
#include "app/studio/host/jobs/job_executor.h"
#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/files/files_state.h"
#include "fixtures/run_program.h"
#include "studio_program.h"

namespace taxel::studio {
namespace {

using namespace std::chrono_literals;

/// Writes our fingertip with `density` samples per square metre.
std::string layout_of_density(double density) {
  const testing::TestInfo& info = *testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = test::fresh_folder(std::filesystem::path(TAXEL_BINARY_DIR) / "studio_tests",
                                         std::string(info.test_suite_name()) + "." + info.name());
  const std::string assets = TAXEL_SOURCE_DIR "/assets";
  test::Json layout = test::Json::parse(test::file_text(assets + "/layouts/fingertip.taxels.json"));
  layout["mesh"]["file"] = assets + "/meshes/fingertip.obj";
  layout["sampling"]["density"] = density;
  test::write_text(folder / "dense.taxels.json", layout.dump());
  return (folder / "dense.taxels.json").string();
}

/// Returns the next result of a loader that is busy.
LoadResult next(Loader& loader) {
  loader.wait();
  std::optional<LoadResult> result = loader.take();
  if (!result) throw std::runtime_error("nothing is loading");
  return std::move(*result);
}

/// Records `fraction` until the next result, and returns this result.
LoadResult watched(Loader& loader, std::set<double>& seen) {
  double before = 0;
  while (true) {
    const double now = loader.fraction();
    if (std::optional<LoadResult> result = loader.take()) return std::move(*result);
    EXPECT_GE(now, before) << "the bar never goes back";
    seen.insert(before = now);
    std::this_thread::sleep_for(200us);
  }
}

TEST(Loader, GivesThePreviewFirstAndThenPolishedSamples) {
  const std::string file = layout_of_density(2e7);
  SensorCache cache;
  JobPool pool;
  Loader loader(pool, cache);
  EXPECT_FALSE(loader.busy());
  loader.start(file);
  EXPECT_TRUE(loader.busy() && loader.loading());
  std::set<double> loading, polishing;
  const LoadResult first = watched(loader, loading);
  ASSERT_TRUE(std::holds_alternative<LoadedDocument>(first));
  const LoadedDocument& document = std::get<LoadedDocument>(first);
  EXPECT_EQ(document.model->taxel_count(), 12);
  EXPECT_TRUE(document.previewed());
  EXPECT_TRUE(loader.polishing() && !loader.loading());
  const LoadResult second = watched(loader, polishing);
  for (const std::set<double>& seen : {loading, polishing})
    EXPECT_GE(std::count_if(seen.begin(), seen.end(), [](double f) { return f > 0 && f < 1; }), 3);
  ASSERT_TRUE(std::holds_alternative<Polished>(second));
  const Polished& polished = std::get<Polished>(second);
  EXPECT_EQ(polished.preview, document.model);
  EXPECT_EQ(polished.model->quality, SampleQuality::polished);
  EXPECT_EQ(polished.model->body, document.model->body) << "which is not made twice";
  EXPECT_FALSE(loader.busy());
  EXPECT_FALSE(loader.take()) << "once";

  const SensorModelPtr alone = load_sensor_model(file);
  ASSERT_EQ(polished.model->samples.size(), alone->samples.size());
  for (std::size_t i = 0; i < alone->samples.size(); ++i)
    ASSERT_EQ(polished.model->samples[i].position, alone->samples[i].position) << "the same as without a preview";
}

TEST(Loader, KeepsThePolishedSamplesIfOnlyTaxelsChanged) {
  const std::string file = layout_of_density(1e6);
  SensorCache cache;
  JobPool pool;
  Loader loader(pool, cache);
  loader.start(file);
  next(loader);
  const SensorModelPtr before = std::get<Polished>(next(loader)).model;
  test::Json layout = test::Json::parse(test::file_text(file));
  layout["taxels"][3]["radius"] = 0.004;
  test::write_text(file, layout.dump());
  loader.start(file);
  const SensorModelPtr after = std::get<LoadedDocument>(next(loader)).model;
  EXPECT_EQ(after->quality, SampleQuality::polished) << "at once";
  EXPECT_FALSE(loader.busy());
  EXPECT_EQ(after->body, before->body);
  EXPECT_EQ(after->samples[7].position, before->samples[7].position);
  EXPECT_LT(after->fields.entries.size(), before->fields.entries.size());
}

TEST(Loader, EndsARunningLoadByCancel) {
  std::chrono::steady_clock::time_point cancelled;
  {
    SensorCache cache;
    JobPool pool;
    Loader loader(pool, cache);
    loader.start(layout_of_density(1e8));
    while (loader.fraction() == 0) std::this_thread::sleep_for(200us);
    loader.cancel();
    cancelled = std::chrono::steady_clock::now();
    EXPECT_TRUE(loader.busy()) << "until the cancellation is reported";
    EXPECT_TRUE(std::holds_alternative<LoadCancelled>(next(loader)));
    EXPECT_FALSE(loader.busy());
    EXPECT_FALSE(loader.take());
  }
  EXPECT_LT(std::chrono::steady_clock::now() - cancelled, 10s) << "a million samples take longer";
}

TEST(Loader, KeepsTheDocumentIfPolishingIsCancelled) {
  SensorCache cache;
  JobPool pool;
  Loader loader(pool, cache);
  loader.start(layout_of_density(1e7));
  const LoadedDocument document = std::get<LoadedDocument>(next(loader));
  while (loader.fraction() == 0) std::this_thread::sleep_for(200us);
  loader.cancel();
  EXPECT_TRUE(std::holds_alternative<PolishCancelled>(next(loader)));
  EXPECT_FALSE(loader.busy());
  loader.polish(document);  // now without cancelling
  EXPECT_TRUE(loader.polishing());
  EXPECT_EQ(std::get<Polished>(next(loader)).preview, document.model);
}

TEST(Loader, DropsAFinishedResultThatIsCancelled) {
  SensorCache cache;
  JobPool pool;
  Loader loader(pool, cache);
  loader.start(layout_of_density(1e5));
  loader.wait();
  loader.cancel();
  EXPECT_TRUE(std::holds_alternative<LoadCancelled>(next(loader)));
  loader.start(layout_of_density(1e5));
  loader.wait();
  loader.close();
  EXPECT_FALSE(loader.busy());
  EXPECT_FALSE(loader.take()) << "nothing is reported";
}

TEST(Loader, ReportsAFailureOfPolishing) {
  SensorCache cache;
  JobPool pool;
  Loader loader(pool, cache);
  loader.start(layout_of_density(1e5));
  LoadedDocument document = std::get<LoadedDocument>(next(loader));
  document.compile = [](const SensorBuild&) -> SensorModelPtr { throw std::runtime_error("no memory"); };
  loader.polish(document);
  const LoadResult result = next(loader);
  ASSERT_TRUE(std::holds_alternative<PolishFailed>(result));
  EXPECT_EQ(std::get<PolishFailed>(result).reason, "no memory");
  EXPECT_FALSE(loader.busy());
}

TEST(Loader, ReplacesALoadByTheNextOne) {
  SensorCache cache;
  JobPool pool;
  Loader loader(pool, cache);
  loader.start(layout_of_density(1e8));
  loader.start("nothing.obj");
  const LoadResult result = next(loader);
  ASSERT_TRUE(std::holds_alternative<LoadFailed>(result));
  EXPECT_EQ(std::get<LoadFailed>(result).reason, "nothing.obj: no such file");
  EXPECT_FALSE(loader.busy());
}

/// Panels in their own window, without a renderer.
class Panels : public testing::Test {
 protected:
  Panels() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = ImVec2(800, 600);
    io.BackendFlags |= ImGuiBackendFlags_RendererHasTextures;
    app_.viewer->view.rect = {0, 0, 800, 600};
  }
  ~Panels() override { ImGui::DestroyContext(); }
  /// Draws some frames, so that windows find their size.
  void draw(int pictures = 3) {
    for (int i = 0; i < pictures; ++i) {
      app_.ui->widgets.begin_frame();
      ImGui::GetIO().DeltaTime = 0.02f;
      ImGui::NewFrame();
      ui::draw_loading(*app_.ui, app_.viewer->view, app_.shown->document);
      ImGui::EndFrame();
    }
  }
  ui::App app_;
};

TEST_F(Panels, ShowABarWithCancelAfterHalfASecond) {
  app_.shown->document.loading = {true, "dense.taxels.json", 0.3, 0.4, true, "Filling holes"};
  draw();
  EXPECT_EQ(app_.ui->widgets.find("Progress"), nullptr) << "not worth a bar yet";
  app_.shown->document.loading.seconds = 0.6;
  draw();
  ASSERT_NE(app_.ui->widgets.find("Progress"), nullptr);
  EXPECT_NE(app_.ui->widgets.find("Filling holes"), nullptr) << "the step of the work";
  const ui::WidgetRegistry::Entry* cancel = app_.ui->widgets.find("Cancel loading");
  ASSERT_NE(cancel, nullptr);
  ImGuiIO& io = ImGui::GetIO();
  io.AddMousePosEvent(cancel->rect.center_x(), cancel->rect.center_y());
  draw();
  EXPECT_TRUE(app_.ui->commands.empty());
  io.AddMouseButtonEvent(0, true);
  io.AddMouseButtonEvent(0, false);
  draw();
  ASSERT_EQ(app_.ui->commands.size(), 1U);
  EXPECT_TRUE(app_.ui->commands[0].is<ui::CancelLoading>());
  app_.shown->document.loading.can_cancel = false;  // a scene: MuJoCo's compiler cannot be stopped
  draw();
  EXPECT_NE(app_.ui->widgets.find("Progress"), nullptr);
  EXPECT_EQ(app_.ui->widgets.find("Cancel loading"), nullptr);
  app_.shown->document.loading.active = false;
  draw();
  EXPECT_EQ(app_.ui->widgets.find("Progress"), nullptr);
}

}  // namespace
}  // namespace taxel::studio
