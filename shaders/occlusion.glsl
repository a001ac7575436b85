// Points of the present frame, from a copy of its depth.
uniform sampler2D depth_map;

float depth_of(ivec2 pixel) { return texelFetch(depth_map, clamp(pixel, ivec2(0), ivec2(viewport.xy) - 1), 0).r; }

// Returns the distance in front of the eye [m] for a depth from 0 to 1.
float distance_of(float depth) {
  float ndc = 2.0 * depth - 1.0;
  if (clip_from_view[2][3] == 0.0) return (clip_from_view[3][2] - ndc) / clip_from_view[2][2];  // no perspective
  return clip_from_view[3][2] / (ndc + clip_from_view[2][2]);
}

// Returns the factor of positions on the screen for points at this distance.
float spread_at(float z) { return clip_from_view[2][3] == 0.0 ? 1.0 : z; }

// Returns the point at a pixel, in the camera's frame [m].
vec3 point_at(ivec2 pixel) {
  float z = distance_of(depth_of(pixel));
  vec2 ndc = 2.0 * (vec2(pixel) + 0.5) * viewport.zw - 1.0;
  return vec3(ndc * spread_at(z) / vec2(clip_from_view[0][0], clip_from_view[1][1]), -z);
}
