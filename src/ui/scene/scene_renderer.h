// The renderer of the 3-D view: draws one SimFrame into an offscreen texture. Independent of ImGui, MuJoCo and files.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/shared_value.h"
#include "ui/gl/program.h"
#include "ui/gl/rgb_image.h"
#include "ui/scene/camera.h"
#include "ui/scene/geometry/shown_fields.h"
#include "ui/scene/scene_input.h"

namespace taxel::ui {

/// The effort for a frame. On the GPU frames are multisampled, with finer shadows and, until it is switched off, with
/// ambient occlusion.
enum class RenderEffort { software, gpu };

class SceneRenderer {
 public:
  /// Requires a current OpenGL 4.1 core context (epoxy). `shaders` returns GLSL by file name: the shaders in the
  /// program, or other ones from a folder. By default the driver decides the effort: a software renderer, such as
  /// llvmpipe, takes the lower one. Throws Error (file, line) if a shader does not compile.
  explicit SceneRenderer(const gl::ShaderReader& shaders = gl::read_embedded_shader,
                         std::optional<RenderEffort> effort = std::nullopt);
  ~SceneRenderer();
  SceneRenderer(const SceneRenderer&) = delete;
  SceneRenderer& operator=(const SceneRenderer&) = delete;

  /// Draws into an internal framebuffer of width x height pixels (sRGB values in RGBA8, top row last, as in GL), which
  /// is multisampled only with the effort of a GPU. Does nothing if input, camera and size are those of the last call.
  /// The bound framebuffer remains bound; other GL state may change.
  void render(const SceneInput& input, const Camera& camera, int width, int height);
  /// Returns an image of any size with only bodies and marks, on a transparent background without grid, ground shadow
  /// and gizmo. Throws Error if the driver cannot make an image of this size. The next render() draws everything again.
  [[nodiscard]] gl::RgbaImage cut_out(const SceneInput& input, const Camera& camera, int width, int height);
  /// Returns an image of any size without the gizmo. `draw_over` draws into the framebuffer that is bound when it is
  /// called. Throws Error if the driver cannot make an image of this size. The next render() draws everything again.
  [[nodiscard]] gl::RgbImage image(const SceneInput& input, const Camera& camera, int width, int height,
                                   const std::function<void()>& draw_over);
  [[nodiscard]] unsigned texture() const;      ///< GL name of the colour texture of the last render
  [[nodiscard]] gl::RgbImage picture() const;  ///< pixels of the last render, top row first; draws it if it is not
  [[nodiscard]] FieldNumbers field_numbers() const;  ///< numbers of the overlays in the last render
  [[nodiscard]] RenderEffort effort() const;
  /// Sets whether render() only prepares a frame: it computes the numbers and sends the meshes to the graphics card.
  void set_draws_on_request(bool on);
  /// Draws the last frame into texture() if it was only prepared.
  void draw_prepared() const;
  /// Sets whether creases and corners of solid bodies get less light.
  void set_ambient_occlusion(bool on);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace taxel::ui
