#version 410 core
// One direction of a Gaussian blur of 9 texels, by 5 reads between texels.
in vec2 uv;
uniform sampler2D source;
uniform vec2 texel;  // distance of two texels, in texture coordinates
out vec4 color;

float at(vec2 p) { return textureLod(source, p, 0.0).r; }

void main() {
  vec2 near = 1.3846154 * texel, far = 3.2307692 * texel;
  float sum = 0.2270270 * at(uv);
  sum += 0.3162162 * (at(uv + near) + at(uv - near));
  sum += 0.0702703 * (at(uv + far) + at(uv - far));
  color = vec4(sum);
}
