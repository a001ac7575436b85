#include "ui/scene/draw/backdrop.h"

namespace taxel::ui {

void Backdrop::fill(const gl::Framebuffer& target, const GroundPass& pass, const Ground& ground, const Camera& camera,
                    const Look& look, bool grid, SegmentPass& segments) {
  const Key key{ground.X_WP.p, ground.X_WP.q, camera, &look, grid, target.width(), target.height()};
  if (!picture_ || !(key == key_)) {
    if (!picture_ || key.width != key_.width || key.height != key_.height) {
      picture_.reset();
      picture_.emplace(key.width, key.height);
    }
    picture_->bind();
    glClear(GL_DEPTH_BUFFER_BIT);
    pass.draw_background(look);
    pass.draw(ground, camera, look, grid, segments);
    key_ = key;
    target.bind();
  }
  target.copy_color(*picture_);
}

}  // namespace taxel::ui
