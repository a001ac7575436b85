// Draws the lit bodies of a scene: solid geoms, and the skins of the sensors, solid or transparent.
#pragma once

#include "ui/scene/paint/gpu_mesh.h"
#include "ui/scene/paint/segments.h"
#include "ui/scene/passes/frame_uniforms.h"
#include "ui/scene/passes/key_shadow.h"
#include "ui/scene/passes/look.h"
#include "ui/scene/passes/top_view.h"
#include "ui/scene/sensor_view.h"

namespace taxel::ui {

struct MeshItem {
  GpuMesh* mesh = nullptr;
  Pose X_WM;
  glm::vec3 albedo{0.5f};                  ///< base colour, linear
  glm::vec4 outline{0};                    ///< colour of the outline, sRGB
  bool sensor = false;                     ///< a sensor, which casts the sensors' shadow and does not receive it
  const MeshIndex* transparent = nullptr;  ///< skin that is drawn transparent; null for a solid body
  bool casts = true;                       ///< casts shadows
  bool selected = false;                   ///< its outline is bolder
};

/// A body and its pose. If both are unchanged, cached drawings of the body remain valid.
struct PlacedMesh {
  TriMeshPtr mesh;
  Pose X_WM;
  bool operator==(const PlacedMesh& other) const {
    return mesh == other.mesh && X_WM.p == other.X_WM.p && X_WM.q == other.X_WM.q;
  }
};

struct MeshList {
  std::vector<MeshItem> solids, skins;  ///< `skins` only has transparent skins
};

/// Returns all meshes of a frame. The geom of a sensor has the mesh of its model. Planes are left out, because the
/// ground draws them.
MeshList mesh_list(const SceneInput& input, const Look& look, MeshCache& cache);
/// Returns the meshes that cast shadows, with their poses.
std::vector<PlacedMesh> casters_of(const MeshList& list);
/// Returns only the meshes of the sensors.
MeshList sensors_of(const SceneInput& input, MeshCache& cache);

class MeshPass {
 public:
  /// `key_texels` is the number of texels along each side of the key light's map.
  MeshPass(const gl::ShaderReader& read, int key_texels);
  /// Draws the casters. `hidden` is the side of closed bodies that need not be drawn (GL_FRONT, GL_BACK).
  void draw_casters(const gl::Program& program, const MeshList& list, GLenum hidden) const;
  /// Computes how much of the sky the sensors, within `box_W`, hide from the other bodies.
  void make_shadow(const MeshList& sensors, const Aabb& box_W);
  /// Computes the shadow of all meshes within `box_W` from the key light, with the finest resolution around
  /// `sensors_W`.
  void make_key_shadow(const MeshList& list, const Aabb& box_W, const Aabb& sensors_W, const Look& look);
  // If `clipped` is true, solids are cut by the frame's plane, and the inside of a solid without a cap has one plain
  // colour.
  void draw_solids(const MeshList& list, const Camera& camera, const Look& look, bool clipped) const;
  void draw_skins(const MeshList& list, const Camera& camera, const Look& look, bool clipped) const;
  /// Draws creases and silhouettes.
  void draw_outlines(const std::vector<MeshItem>& items, const Camera& camera, SegmentPass& segments,
                     bool clipped) const;
  void draw_wires(const MeshList& list, const Look& look, SegmentPass& segments, bool clipped) const;

 private:
  gl::Program solid_, skin_, caster_;
  TopView shadow_;
  KeyShadow key_shadow_;
};

}  // namespace taxel::ui
