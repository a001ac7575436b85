// The mouse over the 3-D view: the effect of each button, the wheel and the modifiers.
#include <gtest/gtest.h>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/measure/measure_state.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "app/studio/shell/interface/interface.h"
#include "ui/tools/interface_frames.h"
#include "ui/tools/tool_scene.h"

namespace taxel::ui {
namespace {

/// The view of a ball with one taxel, which fills the window.
struct View {
  test::InterfaceFrames interface;
  test::ToolScene scene{{dvec3(1, 0, 0)}};

  View() {
    interface.move(100, 100);
    for (int i = 0; i < 3; ++i) frame();
  }
  void frame() {
    interface.frame([&] {
      ImGui::SetNextWindowPos({0, 0});
      ImGui::SetNextWindowSize({800, 600});
      ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
      ImGui::Begin("view", nullptr, ImGuiWindowFlags_NoDecoration);
      ImGui::InvisibleButton(
          "##view", {800, 600},
          ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
      handle_view_mouse(scene.app);
      ImGui::End();
      ImGui::PopStyleVar();
    });
  }
  void drag(int button, const dvec2& by) {
    const ImVec2 from = ImGui::GetIO().MousePos;
    ImGui::GetIO().AddMouseButtonEvent(button, true);
    frame();
    interface.move(from.x + by.x, from.y + by.y);
    frame();
    ImGui::GetIO().AddMouseButtonEvent(button, false);
    frame();
  }
  void click(const dvec2& at) {
    interface.move(at.x, at.y);
    frame();
    drag(ImGuiMouseButton_Left, {0, 0});
    for (int i = 0; i < 30; ++i) frame();  // so that the next click is not a double-click
  }
  void wheel(float notches) {
    ImGui::GetIO().AddMouseWheelEvent(0, notches);
    frame();
  }
  Camera& camera() { return scene.app.viewer->camera(); }
};

TEST(ViewMouse, OrbitsInTheDirectionOfTheDrag) {
  View view;
  const dvec3 front(test::kBallRadius, 0, 0);
  const dvec2 before = view.scene.pixel(front);
  view.drag(ImGuiMouseButton_Left, {40, 0});
  EXPECT_GT(view.scene.pixel(front).x, before.x + 1) << "the near side goes along";
  view.drag(ImGuiMouseButton_Left, {-40, 30});
  EXPECT_GT(view.scene.pixel(front).y, before.y + 1);
}

TEST(ViewMouse, KeepsTheHeightOfAPanWithShift) {
  View view;
  view.camera().elevation_deg = 40;
  const Camera before = view.camera();
  const dvec2 pixel = view.scene.pixel(before.target);
  view.drag(ImGuiMouseButton_Right, {30, 20});
  EXPECT_NEAR(view.scene.pixel(before.target).x, pixel.x + 30, 0.5);
  EXPECT_NEAR(view.scene.pixel(before.target).y, pixel.y + 20, 0.5);
  EXPECT_NE(view.camera().target.z, before.target.z);
  view.camera() = before;
  view.interface.key(ImGuiMod_Shift, true);
  view.drag(ImGuiMouseButton_Right, {30, 20});
  EXPECT_EQ(view.camera().target.z, before.target.z);
  EXPECT_NE(view.camera().target.x, before.target.x);
}

TEST(ViewMouse, ZoomsMovesTheClipPlaneOrResizesByTheWheel) {
  View view;
  const double distance = view.camera().distance;
  view.wheel(1);
  EXPECT_LT(view.camera().distance, distance);
  EXPECT_FALSE(view.scene.app.viewer->clip);
  view.interface.key(ImGuiMod_Shift, true);
  const double near = view.camera().distance;
  view.wheel(1);
  ASSERT_TRUE(view.scene.app.viewer->clip) << "the first notch makes the plane";
  const double offset = view.scene.app.viewer->clip->offset;
  view.wheel(1);
  EXPECT_LT(view.scene.app.viewer->clip->offset, offset) << "a notch forward goes into the skin";
  EXPECT_NEAR(offset - view.scene.app.viewer->clip->offset,
              0.02 * view.scene.app.shown->document.model->mesh->bounds().diagonal(), 1e-12);
  EXPECT_EQ(view.camera().distance, near);
  view.interface.key(ImGuiMod_Shift, false);
  view.interface.key(ImGuiMod_Ctrl, true);
  view.scene.app.viewer->selection.set(1);
  view.wheel(1);
  const auto& changes = std::get<SetTaxels>(view.scene.asked<EditProject>()->edit).changes;
  EXPECT_NEAR(changes.at(0).radius.value(), 1.02 * 0.002, 1e-15) << "2 % a notch";
  EXPECT_EQ(view.camera().distance, near);
}

TEST(ViewMouse, ErasesWithTheBrushByShiftAndCtrl) {
  for (const ImGuiKey modifier : {ImGuiKey_None, ImGuiMod_Shift, ImGuiMod_Ctrl}) {
    View view;
    std::vector<int> region;
    for (int face = 0; modifier != ImGuiKey_None && face < view.scene.app.shown->document.model->mesh->face_count();
         ++face)
      region.push_back(face);
    view.scene.project.layout.sampling.region = region;
    const std::size_t before = region.size();
    view.scene.publish();
    view.scene.app.get<ToolState>().tool = Tool::brush;
    view.scene.app.get<ToolState>().brush.radius = 0.003;
    if (modifier != ImGuiKey_None) view.interface.key(modifier, true);
    view.interface.move(400, 300);
    view.frame();
    view.drag(ImGuiMouseButton_Left, {5, 0});
    ASSERT_NE(view.scene.asked<EditProject>(), nullptr);
    const std::size_t after = std::get<SetRegion>(view.scene.asked<EditProject>()->edit).faces.size();
    if (modifier == ImGuiKey_None)
      EXPECT_GT(after, before);
    else
      EXPECT_LT(after, before) << ImGui::GetKeyName(modifier);
  }
}

TEST(ViewMouse, StartsTheNextMeasurementByAThirdClick) {
  View view;
  toggle_measure(*view.scene.app.viewer, view.scene.app.shown->document, view.scene.app.get<MeasureState>());
  ASSERT_TRUE(view.scene.app.get<MeasureState>().on);
  view.click({380, 330});
  EXPECT_EQ(view.scene.app.get<MeasureState>().points.size(), 1U);
  view.click({440, 330});
  EXPECT_EQ(view.scene.app.get<MeasureState>().points.size(), 2U);
  const dvec3 second = view.scene.app.get<MeasureState>().points[1].at;
  view.click({430, 270});
  ASSERT_EQ(view.scene.app.get<MeasureState>().points.size(), 1U);
  EXPECT_NE(view.scene.app.get<MeasureState>().points[0].at, second);
}

}  // namespace
}  // namespace taxel::ui
