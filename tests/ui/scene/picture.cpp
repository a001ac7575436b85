#include "ui/scene/picture.h"

#include <imgui.h>
#include <imgui_impl_opengl3.h>
#include <implot.h>

#include <cmath>
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

namespace {

/// Returns L*, a* and b* of an sRGB colour.
dvec3 lab(const std::array<int, 3>& rgb) {
  dvec3 linear;
  for (int i = 0; i < 3; ++i) {
    const double c = rgb[static_cast<std::size_t>(i)] / 255.0;
    linear[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  const dvec3 xyz(glm::dot(dvec3(0.4124, 0.3576, 0.1805), linear) / 0.95047,
                  glm::dot(dvec3(0.2126, 0.7152, 0.0722), linear),
                  glm::dot(dvec3(0.0193, 0.1192, 0.9505), linear) / 1.08883);
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
  return {116 * f(xyz.y) - 16, 500 * (f(xyz.x) - f(xyz.y)), 200 * (f(xyz.y) - f(xyz.z))};
}

}  // namespace

double color_difference(const std::array<int, 3>& a, const std::array<int, 3>& b) {
  return glm::distance(lab(a), lab(b));
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
