// The passes that draw the environment and the lit bodies of the 3-D view, one source each, and the shared uniforms of
// the frame and shadows.
#pragma once

#include <glm/glm.hpp>

#include <functional>
#include <optional>
#include <vector>

#include "ui/gl/framebuffer.h"
#include "ui/gl/objects.h"
#include "ui/gl/program.h"
#include "ui/scene/camera.h"
#include "ui/scene/paint/gpu_mesh.h"
#include "ui/scene/paint/mark_pass.h"
#include "ui/scene/passes/look.h"
#include "ui/scene/scene_parts.h"

namespace taxel::ui {

/// Camera, size and lights, which all shaders of one frame share, with the layout of `Frame` in shaders/frame.glsl
/// (std140).
struct FrameUniforms {
  glm::mat4 view_from_world{1};
  glm::mat4 clip_from_view{1};
  glm::vec4 eye{0};
  glm::vec4 viewport{1};
  glm::vec4 key_light{0, 0, 1, 0};
  glm::vec4 sky_light{0};
  glm::vec4 ground_light{0};
  glm::vec4 clip_plane{0, 0, 0, 1};
};

/// Returns the uniforms of a perspective view. `scale` multiplies widths and diameters of marks.
FrameUniforms perspective_frame(const Camera& camera, const Look& look, int width, int height, double scale,
                                const std::optional<ClipPlane>& clip);
/// Returns the uniforms for flat drawings on the screen: coordinates are pixels of marks in a view of width x height
/// pixels, with y up and z from -1 to 1.
FrameUniforms pixel_frame(int width, int height, double scale);

/// Sends the uniforms and makes all following draws use them.
void bind_frame(gl::Buffer& buffer, const FrameUniforms& uniforms);

/// Returns a pose as a matrix for the shaders.
glm::mat4 matrix(const Pose& pose);

/// A small blurred image of bodies seen from above, used for soft shadows.
class TopView {
 public:
  explicit TopView(const gl::ShaderReader& read);

  /// Clears the image to `empty`, and sets up the view along -z of P, with a margin around `box_W`, for the following
  /// draws. Returns false if there is nothing to draw. The caller must bind its target and frame again.
  bool begin(const Pose& X_WP, const Aabb& box_W, float empty);
  void blur() const;

  void bind(GLuint unit) const { map_.bind(unit); }
  [[nodiscard]] const glm::vec4& box() const { return box_; }     ///< lower corner and size in P [m]; size 0 if empty
  [[nodiscard]] const Aabb& casters() const { return casters_; }  ///< box of the casters in P [m]

 private:
  void blur(const gl::Texture& from, GLuint to, const glm::vec2& step) const;

  gl::Program blur_;
  gl::Texture map_, blurred_;
  gl::FramebufferHandle map_target_, blurred_target_;
  gl::Buffer frame_;
  gl::VertexArray empty_;
  glm::vec4 box_{0};
  Aabb casters_;
};

/// Returns the bounding box, in an inner frame, of a box.
Aabb box_in(const Pose& X_PW, const Aabb& box_W);

/// Shadow of the key light: a depth map seen from the light, rebuilt only if bodies move.
class KeyShadow {
 public:
  /// The map has `texels` texels along each side.
  KeyShadow(const gl::ShaderReader& read, int texels);

  /// Draws the map of the bodies that `draw_casters(program)` draws with the given program (uniform world_from_mesh).
  /// `shown_W` is the box that the map covers, `casters_W` bounds all casters, and `light` is the direction towards the
  /// light. Leaves another framebuffer and frame bound.
  void make(const Aabb& shown_W, const Aabb& casters_W, const glm::vec3& light,
            const std::function<void(const gl::Program&)>& draw_casters);
  /// Binds the map for a program that includes key_shadow.glsl.
  void use(const gl::Program& program, GLuint unit) const;

