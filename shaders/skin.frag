#version 410 core
#include "frame.glsl"
#include "silicone.glsl"
in vec3 shade;
in vec3 normal_W;  // towards the eye
in vec3 p_W;
in float facing;
uniform vec2 front_alpha;  // opacity where the skin faces the eye, and at its rim
uniform float back_alpha;
out vec4 color;            // premultiplied

void main() {
  float rim = 1.0 - min(abs(facing), 1.0);
  rim *= rim * rim;  // Schlick's curve, softened: the skin thickens towards its outline
  float alpha = gl_FrontFacing ? mix(front_alpha.x, front_alpha.y, rim) : back_alpha;
  float sheen = gl_FrontFacing ? silicone_sheen(normalize(normal_W), normalize(eye.xyz - p_W), 1.0) : 0.0;
  color = vec4(shade * alpha, alpha);
  color = vec4(with_sheen(color.rgb, sheen), max(color.a, sheen));
}
