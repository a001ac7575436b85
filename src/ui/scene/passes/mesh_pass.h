// The lit bodies of a scene: solid geoms, and the skin of the sensors, solid or transparent.
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
  glm::vec3 albedo{0.5f};                  ///< linear
  glm::vec4 outline{0};                    ///< sRGB
  bool sensor = false;                     ///< casts the sensors' shadow, so does not receive it
  const MeshIndex* transparent = nullptr;  ///< the skin itself where it is; null: solid
  bool casts = true;                       ///< shadows at all
  bool selected = false;                   ///< its outline is bolder
};

/// What decides where a body is, for what stays while it rests.
struct PlacedMesh {
  TriMeshPtr mesh;
  Pose X_WM;
  bool operator==(const PlacedMesh& other) const {
    return mesh == other.mesh && X_WM.p == other.X_WM.p && X_WM.q == other.X_WM.q;
  }
};

struct MeshList {
  std::vector<MeshItem> solids, skins;  ///< skins only while they are transparent
};

/// All meshes of a picture; a sensor's geom is drawn from its model. Planes are the ground's.
MeshList mesh_list(const SceneInput& input, const Look& look, MeshCache& cache);
/// Which of them cast shadows, and where.
std::vector<PlacedMesh> casters_of(const MeshList& list);
/// Of these, the sensors alone.
MeshList sensors_of(const SceneInput& input, MeshCache& cache);

class MeshPass {
 public:
  /// `key_texels`: along each side of the key light's map.
  MeshPass(const gl::ShaderReader& read, int key_texels);
  /// `hidden`: the side of closed bodies that others of their faces hide (GL_FRONT, GL_BACK).
  void draw_casters(const gl::Program& program, const MeshList& list, GLenum hidden) const;
  /// Computes how much of the sky the sensors, within `box_W`, hide from the other bodies.
  void make_shadow(const MeshList& sensors, const Aabb& box_W);
  /// What all of them, within `box_W`, take away of the key light, finest around `sensors_W`.
  void make_key_shadow(const MeshList& list, const Aabb& box_W, const Aabb& sensors_W, const Look& look);
  // `clipped`: cut by the frame's plane; then the inside of solids that no cap closes is seen in one plain colour.
  void draw_solids(const MeshList& list, const Camera& camera, const Look& look, bool clipped) const;
  void draw_skins(const MeshList& list, const Camera& camera, const Look& look, bool clipped) const;
  /// Creases and silhouettes.
  void draw_outlines(const std::vector<MeshItem>& items, const Camera& camera, SegmentPass& segments,
                     bool clipped) const;
  void draw_wires(const MeshList& list, const Look& look, SegmentPass& segments, bool clipped) const;

 private:
  gl::Program solid_, skin_, caster_;
  TopView shadow_;
  KeyShadow key_shadow_;
};

}  // namespace taxel::ui
