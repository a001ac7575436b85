#version 410 core
// One colour for each triangle, exact and without light.
flat in vec4 tint;
uniform float dim;
out vec4 color;  // premultiplied

void main() { color = vec4(tint.rgb, 1.0) * (tint.a * dim); }