 private:
  gl::Program depth_;
  gl::Texture map_;
  gl::FramebufferHandle target_;
  gl::Buffer frame_;
  glm::mat4 map_from_world_{1};
  float offset_ = 0;  // distance above a surface at which its light is looked up [m]; 0 if there are no casters
};

/// The ground, which is the plane z = 0 of `X_WP`. A plane geom of the scene is filled and hides bodies below it;
/// without one, only the grid is drawn.
struct Ground {
  Pose X_WP;
  bool filled = false;
};

/// Background, grid, and the soft shadow on the ground.
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

/// Background and grid, cached as images for software renderers: the background always, and both while the camera does
/// not move.
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

struct MeshItem {
  GpuMesh* mesh = nullptr;
  Pose X_WM;
  glm::vec3 albedo{0.5f};                   ///< base colour, linear
  glm::vec4 outline{0};                     ///< colour of the outline, sRGB
  bool sensor = false;                      ///< a sensor, which casts the sensors' shadow and does not receive it
  const MeshIndex* transparent = nullptr;   ///< skin that is drawn transparent; null for a solid body
  bool casts = true;                        ///< casts shadows
  bool selected = false;                    ///< its outline is bolder
  bool touched = false;                     ///< an object that is transparent next to a contact
  float alpha = 1;                          ///< opacity of a body of a scene with a look
  const SceneMaterial* material = nullptr;  ///< material of a geom, or null; valid as long as the frame
};

/// Returns true if the near plane may cut the item open.
bool may_be_within(const MeshItem& item, const Camera& camera);

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
  std::vector<MeshItem> glass;          ///< partly transparent geoms of a scene with a look
  std::vector<glm::vec4> contacts;      ///< contact_spheres() of the frame
};

/// Largest number of contacts next to which surfaces change, as in shaders/near_contact.glsl.
inline constexpr std::size_t kMaxContacts = 8;
/// Sends the contacts of a frame to a program that includes near_contact.glsl.
void use_contacts(const gl::Program& program, const std::vector<glm::vec4>& contacts);

/// Returns all meshes of a frame. The geom of a sensor has the mesh of its model. Planes are left out, because the
/// ground draws them.
MeshList mesh_list(const SceneInput& input, const Look& look, MeshCache& cache);
/// Returns the meshes that cast shadows, with their poses.
std::vector<PlacedMesh> casters_of(const MeshList& list);
/// Returns only the meshes of the sensors.
MeshList sensors_of(const SceneInput& input, MeshCache& cache);

/// Draws solid geoms, and the skins of the sensors, solid or transparent.
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
  /// Draws solids, but not the transparent parts of touched ones. If `clipped` is true, solids are cut by the frame's
  /// plane, and the inside of a solid without a cap has one plain colour.
  void draw_solids(const MeshList& list, const Camera& camera, const Look& look, bool clipped) const;
  /// Draws the transparent parts of touched solids, which hide nothing that is drawn later.
  void draw_touched(const MeshList& list, const Camera& camera, const Look& look, bool clipped) const;
  void draw_skins(const MeshList& list, const Camera& camera, const Look& look, bool clipped) const;
  /// Draws creases and silhouettes.
  void draw_outlines(const std::vector<MeshItem>& items, const Camera& camera, SegmentPass& segments,
                     bool clipped) const;
  void draw_wires(const MeshList& list, const Look& look, SegmentPass& segments, bool clipped) const;

 private:
  void begin_solids(const gl::Program& program, const MeshList& list, const Look& look, bool clipped) const;
  void draw_solid(const gl::Program& program, const MeshItem& item, const Camera& camera, const Look& look,
                  bool clipped) const;

  gl::Program solid_, touched_, silicone_, skin_, caster_;
  TopView shadow_;
  KeyShadow key_shadow_;
};

/// Plain colours (sRGB) of a cut through a body of this albedo (linear).
struct CutColors {
  glm::vec3 fill{0}, line{0};
};
CutColors cut_colors(const glm::vec3& albedo, const Look& look);

/// Draws the cut of the clip plane through bodies: a hatched cap with a line around it, so that a mesh does not look
/// hollow. A cut is kept until its body or the plane moves.
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

/// Ambient occlusion: creases and corners of the bodies drawn so far get less of the ambient light.
class AmbientOcclusion {
 public:
  explicit AmbientOcclusion(const gl::ShaderReader& read);

  /// Darkens the bodies in `target` (bound), at half the resolution. The background does not change. The frame's
  /// perspective must be bound. `radius` is the distance [m] up to which bodies occlude each other.
  void draw(const gl::Framebuffer& target, double radius);

 private:
  /// A colour layer in a format that stores a distance.
  struct Layer {
    Layer(int width, int height) : texture(GL_RG32F, width, height) {
      gl::attach(target.id(), GL_COLOR_ATTACHMENT0, texture);
    }
    gl::Texture texture;
    gl::FramebufferHandle target;
  };
  void fit(const gl::Framebuffer& target);

  gl::Program occlusion_, blur_, apply_;
  gl::VertexArray empty_;
  std::optional<gl::Framebuffer> depth_;  // copy of the depth, because a bound buffer may not be read
  std::optional<Layer> rough_, smooth_;
};

}  // namespace taxel::ui
