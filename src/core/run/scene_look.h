// The appearance of a user's scene: materials, textures, lights and sky of its file. Plain values, free of MuJoCo.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/math.h"

namespace taxel {

/// An image with 8 bits per channel, sRGB. A cube texture has its six square faces one below another.
struct SceneTexture {
  bool cube = false;
  int width = 0, height = 0;  ///< size [pixels]; the height of a cube is six times its width
  int channels = 3;           ///< 1 to 4
  std::vector<std::uint8_t> pixels;
};
using SceneTexturePtr = std::shared_ptr<const SceneTexture>;

/// Places in a texture: of each corner of each face of a mesh, in the order of its faces. The first row of the image is
/// at 0 of the second coordinate.
using TextureCoords = std::vector<glm::vec2>;
using TextureCoordsPtr = std::shared_ptr<const TextureCoords>;

/// A material as in MJCF. The defaults are MuJoCo's for a geom without a material.
struct SceneMaterial {
  float emission = 0, specular = 0.5f, shininess = 0.5f, reflectance = 0;
  float metallic = -1, roughness = -1;  ///< -1 if not set: `specular` and `shininess` decide
  SceneTexturePtr texture;              ///< texture of the surface, or null
  glm::vec2 repeat{1, 1};               ///< MJCF's texrepeat
  bool uniform = false;                 ///< MJCF's texuniform: `repeat` is per 2 m, not per geom
};
using SceneMaterialPtr = std::shared_ptr<const SceneMaterial>;

enum class LightKind { directional, spot, point };

/// A light of a body. Colours are MuJoCo's, on the scale of display values.
struct SceneLight {
  LightKind kind = LightKind::spot;
  int body = 0;  ///< index in SceneControls::bodies
  dvec3 p_B{0}, direction_B{0, 0, -1};
  dvec3 p_W{0}, direction_W{0, 0, -1};  ///< in the initial state, if the pose of the body is unknown
  glm::vec3 ambient{0}, diffuse{0}, specular{0};
  bool casts_shadow = true;
  float cutoff_deg = 45, exponent = 10;  ///< cone of a spot, and its decrease towards the edge
};

/// The light at the eye, on the scale of display values.
struct SceneHeadlight {
  glm::vec3 ambient{0.1f}, diffuse{0.4f}, specular{0.5f};
};

struct SceneLook {
  std::vector<SceneLight> lights;           ///< active lights, in model order
  std::optional<SceneHeadlight> headlight;  ///< empty if the file switches it off
  SceneTexturePtr sky;                      ///< cube texture of the skybox, or null
  glm::vec3 haze{1};                        ///< colour at the horizon, sRGB
  bool has_own_view = false;                ///< the file sets a direction, a centre or a size of the first view
};
using SceneLookPtr = std::shared_ptr<const SceneLook>;

}  // namespace taxel
