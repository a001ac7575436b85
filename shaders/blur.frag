#version 450 core
// One direction of a Gaussian blur of 9 texels, by 5 reads between texels.
in vec2 uv;
uniform sampler2D source;
uniform vec2 texel;  // one step, in texture coordinates
out vec4 color;

void main() {
  float sum = 0.2270270 * textureLod(source, uv, 0.0).r;
  sum += 0.3162162 * (textureLod(source, uv + 1.3846154 * texel, 0.0).r + textureLod(source, uv - 1.3846154 * texel, 0.0).r);
  sum += 0.0702703 * (textureLod(source, uv + 3.2307692 * texel, 0.0).r + textureLod(source, uv - 3.2307692 * texel, 0.0).r);
  color = vec4(sum);
}
