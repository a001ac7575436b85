// The fraction of the key light that reaches a point, from a depth map seen from the light.
uniform sampler2DShadow key_map;  // 1 (lit) beyond its edge
uniform mat4 map_from_world;      // texture coordinates and depth
uniform float key_offset;         // distance above a surface at which the map is looked up [m]; 0 without shadows

// Returns the place in the map of a point of a surface with normal n, slightly above the surface, so that the surface
// does not shade itself.
vec3 key_map_point(vec3 p_W, vec3 n) { return (map_from_world * vec4(p_W + key_offset * n, 1.0)).xyz; }

// Percentage closer filter (Reeves, Salesin, Cook 1987): the mean of 5 x 5 comparisons, interpolated smoothly between
// texels. Each gather reads four of the 6 x 6 texels. The corners show whether there is an edge. Loops are used instead
// of branches, because a software renderer can only skip loops.
float key_light_at(vec3 at, bool matters) {
  if (key_offset <= 0.0) matters = false;
  float size = float(textureSize(key_map, 0).x);
  vec2 t = at.xy * size - 0.5, first = floor(t), f = t - first;
  float sum = 0.0, lit_corners = matters ? 0.0 : 16.0;
  int count = matters ? 4 : 0;
  for (int k = 0; k < count; ++k) {
    ivec2 block = k < 4 ? 2 * ivec2(k & 1, k >> 1) - 1 : ivec2(k == 5 ? -1 : k == 6 ? 1 : 0, k == 7 ? -1 : k == 8 ? 1 : 0);
    vec4 lit = textureGather(key_map, (first + 2.0 * vec2(block) + 1.0) / size, at.z);
    vec2 wx = vec2(block.x < 0 ? 1.0 - f.x : 1.0, block.x > 0 ? f.x : 1.0);
    vec2 wy = vec2(block.y < 0 ? 1.0 - f.y : 1.0, block.y > 0 ? f.y : 1.0);
    sum += wy.x * dot(wx, lit.wz) + wy.y * dot(wx, lit.xy);
    if (k < 4) lit_corners += lit.x + lit.y + lit.z + lit.w;
    if (k == 3 && lit_corners > 0.0 && lit_corners < 16.0) count = 9;
  }
  return count == 9 ? sum / 25.0 : lit_corners / 16.0;
}
