// Ambient occlusion of creases and corners.
#include "ui/scene/passes/passes.h"

#include "ui/gl/program.h"

namespace taxel::ui {

AmbientOcclusion::AmbientOcclusion(const gl::ShaderReader& read)
    : occlusion_(read, "screen.vert", "occlusion.frag"),
      blur_(read, "screen.vert", "occlusion_blur.frag"),
      apply_(read, "screen.vert", "occlude.frag") {
  for (const gl::Program* program : {&occlusion_, &apply_}) program->set("depth_map", 0);
  blur_.set("occlusion", 1);
  apply_.set("occlusion", 1);
}

void AmbientOcclusion::fit(const gl::Framebuffer& target) {
  if (depth_ && depth_->width() == target.width() && depth_->height() == target.height() &&
      depth_->stencil() == target.stencil())
    return;
  depth_.reset();
  depth_.emplace(target.width(), target.height(), 0, target.stencil());
  const int width = (target.width() + 1) / 2, height = (target.height() + 1) / 2;
  rough_.emplace(width, height);
  smooth_.emplace(width, height);
}

void AmbientOcclusion::draw(const gl::Framebuffer& target, double radius) {
  if (!(radius > 0)) return;
  fit(target);
  depth_->copy_depth(target);
  for (const gl::Program* program : {&occlusion_, &blur_, &apply_}) program->set("radius", static_cast<float>(radius));
  gl::apply({.depth = GL_ALWAYS, .depth_write = false});
  empty_.bind();
  depth_->depth_texture().bind(0);
  glBindFramebuffer(GL_FRAMEBUFFER, rough_->target.id());
  glViewport(0, 0, rough_->texture.width(), rough_->texture.height());
  occlusion_.use();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindFramebuffer(GL_FRAMEBUFFER, smooth_->target.id());
  rough_->texture.bind(1);
  blur_.use();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  target.bind();
  gl::apply({.depth = GL_ALWAYS, .depth_write = false, .blend = true});
  glBlendFunc(GL_ZERO,
              GL_SRC_COLOR);  // the colour times the unoccluded fraction; alpha is unchanged
  smooth_->texture.bind(1);
  apply_.use();
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace taxel::ui
