#version 410 core
// Mean over the block of 4 x 4 pixels within which occlusion.frag varies, of points with about the same distance.
uniform sampler2D occlusion;
uniform float radius;  // [m]
out vec4 color;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy), last = textureSize(occlusion, 0) - 1;
  vec2 here = texelFetch(occlusion, at, 0).rg;
  float sum = 0.0, weights = 0.0;
  for (int j = -2; j < 2; ++j) {
    for (int i = -2; i < 2; ++i) {
      vec2 there = texelFetch(occlusion, clamp(at + ivec2(i, j), ivec2(0), last), 0).rg;
      float w = max(0.0, 1.0 - abs(there.g - here.g) / radius) + 1e-4;
      sum += w * there.r;
      weights += w;
    }
  }
  color = vec4(sum / weights, here.g, 0.0, 1.0);
}
