// Environment of the scene: background, grid, and the soft shadow on the ground.
#pragma once

#include <functional>

#include "ui/scene/paint/segments.h"
#include "ui/scene/passes/look.h"
#include "ui/scene/passes/top_view.h"
#include "ui/scene/pick/camera.h"

namespace taxel::ui {

/// The ground, which is the plane z = 0 of `X_WP`. A plane geom of the scene is filled and hides bodies below it;
/// without one, only the grid is drawn.
struct Ground {
  Pose X_WP;
  bool filled = false;
};

class GroundPass {
 public:
  explicit GroundPass(const gl::ShaderReader& read);

  /// Draws the shadow of whatever `draw_casters(program)` draws with the given program (uniform world_from_mesh) into
  /// the shadow texture. `box_W` bounds the casters. Leaves another framebuffer and frame bound.
  void make_shadow(const Ground& ground, const Aabb& box_W,
                   const std::function<void(const gl::Program&)>& draw_casters);
  void draw_background(const Look& look) const;
  void draw(const Ground& ground, const Camera& camera, const Look& look, bool grid, SegmentPass& segments) const;
  void draw_shadow(const Ground& ground, const Look& look) const;

 private:
  gl::Program background_, ground_, caster_, shade_;
  TopView shadow_;
  gl::VertexArray empty_;
};

/// Returns the spacing [m] of the finer grid lines: the power of ten below a tenth of the distance.
double grid_cell(double camera_distance);

}  // namespace taxel::ui
