#include "ui/scene/picture.h"

#include <imgui.h>
#include <imgui_impl_opengl3.h>
#include <implot.h>

#include <filesystem>

#include "ui/gl/framebuffer.h"
#include "ui/theme.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace taxel::test {

gl::OffscreenContext& context() {
  static gl::OffscreenContext instance;
  return instance;
}

void write_picture(const std::string& name, const gl::RgbImage& image) {
  const auto folder = std::filesystem::path(TAXEL_BINARY_DIR) / "pictures";
  std::filesystem::create_directories(folder);
  stbi_write_png((folder / (name + ".png")).c_str(), image.width, image.height, 3, image.rgb.data(), 3 * image.width);
}

std::array<int, 3> pixel_at(const gl::RgbImage& image, const dvec2& position) {
  const auto x = static_cast<std::size_t>(std::floor(position.x)), y = static_cast<std::size_t>(std::floor(position.y));
  const std::size_t at = 3 * (y * static_cast<std::size_t>(image.width) + x);
  return {image.rgb.at(at), image.rgb.at(at + 1), image.rgb.at(at + 2)};
}

gl::RgbImage panel_picture(int width, int height, bool dark, const std::function<void()>& draw) {
  context();
  ImGui::CreateContext();
  ImPlot::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  ui::apply_theme(dark, 1);
  ImGui_ImplOpenGL3_Init("#version 410 core");
  const gl::Framebuffer target(width, height);
  for (int frame = 0; frame < 3; ++frame) {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(io.DisplaySize);
    ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoDecoration);
    draw();
    ImGui::End();
    ImGui::Render();
    target.bind();
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  }
  gl::RgbImage image = target.read();
  ImGui_ImplOpenGL3_Shutdown();
  ImPlot::DestroyContext();
  ImGui::DestroyContext();
  return image;
}

}  // namespace taxel::test
