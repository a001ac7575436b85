// Loading in the worker: progress while samples are built, and Cancel.
#include "app/studio/loader.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <set>
#include <thread>

#include "fixtures/run_program.h"
#include "studio_program.h"
#include "ui/panels/dialogs.h"

namespace taxel::studio {
namespace {

using namespace std::chrono_literals;

/// Our fingertip with so many samples per square metre.
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

TEST(Loader, ProgressGrowsUntilTheDocumentIsThere) {
  Loader loader;
  EXPECT_FALSE(loader.busy());
  loader.start(layout_of_density(2e7));
  EXPECT_TRUE(loader.busy());
  std::set<double> seen;
  double before = 0;
  std::optional<LoadResult> result;
  while (!(result = loader.take())) {
    const double now = loader.fraction();
    EXPECT_GE(now, before) << "the bar never goes back";
    seen.insert(before = now);
    std::this_thread::sleep_for(200us);
  }
  EXPECT_GE(std::count_if(seen.begin(), seen.end(), [](double f) { return f > 0 && f < 1; }), 3);
  ASSERT_TRUE(std::holds_alternative<Document>(*result));
  EXPECT_EQ(std::get<Document>(*result).model->taxel_count(), 12);
  EXPECT_EQ(loader.fraction(), 1);
  EXPECT_FALSE(loader.busy());
  EXPECT_FALSE(loader.take()) << "once";
}

TEST(Loader, CancelEndsALoadThatHasBegun) {
  Loader loader;
  loader.start(layout_of_density(1e8));
  while (loader.fraction() == 0) std::this_thread::sleep_for(200us);
  loader.cancel();
  loader.wait();
  const std::optional<LoadResult> result = loader.take();
  ASSERT_TRUE(result);
  EXPECT_TRUE(std::holds_alternative<LoadCancelled>(*result));
  EXPECT_LT(loader.fraction(), 1) << "it did not run to its end";
  EXPECT_FALSE(loader.busy());
}

TEST(Loader, AnotherLoadTakesTheFirstOnesPlace) {
  Loader loader;
  loader.start(layout_of_density(1e8));
  loader.start("nothing.obj");
  loader.wait();
  const std::optional<LoadResult> result = loader.take();
  ASSERT_TRUE(result && std::holds_alternative<LoadFailed>(*result));
  EXPECT_EQ(std::get<LoadFailed>(*result).reason, "nothing.obj: no such file");
}

/// Panels in a window of their own, without anything that draws.
class Panels : public testing::Test {
 protected:
  Panels() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = ImVec2(800, 600);
    io.BackendFlags |= ImGuiBackendFlags_RendererHasTextures;
    ui_.view.rect = {0, 0, 800, 600};
  }
  ~Panels() override { ImGui::DestroyContext(); }
  /// Some pictures, so that windows find their size.
  void draw(int pictures = 3) {
    for (int i = 0; i < pictures; ++i) {
      ui_.widgets.begin_frame();
      ImGui::GetIO().DeltaTime = 0.02f;
      ImGui::NewFrame();
      ui::draw_loading(ui_, input_);
      ImGui::EndFrame();
    }
  }
  ui::UiState ui_;
  ui::UiInput input_;
};

TEST_F(Panels, ALoadOfOverHalfASecondShowsABarWithCancel) {
  input_.loading = {true, "dense.taxels.json", 0.3, 0.4, true};
  draw();
  EXPECT_EQ(ui_.widgets.find("Progress"), nullptr) << "not worth a bar yet";
  input_.loading.seconds = 0.6;
  draw();
  ASSERT_NE(ui_.widgets.find("Progress"), nullptr);
  const ui::WidgetRegistry::Entry* cancel = ui_.widgets.find("Cancel loading");
  ASSERT_NE(cancel, nullptr);
  ImGuiIO& io = ImGui::GetIO();
  io.AddMousePosEvent(cancel->rect.center_x(), cancel->rect.center_y());
  draw();
  EXPECT_TRUE(ui_.requests.empty());
  io.AddMouseButtonEvent(0, true);
  io.AddMouseButtonEvent(0, false);
  draw();
  ASSERT_EQ(ui_.requests.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<ui::CancelLoading>(ui_.requests[0]));
  input_.loading.can_cancel = false;  // a scene: MuJoCo's compiler cannot be stopped
  draw();
  EXPECT_NE(ui_.widgets.find("Progress"), nullptr);
  EXPECT_EQ(ui_.widgets.find("Cancel loading"), nullptr);
  input_.loading.active = false;
  draw();
  EXPECT_EQ(ui_.widgets.find("Progress"), nullptr);
}

}  // namespace
}  // namespace taxel::studio
