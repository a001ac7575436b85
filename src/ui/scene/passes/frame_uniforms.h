// Uniforms that all shaders of one frame share: camera, size, lights.
#pragma once

#include <glm/glm.hpp>

#include "ui/gl/buffer.h"
#include "ui/scene/pick/camera.h"
#include "ui/scene/pick/clip_plane.h"

namespace taxel::ui {

struct Look;

/// Uniforms with the layout of `Frame` in shaders/frame.glsl (std140).
struct FrameUniforms {
  glm::mat4 view_from_world{1};
  glm::mat4 clip_from_view{1};
  glm::vec4 eye{0};
  glm::vec4 viewport{1};
  glm::vec4 key_light{0, 0, 1, 0};
  glm::vec4 sky_light{0};
  glm::vec4 ground_light{0};
  glm::vec4 clip_plane{0, 0, 0, 1};
};

/// Returns the uniforms of a perspective view. `scale` multiplies widths and diameters of marks.
FrameUniforms perspective_frame(const Camera& camera, const Look& look, int width, int height, double scale,
                                const std::optional<ClipPlane>& clip);
/// Returns the uniforms for flat drawings on the screen: coordinates are pixels of marks in a view of width x height
/// pixels, with y up and z from -1 to 1.
FrameUniforms pixel_frame(int width, int height, double scale);

/// Sends the uniforms and makes all following draws use them.
void bind_frame(gl::Buffer& buffer, const FrameUniforms& uniforms);

/// Returns a pose as a matrix for the shaders.
glm::mat4 matrix(const Pose& pose);

}  // namespace taxel::ui
