// The faces that the clip plane cuts through bodies: closed by a hatched cap, with a line around, so that nobody looks
// into a hollow mesh.
#pragma once

#include <vector>

#include "ui/scene/passes/mesh_pass.h"

namespace taxel::ui {

/// Plain colours (sRGB) of a cut through a body of this albedo (linear).
struct CutColors {
  glm::vec3 fill{0}, line{0};
};
CutColors cut_colors(const glm::vec3& albedo, const Look& look);

class CutPass {
 public:
  explicit CutPass(const gl::ShaderReader& read);

  /// Caps and rims of bodies that are drawn already, into a framebuffer whose stencil is 0 and stays so. Caps hide by
  /// depth nothing that is drawn later: the contact inside stays whole. Outlines that are not closed have a rim alone.
  void draw(const std::vector<MeshItem>& items, float alpha, const ClipPlane& clip, const Camera& camera,
            const Look& look, SegmentPass& segments);
  void end_frame();  ///< drops cuts that this frame did not draw

 private:
  struct Cut {
    PlacedMesh body;
    ClipPlane clip;
    bool used = true;
    Segments rim;     // in the mesh's frame
    gl::Buffer fans;  // triangles in the plane: they wind around each point as often as the outlines do
    gl::VertexArray array;
  };
  /// Stays while neither the body nor the plane moves.
  Cut& cut_of(const MeshItem& item, const ClipPlane& clip);
  void draw_cap(const Cut& cut) const;

  gl::Program program_;
  std::vector<Cut> cuts_;
};

}  // namespace taxel::ui
