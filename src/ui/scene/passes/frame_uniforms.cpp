// Uniforms that all shaders of one frame share.
#include "ui/scene/passes/passes.h"

#include <glm/gtc/matrix_transform.hpp>

#include "ui/gl/program.h"
#include "ui/scene/passes/look.h"

namespace taxel::ui {
namespace {

glm::vec4 viewport_of(int width, int height) {
  const auto w = static_cast<float>(width), h = static_cast<float>(height);
  return {w, h, 1.0f / w, 1.0f / h};
}

}  // namespace

FrameUniforms perspective_frame(const Camera& camera, const Look& look, int width, int height, double scale,
                                const std::optional<ClipPlane>& clip) {
  FrameUniforms u;
  if (clip) u.clip_plane = glm::vec4(glm::vec3(-clip->normal), clip->offset);
  const glm::dmat4 projection = camera.projection(static_cast<double>(width) / height);
  u.view_from_world = glm::mat4(camera.view());
  u.clip_from_view = glm::mat4(projection);
  u.eye = glm::vec4(glm::vec3(camera.eye()), scale);
  u.viewport = viewport_of(width, height);
  u.key_light = glm::vec4(glm::normalize(look.key_direction), look.key);
  u.sky_light = glm::vec4(look.sky, look.headlight);
  const double near = camera.orthographic
                          ? camera.near_plane()
                          : projection[3][2] / (projection[2][2] - 1.0);  // the plane that is sent to z = -w
  u.ground_light = glm::vec4(look.ground, static_cast<float>(near));
  return u;
}

FrameUniforms pixel_frame(int width, int height, double scale) {
  FrameUniforms u;
  u.clip_from_view = glm::mat4(glm::ortho(0.0, width / scale, 0.0, height / scale, -1.0, 1.0));
  u.eye.w = static_cast<float>(scale);
  u.viewport = viewport_of(width, height);
  u.ground_light.w = -2;  // nothing is clipped
  return u;
}

void bind_frame(gl::Buffer& buffer, const FrameUniforms& uniforms) {
  buffer.upload(std::span<const FrameUniforms>(&uniforms, 1), GL_STREAM_DRAW);
  glBindBufferBase(GL_UNIFORM_BUFFER, gl::kFrameBinding, buffer.id());
}

glm::mat4 matrix(const Pose& pose) {
  glm::mat4 m(glm::mat3(pose.rotation()));
  m[3] = glm::vec4(glm::vec3(pose.p), 1);
  return m;
}

}  // namespace taxel::ui
