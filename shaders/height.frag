#version 450 core
// Height of a caster, 0 at the lowest, 1 where nothing is.
in float height;
uniform float range;  // [m]
out vec4 color;

void main() { color = vec4(clamp(height / range, 0.0, 1.0)); }
