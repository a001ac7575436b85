// The 3-D view: draws one SimFrame into an offscreen texture. Knows no ImGui, no MuJoCo, no files.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/base/shared_value.h"
#include "ui/gl/rgb_image.h"
#include "ui/gl/shader_source.h"
#include "ui/scene/field_numbers.h"
#include "ui/scene/pick/camera.h"
#include "ui/scene/scene_input.h"

namespace taxel::ui {

class SceneRenderer {
 public:
  /// Needs a current OpenGL 4.5 core context (epoxy). `shaders` gives GLSL by file name: those built into the program,
  /// or the caller's own from a folder. Throws Error (file, line) when one does not compile.
  explicit SceneRenderer(const gl::ShaderReader& shaders = gl::read_embedded_shader);
  ~SceneRenderer();
  SceneRenderer(const SceneRenderer&) = delete;
  SceneRenderer& operator=(const SceneRenderer&) = delete;

  /// Draws into an internal framebuffer of width x height pixels (sRGB values in RGBA8, top row last as GL has it).
  /// Multisampled only on hardware renderers. Does nothing when input, camera and size are those of the last call.
  /// Leaves the framebuffer that was bound, bound; other GL state as it happens to be.
  void render(const SceneInput& input, const Camera& camera, int width, int height);
  /// Bodies and marks alone, at any size, on a transparent background without grid, shadow on the ground and gizmo.
  /// Throws Error if the driver cannot make an image of this size. The next render() draws everything again.
  [[nodiscard]] gl::RgbaImage cut_out(const SceneInput& input, const Camera& camera, int width, int height);
  [[nodiscard]] unsigned texture() const;            ///< GL name of the colour texture of the last render
  [[nodiscard]] gl::RgbImage picture() const;        ///< pixels of the last render, top row first
  [[nodiscard]] FieldNumbers field_numbers() const;  ///< numbers of the overlays in the last render
  [[nodiscard]] bool software() const;               ///< llvmpipe or the like
  /// Sets whether creases and corners of solid bodies get less light. Initially it is on for hardware renderers only,
  /// because of its cost.
  void set_ambient_occlusion(bool on);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace taxel::ui
