#version 450 core
// How dark the ground is below this point: 1 on it, less the higher it stands.
in vec3 p_W;
in vec3 n_W;
uniform vec4 ground;          // plane: dot(ground.xyz, p) + ground.w = height [m]
uniform float shadow_height;  // height at which a shadow is a third as dark [m]
out vec4 color;

void main() {
  float h = max(dot(ground.xyz, p_W) + ground.w, 0.0);
  color = vec4(exp(-h / shadow_height));
}
