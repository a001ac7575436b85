// The passes that draw a user's scene with the materials, lights, floor and sky of its file.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "ui/gl/framebuffer.h"
#include "ui/gl/image_texture.h"
#include "ui/gl/program.h"
#include "ui/scene/passes/passes.h"
#include "ui/scene/passes/scene_lighting.h"

namespace taxel::ui {

/// Returns the properties of a material in shaders: roughness, reflectance of lights at normal incidence, metallic,
/// emission. The roughness is that of a highlight as wide as the one of MuJoCo's exponent, 128 times the shininess.
glm::vec4 finish_of(const SceneMaterial& material);
/// Returns scale and offset of the texture coordinates of a plane, as MuJoCo has them: `repeat` images in the plane, or
/// in 2 m if the material is uniform or the plane infinite. `half_size` is that of the plane [m], 0 if infinite. Zero
/// without a flat texture.
glm::vec4 repeat_of(const SceneMaterial& material, const dvec2& half_size);

/// The textures of a scene in graphics memory. A texture that is not used for a whole frame is dropped.
class TextureCache {
 public:
  /// Returns the image. `linear`: shaders read linear light.
  const gl::ImageTexture& get(const SceneTexturePtr& texture, bool linear);
  void end_frame();

 private:
  struct Entry {
    std::unique_ptr<gl::ImageTexture> image;
    bool used = true;
  };
  std::map<SceneTexturePtr, Entry> entries_;
};

/// A plane geom of the scene.
struct FloorItem {
  Pose X_WP;
  const SceneMaterial* material = nullptr;
  glm::vec4 base{0.5f, 0.5f, 0.5f, 1};  ///< albedo, linear; opacity
  dvec2 half_size{0};                   ///< [m]; 0 if infinite
};

/// Draws the bodies, planes and sky of a scene with a look.
class ScenePass {
 public:
  /// `key_texels` is the number of texels along each side of the map of shadows.
  ScenePass(const gl::ShaderReader& read, int key_texels);

  /// Sets the scene that the following calls draw. `list` and `look` must outlive them.
  void begin(const SceneInput& input, const Look& look);
  [[nodiscard]] const SceneLighting& lighting() const { return lighting_; }
  /// Computes the shadow of the first light.
  void make_shadow(const MeshPass& meshes, const MeshList& list, const Aabb& box_W);
  /// Draws the image of the bodies in the first reflecting plane, at half the resolution, if there is one. Leaves
  /// another framebuffer and frame bound.
  void make_reflection(const MeshList& list, const Camera& camera, const FrameUniforms& frame, int width, int height);
  /// Draws the solids of a list, but not the transparent parts of touched ones.
  void draw_solids(const MeshList& list, const Camera& camera, const Look& look, bool clipped);
  /// Draws the transparent parts of touched solids, which hide nothing that is drawn later.
  void draw_touched(const MeshList& list, const Camera& camera, const Look& look, bool clipped);
  /// Draws bodies that are partly transparent, over everything drawn so far.
  void draw_glass(std::vector<MeshItem> items, const Camera& camera, bool clipped);
  void draw_floors(const Camera& camera);
  /// Draws the sky of the file in a view of this height [pixels]. Returns false if the file has none.
  bool draw_sky(const Camera& camera, int height);
  void end_frame() { textures_.end_frame(); }

 private:
  void draw_floor(const FloorItem& floor, const Camera& camera, bool mirrors);
  void use_lights(const gl::Program& program) const;
  /// Sets program and lights for bodies. `inside` is the colour of their inside, transparent if it is lit as well.
  void begin_bodies(const gl::Program& program, bool clipped, const glm::vec4& inside,
                    const std::vector<glm::vec4>& contacts) const;
  void set_item(const gl::Program& program, const MeshItem& item);
  /// Draws the parts of solids that are opaque, or those that are not.
  void draw_parts(const MeshList& list, const Camera& camera, const glm::vec4& inside, bool clipped, bool opaque);

  gl::Program body_, touched_, textured_, touched_textured_, floor_, plain_floor_, sky_;
  KeyShadow shadow_;
  TextureCache textures_;
  SceneLighting lighting_;
  std::vector<FloorItem> floors_;
  const SceneLook* file_ = nullptr;
  int mirror_ = -1;  ///< index of the reflecting plane in floors_, or -1
  std::optional<gl::Framebuffer> mirrored_;
  gl::Buffer mirrored_frame_;
  gl::VertexArray empty_;
};

}  // namespace taxel::ui
