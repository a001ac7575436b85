// Points of the picture that is being drawn, from a copy of its depth.
uniform sampler2D depth_map;

float depth_of(ivec2 pixel) { return texelFetch(depth_map, clamp(pixel, ivec2(0), ivec2(viewport.xy) - 1), 0).r; }

// Distance before the eye of a depth from 0 to 1. [m]
float distance_of(float depth) { return clip_from_view[3][2] / (2.0 * depth - 1.0 + clip_from_view[2][2]); }

// In the camera's frame. [m]
vec3 point_at(ivec2 pixel) {
  float z = distance_of(depth_of(pixel));
  vec2 ndc = 2.0 * (vec2(pixel) + 0.5) * viewport.zw - 1.0;
  return vec3(ndc * z / vec2(clip_from_view[0][0], clip_from_view[1][1]), -z);
}
