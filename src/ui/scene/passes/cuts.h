// Draws the cut of the clip plane through bodies: a hatched cap with a line around it, so that a mesh does not look
// hollow.
#pragma once

#include <vector>

#include "ui/scene/passes/mesh_pass.h"

namespace taxel::ui {

/// Plain colours (sRGB) of a cut through a body of this albedo (linear).
struct CutColors {
  glm::vec3 fill{0}, line{0};
};
CutColors cut_colors(const glm::vec3& albedo, const Look& look);

/// Computes and draws cuts. A cut is kept until its body or the plane moves.
class CutPass {
 public:
  explicit CutPass(const gl::ShaderReader& read);

  /// Draws caps and rims of bodies that are already drawn, into a framebuffer whose stencil is 0 before and after. Caps
  /// do not write depth, so the contact inside remains completely visible. An outline that is not closed has only a
  /// rim.
  void draw(const std::vector<MeshItem>& items, float alpha, const ClipPlane& clip, const Camera& camera,
            const Look& look, SegmentPass& segments);
  void end_frame();  ///< drops cuts that this frame did not draw

 private:
  struct Cut {
    PlacedMesh body;
    ClipPlane clip;
    bool used = true;
    Segments rim;     // outline of the cut, in the frame of the mesh
    gl::Buffer fans;  // triangles in the plane, with the winding numbers of the outlines
    gl::VertexArray array;
  };
  /// Returns the cut of a body. It is computed again if the body or the plane has moved.
  Cut& cut_of(const MeshItem& item, const ClipPlane& clip);
  void draw_cap(const Cut& cut) const;

  gl::Program program_;
  std::vector<Cut> cuts_;
};

}  // namespace taxel::ui
