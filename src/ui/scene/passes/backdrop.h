// Background and grid, cached as images for software renderers: the background always, and both while the camera does
// not move.
#pragma once

#include <optional>

#include "ui/scene/passes/ground.h"

namespace taxel::ui {

class Backdrop {
 public:
  /// Fills the colour of `target` (bound, with a single sample per pixel) with background and grid. Draws only changed
  /// parts and copies the others, which costs a software renderer a tenth of drawing.
  void fill(const gl::Framebuffer& target, const GroundPass& pass, const Ground& ground, const Camera& camera,
            const Look& look, bool grid, double scale, SegmentPass& segments);

 private:
  struct Key {
    dvec3 position{0};
    dquat orientation{1, 0, 0, 0};
    Camera camera;
    const Look* look = nullptr;
    bool grid = false;
    double scale = 1;
    int width = 0, height = 0;
    bool operator==(const Key&) const = default;
  };
  void fill_background(const gl::Framebuffer& target, const GroundPass& pass, const Look& look);

  std::optional<gl::Framebuffer> background_, picture_;
  const Look* background_look_ = nullptr;
  Key key_, last_;  ///< keys of picture_ and of the last call
};

}  // namespace taxel::ui
