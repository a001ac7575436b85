// The light of a user's scene: the lights of its file, its sky, and the ambient light of an analytic sky, as linear
// values for shaders.
#pragma once

#include <glm/glm.hpp>

#include <vector>

#include "core/run/scene_look.h"
#include "ui/scene/passes/look.h"
#include "ui/scene/scene_input.h"

namespace taxel::ui {

inline constexpr float kAtEye = 2;  ///< LitSource::at.w of the headlight

/// One light. Colours are linear; a surface of albedo 1 that faces the light has the colour `diffuse`.
struct LitSource {
  glm::vec4 at{0, 0, 1, 0};     ///< xyz: direction towards the light if w is 0, position [m] if w is 1; kAtEye
  glm::vec4 axis{0, 0, 0, -2};  ///< direction of a spot, and the cosine of its cutoff; -2 for other lights
  float exponent = 0;           ///< exponent of a spot's decrease towards its edge
  glm::vec3 diffuse{0}, specular{0};
};

struct SceneLighting {
  /// At most kMaxLights. The first `key_count` shine from about the same direction, and the first one casts the shadow
  /// of all of them. The last one is the headlight, if there is one.
  std::vector<LitSource> sources;
  int key_count = 1;                    ///< 0 if no light of the file casts a shadow
  glm::vec3 sky{0}, ground{0};          ///< irradiance / pi from above and from below, linear
  glm::vec3 sky_high{0}, sky_low{0};    ///< colours of the sky above and at the horizon, sRGB
  glm::vec3 shadow_direction{0, 0, 1};  ///< unit, towards the light that casts the shadow
};

inline constexpr std::size_t kMaxLights = 4;  ///< equals kMaxLights in shaders/light.glsl

/// Returns the light of a scene that has a look. Lights whose sum would wash out white bodies are dimmed together. A
/// file without lights gets the key light of `look`. `floor` is the mean colour of the floor, linear.
SceneLighting scene_lighting(const SceneInput& input, const Look& look, const glm::vec3& floor);

/// Returns the look with the key light and the ambient light of the scene, for transparent skins.
Look lit_look(const Look& look, const SceneLighting& lighting);

/// Returns the mean colour of the rows from `first` up to `last` of an image, sRGB 0 to 1. Reads at most a few thousand
/// pixels.
glm::vec3 mean_color(const SceneTexture& image, int first, int last);

}  // namespace taxel::ui
