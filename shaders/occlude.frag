#version 410 core
// Darkens a pixel by the mean of those of the four nearest pixels of half the resolution that have about the same
// distance.
#include "frame.glsl"
#include "occlusion.glsl"

uniform sampler2D occlusion;
uniform float radius;  // [m]
out vec4 color;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy), last = textureSize(occlusion, 0) - 1;
  color = vec4(1.0);
  float depth = depth_of(at);
  if (depth >= 1.0) return;
  float z = distance_of(depth);
  vec2 t = 0.5 * vec2(at), f = fract(t);
  float sum = 0.0, weights = 0.0;
  for (int j = 0; j < 2; ++j) {
    for (int i = 0; i < 2; ++i) {
      vec2 there = texelFetch(occlusion, min(ivec2(t) + ivec2(i, j), last), 0).rg;
      float w = (i == 0 ? 1.0 - f.x : f.x) * (j == 0 ? 1.0 - f.y : f.y);
      w *= max(0.0, 1.0 - 4.0 * abs(there.g - z) / radius) + 1e-4;
      sum += w * there.r;
      weights += w;
    }
  }
  color.rgb = vec3(sum / weights);
}
