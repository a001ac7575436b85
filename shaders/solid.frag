#version 450 core
#include "frame.glsl"
#include "color.glsl"
#include "light.glsl"

in vec3 p_W;
in vec3 n_W;
uniform vec3 albedo;  // linear
out vec4 color;

void main() {
  vec3 v = normalize(eye.xyz - p_W);
  vec3 n = normalize(gl_FrontFacing ? n_W : -n_W);
  color = vec4(display(albedo * irradiance(n, v)), 1.0);
}
