#include "ui/scene/passes/key_shadow.h"

#include <glm/gtc/matrix_transform.hpp>

#include "ui/gl/bindings.h"
#include "ui/gl/framebuffer.h"
#include "ui/gl/state.h"
#include "ui/scene/passes/top_view.h"

namespace taxel::ui {
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
