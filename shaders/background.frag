#version 410 core
#include "color.glsl"

in vec2 uv;
uniform vec3 top;     // sRGB
uniform vec3 bottom;
out vec4 color;

void main() { color = vec4(mix(bottom, top, uv.y) + dither(gl_FragCoord.xy), 1.0); }
