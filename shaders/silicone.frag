#version 410 core
// An opaque skin.
#include "frame.glsl"
#include "near_contact.glsl"
#include "solid.glsl"
#include "silicone.glsl"
in vec3 normal_W;  // towards the eye
out vec4 color;

void main() {
  float lit = key_light_here();
  float sheen = silicone_sheen(normalize(normal_W), normalize(eye.xyz - p_W), lit) * light_near_contact(p_W);
  color = vec4(with_sheen(matte_color(lit), sheen), 1.0);
  if (!gl_FrontFacing && inside.a > 0.0) color = inside;
}
