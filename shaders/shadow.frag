#version 410 core
// Darkness of the ground below a body: 1 if the body touches the ground, and less with increasing height.
in float height;
uniform float shadow_height;  // height at which a shadow is a third as dark [m]
out vec4 color;

void main() { color = vec4(exp(-max(height, 0.0) / shadow_height)); }
