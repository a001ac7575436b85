// The fixed-function state of one draw. It is always set as a whole, so no draw depends on the previous one.
#pragma once

#include <epoxy/gl.h>

namespace taxel::gl {

struct DrawState {
  GLenum depth = GL_LEQUAL;  ///< depth test; GL_ALWAYS for no test
  bool depth_write = true;
  bool blend = false;     ///< blends premultiplied colours over the framebuffer
  GLenum cull = GL_NONE;  ///< culled side: GL_BACK or GL_FRONT, or GL_NONE
};

inline void enable(GLenum what, bool on) {
  if (on) {
    glEnable(what);
  } else {
    glDisable(what);
  }
}

inline void apply(const DrawState& state) {
  enable(GL_DEPTH_TEST, state.depth != GL_ALWAYS || state.depth_write);
  glDepthFunc(state.depth);
  glDepthMask(state.depth_write ? GL_TRUE : GL_FALSE);
  enable(GL_BLEND, state.blend);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  enable(GL_CULL_FACE, state.cull != GL_NONE);
  if (state.cull != GL_NONE) glCullFace(state.cull);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace taxel::gl
