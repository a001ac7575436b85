#version 410 core
in vec2 uv;
uniform sampler2D shadow;
uniform float strength;
out vec4 color;  // premultiplied: black

void main() { color = vec4(0.0, 0.0, 0.0, strength * textureLod(shadow, uv, 0.0).r); }
