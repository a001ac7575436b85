// Soft shadows by a view from above, and the shadow of the key light.
#include "ui/scene/passes/passes.h"

#include <glm/gtc/matrix_transform.hpp>

#include "ui/gl/framebuffer.h"
#include "ui/gl/objects.h"
#include "ui/gl/program.h"

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

namespace {

constexpr double kShadowMargin = 0.02;  // margin around the scene as a fraction of its size, for a soft edge
constexpr float kSlopeBias = 2.5f / 512, kBias = 2;  // for glPolygonOffset, the first one times the map's texels a side
// Distance above a surface at which its light is looked up, as a fraction of the map's width. Neither it nor the
// slope's bias gets smaller with the texels: near the edge of the light, the flat faces of a round body would shade
// parts that its smooth normals show as lit.
constexpr double kOffset = 0.0035;

/// Returns a pose whose z axis points towards the light.
Pose facing(const dvec3& light) {
  const dvec3 x = any_perpendicular(light);
  return {glm::quat_cast(dmat3(x, glm::cross(light, x), light)), dvec3(0)};
}

}  // namespace

KeyShadow::KeyShadow(const gl::ShaderReader& read, int texels)
    : depth_(read, "caster.vert", "depth.frag"), map_(GL_DEPTH_COMPONENT32F, texels, texels) {
  map_.set(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  map_.set(GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) map_.set(wrap, GL_CLAMP_TO_BORDER);
  map_.set_border({1, 1, 1, 1});  // lit
  gl::attach(target_.id(), GL_DEPTH_ATTACHMENT, map_);
  const gl::BoundDrawFramebuffer drawn(target_.id());
  const gl::BoundReadFramebuffer read_from(target_.id());
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
}

void KeyShadow::make(const Aabb& shown_W, const Aabb& casters_W, const glm::vec3& light,
                     const std::function<void(const gl::Program&)>& draw_casters) {
  offset_ = 0;
  if (shown_W.empty() || casters_W.empty()) return;
  const Pose X_LW = facing(glm::normalize(dvec3(light))).inverse();
  const Aabb shown = box_in(X_LW, shown_W), casters = box_in(X_LW, casters_W);
  const dvec2 middle(shown.center());
  const double half = (0.5 + kShadowMargin) * std::max(shown.extent().x, shown.extent().y);  // square texels
  const double deep = kShadowMargin * casters.diagonal();
  FrameUniforms frame;
  frame.view_from_world = matrix(X_LW);
  frame.clip_from_view = glm::mat4(glm::ortho(middle.x - half, middle.x + half, middle.y - half, middle.y + half,
                                              -casters.hi.z - deep, -casters.lo.z + deep));
  bind_frame(frame_, frame);
  glBindFramebuffer(GL_FRAMEBUFFER, target_.id());
  glViewport(0, 0, map_.width(), map_.height());
  gl::apply({});
  glClearDepth(1);
  glClear(GL_DEPTH_BUFFER_BIT);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(kSlopeBias * static_cast<float>(map_.width()), kBias);
  depth_.use();
  draw_casters(depth_);
  glDisable(GL_POLYGON_OFFSET_FILL);
  const glm::mat4 map_from_clip =
      glm::translate(glm::mat4(1), glm::vec3(0.5f)) * glm::scale(glm::mat4(1), glm::vec3(0.5f));
  map_from_world_ = map_from_clip * frame.clip_from_view * frame.view_from_world;
  offset_ = static_cast<float>(kOffset * 2 * half);
}

void KeyShadow::use(const gl::Program& program, GLuint unit) const {
  map_.bind(unit);
  program.set("key_map", static_cast<int>(unit));
  program.set("map_from_world", map_from_world_);
  program.set("key_offset", offset_);
}

}  // namespace taxel::ui
