#include "ui/scene/passes/backdrop.h"

namespace taxel::ui {

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
