// The percentage of a bar of progress, which no end of the bar crosses.
#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>

#include "interface_frames.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {
namespace {

/// Returns the place of a widget with this label, or an empty rectangle.
Rect place_of_label(const Ui& ui, const std::string& label) {
  for (const WidgetRegistry::Entry& widget : ui.widgets.entries())
    if (widget.label == label) return widget.rect;
  return {};
}

TEST(ProgressBar, HasItsPercentageToTheRightOfTheBar) {
  test::InterfaceFrames frames;
  for (const float fraction : {0.0f, 0.03f, 0.5f, 0.97f, 1.0f}) {
    for (const float width : {240.0f, -30.0f}) {
      Ui ui;
      float left = 0, end = 0;
      frames.frame([&] {
        ImGui::SetNextWindowSize({300, 100});
        ImGui::Begin("window");
        left = ImGui::GetCursorScreenPos().x;
        end = width > 0 ? left + width : left + ImGui::GetContentRegionAvail().x + width;
        progress_bar(ui, fraction, width);
        ImGui::End();
      });
      const Rect bar = place_of_label(ui, "Progress");
      const Rect text = place_of_label(ui, std::to_string(std::lround(100 * fraction)) + " %");
      EXPECT_GT(bar.width(), 100) << fraction;
      EXPECT_GT(text.x0, bar.x1) << fraction << ": the text is not on the bar";
      EXPECT_NEAR(text.x1, end, 1) << fraction << ": both fill the width";
      EXPECT_NEAR(bar.x0, left, 1);
    }
  }
}

TEST(ProgressBar, HasNoPercentageForAnUnknownLength) {
  test::InterfaceFrames frames;
  Ui ui;
  frames.frame([&] {
    ImGui::SetNextWindowSize({300, 100});
    ImGui::Begin("window");
    progress_bar(ui, -1, 200);
    ImGui::End();
  });
  EXPECT_NEAR(place_of_label(ui, "Progress").width(), 200, 1);
  EXPECT_EQ(ui.widgets.entries().size(), 1U);
}

}  // namespace
}  // namespace taxel::ui
