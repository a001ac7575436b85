#version 450 core
// How dark the ground is below this point: 1 on it, less the higher it stands.
in float height;
uniform float shadow_height;  // height at which a shadow is a third as dark [m]
out vec4 color;

void main() { color = vec4(exp(-max(height, 0.0) / shadow_height)); }
