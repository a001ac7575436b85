#version 450 core
#include "frame.glsl"
#include "color.glsl"
#include "light.glsl"

in vec3 p_W;
in vec3 n_W;
uniform vec3 albedo;      // linear
uniform vec2 front_alpha; // facing the eye, at the rim
uniform float back_alpha;
out vec4 color;           // premultiplied

void main() {
  vec3 v = normalize(eye.xyz - p_W);
  vec3 n = normalize(gl_FrontFacing ? n_W : -n_W);
  float facing = clamp(dot(n, v), 0.0, 1.0);
  float rim = 1.0 - facing;
  rim *= rim * rim;  // Schlick's curve, softened: the skin thickens towards its outline
  float alpha = gl_FrontFacing ? mix(front_alpha.x, front_alpha.y, rim) : back_alpha;
  color = vec4(display(albedo * irradiance(n, v)) * alpha, alpha);
}
