// A matte body with shadows of the key light. It is darker below a sensor, because a body close above it takes away the
// light of the sky, and next to a contact. Needs near_contact.glsl.
#include "key_shadow.glsl"

in vec3 shade;
in vec3 shade_unlit;
in vec3 key_at;
in vec3 p_W;
in float upward;            // cosine between normal and the vertical
uniform sampler2D heights;  // lowest point of the sensors, seen from above
uniform vec4 heights_box;   // low corner and 1 / size [m], [1/m]
uniform vec3 heights_scale; // height of 0 [m], range of 0..1 [m], 1 / (height at which it is a third as dark) [1/m]
uniform float strength;
uniform vec4 inside;        // colour of the inside of bodies that a plane cuts open, sRGB; alpha 0 without a plane

// Returns the fraction of the key light that reaches the fragment.
float key_light_here() {
  bool matters = shade.g - shade_unlit.g > 0.002;  // otherwise the surface faces away from the light
  return key_light_at(key_at, matters);
}

// Returns the colour of the surface without highlights, sRGB.
vec3 matte_color(float lit) {
  vec2 uv = (p_W.xy - heights_box.xy) * heights_box.zw;
  float above = heights_scale.x + heights_scale.y * textureLod(heights, uv, 0.0).r;
  float dark = exp(-max(above - p_W.z, 0.0) * heights_scale.z) * max(upward, 0.0);
  return mix(shade_unlit, shade, lit) * (1.0 - strength * dark) * light_near_contact(p_W);
}
