// Background, grid, the soft shadow on the ground, and their cached images.
#include "ui/gl/program.h"
#include "ui/scene/passes/passes.h"

namespace taxel::ui {
namespace {

constexpr double kGroundShadowHeight = 0.22;  // parts of the casters' size at which the shadow is a third as dark
constexpr float kShadeTowardEye = 1e-4f;      // the shadow before its ground
constexpr int kFanVertices = 26;              // centre, 24 sides and the first again
constexpr double kGridReach = 6.0;            // camera distances

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

double grid_cell(double camera_distance) {
  return std::pow(10.0, std::floor(std::log10(0.1 * camera_distance)));
}

GroundPass::GroundPass(const gl::ShaderReader& read)
    : background_(read, "screen.vert", "background.frag"),
      ground_(read, "ground"),
      caster_(read, "caster.vert", "shadow.frag"),
      shade_(read, "shade"),
      shadow_(read) {}

void GroundPass::make_shadow(const Ground& ground, const Aabb& box_W,
                             const std::function<void(const gl::Program&)>& draw_casters) {
  if (!shadow_.begin(ground.X_WP, box_W, 0)) return;
  const dvec3 up = ground.X_WP.rotate({0, 0, 1});
  caster_.set("plane", glm::vec4(glm::vec3(up), -glm::dot(up, ground.X_WP.p)));
  caster_.set("shadow_height", static_cast<float>(kGroundShadowHeight * shadow_.casters().diagonal()));
  gl::apply({.depth = GL_ALWAYS, .depth_write = false, .blend = true});
  glBlendEquation(GL_MAX);  // keeps the lowest caster above each point
  caster_.use();
  draw_casters(caster_);
  shadow_.blur();
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
  if (shadow_.box().z <= 0) return;
  shade_.set("world_from_ground", matrix(ground.X_WP));
  shade_.set("box", shadow_.box());
  shade_.set("toward_eye", kShadeTowardEye);
  shade_.set("strength", look.shadow);
  shade_.use();
  gl::apply({.depth_write = false, .blend = true});
  shadow_.bind(0);
  empty_.bind();
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

namespace {

/// Makes `picture` of the given size. Returns true if it had to be created.
bool fit(std::optional<gl::Framebuffer>& picture, int width, int height) {
  if (picture && picture->width() == width && picture->height() == height) return false;
  picture.reset();
  picture.emplace(width, height);
  return true;
}

void clear_depth() {
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
}

}  // namespace

void Backdrop::fill_background(const gl::Framebuffer& target, const GroundPass& pass, const Look& look) {
  if (fit(background_, target.width(), target.height()) || background_look_ != &look) {
    background_->bind();
    clear_depth();
    pass.draw_background(look);
    background_look_ = &look;
  }
  target.copy_color(*background_);
  target.bind();
}

void Backdrop::fill(const gl::Framebuffer& target, const GroundPass& pass, const Ground& ground, const Camera& camera,
                    const Look& look, bool grid, double scale, SegmentPass& segments) {
  const Key key{ground.X_WP.p, ground.X_WP.q, camera, &look, grid, scale, target.width(), target.height()};
  const bool rests = key == last_;
  last_ = key;
  if (!rests) {  // while the camera moves, an image of the grid would be used only once
    fill_background(target, pass, look);
    pass.draw(ground, camera, look, grid, segments);
    return;
  }
  if (fit(picture_, key.width, key.height) || !(key == key_)) {
    fill_background(*picture_, pass, look);
    clear_depth();
    pass.draw(ground, camera, look, grid, segments);
    key_ = key;
    target.bind();
  }
  target.copy_color(*picture_);
}

}  // namespace taxel::ui
