// What lines, arrows, points and contact surfaces have in common when they are drawn.
#pragma once

#include <glm/glm.hpp>

#include "ui/gl/program.h"
#include "ui/gl/state.h"

namespace taxel::ui {

/// How a batch of marks is drawn.
struct MarkState {
  glm::mat4 world_from_model{1};
  float toward_eye = 0;  ///< drawn nearer by this part of its depth, at the same pixel
  bool depth_test = true;
  bool hidden = false;  ///< only where something nearer stands in front
  bool depth_write = false;
  float dim = 1;  ///< multiplies alpha
};

/// Sends the uniforms that all their shaders share, and sets depth and blending.
inline void set_mark_state(const gl::Program& program, const MarkState& state) {
  program.set("world_from_model", state.world_from_model);
  program.set("toward_eye", state.toward_eye);
  program.set("dim", state.dim);
  const GLenum test = state.hidden ? GL_GREATER : GL_LEQUAL;
  gl::apply({.depth = state.depth_test ? test : GL_ALWAYS, .depth_write = state.depth_write, .blend = true});
}

}  // namespace taxel::ui
