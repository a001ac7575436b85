// Background and grid, which stay the same while the camera rests: kept as a picture where drawing is dear.
#pragma once

#include <optional>

#include "ui/scene/draw/ground.h"

namespace taxel::ui {

class Backdrop {
 public:
  /// Fills the colour of `target` (bound, of a single sample per pixel) with background and grid. Draws them only when
  /// something about them changed; else copies, which costs a software renderer a tenth.
  void fill(const gl::Framebuffer& target, const GroundPass& pass, const Ground& ground, const Camera& camera,
            const Look& look, bool grid, SegmentPass& segments);

 private:
  struct Key {
    dvec3 position{0};
    dquat orientation{1, 0, 0, 0};
    Camera camera;
    const Look* look = nullptr;
    bool grid = false;
    int width = 0, height = 0;
    bool operator==(const Key&) const = default;
  };
  std::optional<gl::Framebuffer> picture_;
  Key key_;
};

}  // namespace taxel::ui
