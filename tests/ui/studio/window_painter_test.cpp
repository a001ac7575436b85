// Drawing only the changes gives the same frame as drawing everything, pixel by pixel, and except for rounding the same
// as drawing directly into the window.
#include "app/studio/shell/window/window_painter.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>
#include <imgui_impl_opengl3.h>

#include <string>

#include "ui/gl/framebuffer.h"

namespace taxel::studio {
namespace {

constexpr int kWidth = 400, kHeight = 300;

class WindowPainterTest : public testing::Test {
 protected:
  WindowPainterTest() : window(make_offscreen_window(kWidth, kHeight)) {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui_ImplOpenGL3_Init("#version 410 core");
  }
  ~WindowPainterTest() override {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext();
  }
  static void begin_frame() {
    ImGui::GetIO().DisplaySize = ImVec2(kWidth, kHeight);
    ImGui::GetIO().DeltaTime = 0.02f;
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
  }
  static void box(const char* name, float x, float y, const std::string& text) {
    ImGui::SetNextWindowPos({x, y});
    ImGui::SetNextWindowSize({150, 90});
    ImGui::Begin(name, nullptr, ImGuiWindowFlags_NoSavedSettings);
    ImGui::TextUnformatted(text.c_str());
    ImGui::Button("A button");
    ImGui::End();
  }
  std::vector<unsigned char> painted(WindowPainter& painter, ImTextureID scene = 0, int draws = 0) {
    painter.paint(*window, *ImGui::GetDrawData(), ImVec4(0.1f, 0.2f, 0.3f, 1), scene, draws);
    return window->read().rgb;
  }

  /// Returns the frame drawn completely, by the same method as the changes.
  std::vector<unsigned char> painted_anew() {
    anew.forget();
    return painted(anew);
  }

  std::unique_ptr<Window> window;
  WindowPainter sparing{false}, anew{false}, whole{true};
};

/// Returns the number of pixels whose colours differ by more than rounding.
int differing(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b) {
  EXPECT_EQ(a.size(), b.size());
  int count = 0;
  for (std::size_t i = 0; i + 2 < a.size() && i + 2 < b.size(); i += 3) {
    const auto far = [&](std::size_t c) { return std::abs(int{a[c]} - int{b[c]}) > 4; };
    count += far(i) || far(i + 1) || far(i + 2) ? 1 : 0;
  }
  return count;
}

TEST_F(WindowPainterTest, DrawsEveryFrameLikeACompleteRedraw) {
  long long least = kWidth * kHeight;
  for (int i = 0; i < 40; ++i) {
    begin_frame();
    box("still", 10, 10, "the same");
    box("counting", 200, 150, std::to_string(i));
    box("moving", 60.0f + 3.0f * static_cast<float>(i / 4), 60, "over others");
    if (i % 7 < 3) box("now and then", 220, 20, "half seen");
    if (i % 10 == 5) ImGui::SetWindowFocus("still");  // comes to the front
    if (i % 10 == 8) ImGui::SetWindowFocus("moving");
    if (i > 20) ImGui::GetForegroundDrawList()->AddCircle({200, 150}, 40.0f + static_cast<float>(i / 5), 0x80ffffff);
    ImGui::Render();
    const auto sparingly = painted(sparing);
    least = std::min(least, sparing.painted_pixels());
    ASSERT_EQ(sparingly, painted_anew()) << "picture " << i;
    // Drawn directly into the window, without the flip and the copy: an edge through the centre of pixels may be
    // rasterised differently.
    ASSERT_LT(differing(sparingly, painted(whole)), kWidth * kHeight / 2000) << "picture " << i;
  }
  EXPECT_LT(least, kWidth * kHeight / 4);
}

TEST_F(WindowPainterTest, DrawsNothingForAnUnchangedFrame) {
  for (int i = 0; i < 5; ++i) {
    begin_frame();
    box("still", 10, 10, "the same");
    ImGui::Render();
    painted(sparing);
  }
  EXPECT_EQ(sparing.painted_pixels(), 0);
  sparing.forget();
  EXPECT_EQ(painted(sparing), painted_anew());
  EXPECT_EQ(sparing.painted_pixels(), kWidth * kHeight);
}

TEST_F(WindowPainterTest, RedrawsAChangedTexture) {
  gl::Texture texture(GL_RGBA8, 1, 1);
  const auto show = [&](unsigned char level, int draws) {
    const std::vector<unsigned char> pixel{level, 0, 0, 255};
    texture.upload(GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
    begin_frame();
    box("still", 10, 10, "the same");
    ImGui::SetNextWindowPos({200, 100});
    ImGui::Begin("scene", nullptr, ImGuiWindowFlags_NoSavedSettings);
    ImGui::Image(static_cast<ImTextureID>(texture.id()), {50, 50});
    ImGui::End();
    ImGui::Render();
    const auto sparingly = painted(sparing, texture.id(), draws);
    EXPECT_EQ(sparingly, painted_anew());
    return sparingly;
  };
  for (int i = 0; i < 4; ++i) show(10, 1);  // ImGui sizes windows in their first frames
  const auto before = show(10, 1), after = show(200, 2);
  EXPECT_NE(before, after);
  EXPECT_LT(sparing.painted_pixels(), kWidth * kHeight / 2);
  EXPECT_GT(sparing.painted_pixels(), 0);
}

}  // namespace
}  // namespace taxel::studio
