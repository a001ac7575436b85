#include "ui/scene/passes/top_view.h"

#include <glm/gtc/matrix_transform.hpp>

#include "ui/gl/state.h"

namespace taxel::ui {
namespace {

constexpr int kTexels = 96;
constexpr double kTopViewMargin = 0.35;  // around the casters, parts of their size

}  // namespace

Aabb box_in(const Pose& X_PW, const Aabb& box_W) {
  Aabb box;
  const RigidTransform X(X_PW);
  for (int i = 0; i < 8; ++i) {
    box.include(X({(i & 1) != 0 ? box_W.hi.x : box_W.lo.x, (i & 2) != 0 ? box_W.hi.y : box_W.lo.y,
                   (i & 4) != 0 ? box_W.hi.z : box_W.lo.z}));
  }
  return box;
}

TopView::TopView(const gl::ShaderReader& read)
    : blur_(read, "screen.vert", "blur.frag"), map_(GL_R8, kTexels, kTexels), blurred_(GL_R8, kTexels, kTexels) {
  gl::attach(map_target_.id(), GL_COLOR_ATTACHMENT0, map_);
  gl::attach(blurred_target_.id(), GL_COLOR_ATTACHMENT0, blurred_);
}

bool TopView::begin(const Pose& X_WP, const Aabb& box_W, float empty) {
  glBindFramebuffer(GL_FRAMEBUFFER, map_target_.id());
  glViewport(0, 0, kTexels, kTexels);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glClearColor(empty, empty, empty, empty);
  glClear(GL_COLOR_BUFFER_BIT);
  box_ = glm::vec4(0);
  if (box_W.empty()) return false;
  casters_ = box_in(X_WP.inverse(), box_W);
  const double size = casters_.diagonal(), margin = kTopViewMargin * size;
  const dvec2 lo = dvec2(casters_.lo) - margin, hi = dvec2(casters_.hi) + margin;
  box_ = glm::vec4(glm::vec2(lo), glm::vec2(hi - lo));
  FrameUniforms frame;
  frame.view_from_world = matrix(X_WP.inverse());
  frame.clip_from_view = glm::mat4(glm::ortho(lo.x, hi.x, lo.y, hi.y, -casters_.hi.z - size, -casters_.lo.z + size));
  bind_frame(frame_, frame);
  return true;
}

void TopView::blur() const {
  gl::apply({.depth = GL_ALWAYS, .depth_write = false});
  constexpr float texel = 1.0f / kTexels;
  blur(map_, blurred_target_.id(), {texel, 0});
  blur(blurred_, map_target_.id(), {0, texel});
}

void TopView::blur(const gl::Texture& from, GLuint to, const glm::vec2& step) const {
  glBindFramebuffer(GL_FRAMEBUFFER, to);
  blur_.set("texel", step);
  blur_.use();
  from.bind(0);
  empty_.bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace taxel::ui
