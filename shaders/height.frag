#version 410 core
// Height of a caster: 0 at the lowest point, and 1 without a caster.
in float height;
uniform float range;  // [m]
out vec4 color;

void main() { color = vec4(clamp(height / range, 0.0, 1.0)); }
