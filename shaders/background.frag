#version 450 core
#include "color.glsl"

in vec2 uv;
uniform vec3 top;     // sRGB
uniform vec3 bottom;
out vec4 color;

void main() {
  float t = smoothstep(0.0, 1.0, uv.y);
  color = vec4(mix(bottom, top, t) + dither(gl_FragCoord.xy), 1.0);
}
