#include "ui/scene/draw/ground.h"

#include <glm/gtc/matrix_transform.hpp>

#include "ui/gl/state.h"

namespace taxel::ui {
namespace {

constexpr int kShadowTexels = 96;
constexpr double kShadowMargin = 0.35;  // around the casters, parts of their size
constexpr double kShadowHeight = 0.22;  // parts of the casters' size at which the shadow is a third as dark
constexpr float kShadeTowardEye = 1e-4f;  // the shadow before its ground
constexpr int kFanVertices = 26;        // centre, 24 sides and the first again
constexpr double kGridReach = 6.0;      // camera distances

/// The axes of the ground, fading away from `target` (ground frame) like the grid.
void draw_axes(const Ground& ground, const dvec3& target, double reach, const Look& look, SegmentPass& segments) {
  constexpr int kPieces = 24;
  const auto fade = [&](const dvec3& p) {
    const double d = glm::length(dvec2(p - target)) / reach;
    return static_cast<float>(0.8 * std::clamp(1.25 - 1.25 * d * d, 0.0, 1.0));
  };
  Segments lines;
  for (const int axis : {0, 1}) {
    dvec3 direction(0);
    direction[axis] = 2 * reach / kPieces;
    dvec3 a(0);
    a[axis] = target[axis] - reach;
    for (int i = 0; i < kPieces; ++i, a += direction) {
      const glm::vec4 color(axis == 0 ? look.axis_x : look.axis_y, fade(a + 0.5 * direction));
      lines.push_back(segment(a, a + direction, 1.3f, pack(color)));
    }
  }
  segments.draw_lines(lines, {.world_from_model = matrix(ground.X_WP), .toward_eye = 1e-4f});
}

}  // namespace

double grid_cell(double camera_distance) { return std::pow(10.0, std::floor(std::log10(0.1 * camera_distance))); }

GroundPass::GroundPass(const gl::ShaderReader& read)
    : background_(read, "screen.vert", "background.frag"),
      ground_(read, "ground"),
      shadow_(read, "caster.vert", "shadow.frag"),
      blur_(read, "screen.vert", "blur.frag"),
      shade_(read, "shade"),
      map_(GL_R8, kShadowTexels, kShadowTexels),
      blurred_(GL_R8, kShadowTexels, kShadowTexels) {
  glNamedFramebufferTexture(map_target_.id(), GL_COLOR_ATTACHMENT0, map_.id(), 0);
  glNamedFramebufferTexture(blurred_target_.id(), GL_COLOR_ATTACHMENT0, blurred_.id(), 0);
}

void GroundPass::make_shadow(const Ground& ground, const Aabb& box_W,
                             const std::function<void(const gl::Program&)>& draw_casters) {
  glBindFramebuffer(GL_FRAMEBUFFER, map_target_.id());
  glViewport(0, 0, kShadowTexels, kShadowTexels);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  shadow_box_ = glm::vec4(0);
  if (box_W.empty()) return;

  Aabb box;  // of the casters, in the ground's frame
  const RigidTransform X_PW(ground.X_WP.inverse());
  for (int i = 0; i < 8; ++i) {
    box.include(X_PW({(i & 1) != 0 ? box_W.hi.x : box_W.lo.x, (i & 2) != 0 ? box_W.hi.y : box_W.lo.y,
                      (i & 4) != 0 ? box_W.hi.z : box_W.lo.z}));
  }
  const double size = box.diagonal(), margin = kShadowMargin * size;
  const dvec2 lo = dvec2(box.lo) - margin, hi = dvec2(box.hi) + margin;
  shadow_box_ = glm::vec4(glm::vec2(lo), glm::vec2(hi - lo));

  FrameUniforms frame;
  frame.view_from_world = matrix(ground.X_WP.inverse());
  frame.clip_from_view = glm::mat4(glm::ortho(lo.x, hi.x, lo.y, hi.y, -box.hi.z - size, -box.lo.z + size));
  bind_frame(frame_, frame);
  const dvec3 up = ground.X_WP.rotate({0, 0, 1});
  shadow_.set("ground", glm::vec4(glm::vec3(up), -glm::dot(up, ground.X_WP.p)));
  shadow_.set("shadow_height", static_cast<float>(kShadowHeight * size));
  gl::apply({.depth = GL_ALWAYS, .depth_write = false, .blend = true});
  glBlendEquation(GL_MAX);  // the lowest caster above each point decides
  shadow_.use();
  draw_casters(shadow_);

  gl::apply({.depth = GL_ALWAYS, .depth_write = false});
  constexpr float texel = 1.0f / kShadowTexels;
  blur(map_, blurred_target_.id(), {texel, 0});
  blur(blurred_, map_target_.id(), {0, texel});
}

void GroundPass::blur(const gl::Texture& from, GLuint to, const glm::vec2& direction) const {
  glBindFramebuffer(GL_FRAMEBUFFER, to);
  blur_.set("texel", direction);
  blur_.use();
  from.bind(0);
  empty_.bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void GroundPass::draw_background(const Look& look) const {
  gl::apply({.depth = GL_LEQUAL, .depth_write = false});
  background_.set("top", look.background_top);
  background_.set("bottom", look.background_bottom);
  background_.use();
  empty_.bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void GroundPass::draw(const Ground& ground, const Camera& camera, const Look& look, bool grid,
                      SegmentPass& segments) const {
  if (!grid && !ground.filled) return;
  const dvec3 target = ground.X_WP.inverse() * camera.target;
  ground_.set("world_from_ground", matrix(ground.X_WP));
  ground_.set("center", glm::vec2(target));
  ground_.set("reach", glm::vec2(1.0 / (kGridReach * camera.distance), 1.0 / grid_cell(camera.distance)));
  ground_.set("fill", ground.filled ? look.plane_fill : glm::vec4(0));
  ground_.set("line", grid ? look.grid_line : glm::vec4(0));
  ground_.use();
  gl::apply({.depth_write = ground.filled, .blend = true});
  empty_.bind();
  glDrawArrays(GL_TRIANGLE_FAN, 0, kFanVertices);
  if (grid) draw_axes(ground, target, kGridReach * camera.distance, look, segments);
}

void GroundPass::draw_shadow(const Ground& ground, const Look& look) const {
  if (shadow_box_.z <= 0) return;
  shade_.set("world_from_ground", matrix(ground.X_WP));
  shade_.set("box", shadow_box_);
  shade_.set("toward_eye", kShadeTowardEye);
  shade_.set("strength", look.shadow);
  shade_.use();
  gl::apply({.depth_write = false, .blend = true});
  map_.bind(0);
  empty_.bind();
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace taxel::ui
