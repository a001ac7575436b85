#version 410 core
// A plane of a user's scene, z = 0 of its frame: a rectangle of 32 x 32 cells, which are smaller towards `middle`, so
// that light and reflections, which are computed here, are smooth.
#include "frame.glsl"
#include "key_shadow.glsl"
#include "light.glsl"

uniform mat4 world_from_ground;
uniform vec4 box;     // middle and half size of the rectangle [m]
uniform vec2 middle;  // of the cells, from -1 to 1 in the rectangle
uniform vec4 fade;    // middle of an infinite plane [m], 1 / distance at which it ends [1/m]; 0 if finite
uniform vec4 finish;  // roughness, reflectance of lights, metallic, emission
out vec2 p;           // position in the plane [m]
out vec3 key_at;      // place in the map of the key light
out vec3 diffuse_key, diffuse_rest;
out vec3 sky;         // reflected light of the sky
out float far;        // 1 where an infinite plane ends
out float rise;       // of the reflected line of sight: 0 at the horizon, 1 upward

const int kCells = 32;

// Returns the place from -1 to 1 of a line from -1 to 1; lines are denser around m.
float placed(float line, float m) {
  float cube = line * line * line;
  return mix(m, line < 0.0 ? -1.0 : 1.0, abs(cube));
}

void main() {
  int cell = gl_VertexID / 6, corner = gl_VertexID % 6;
  ivec2 side = ivec2(corner == 1 || corner == 2 || corner == 4 ? 1 : 0, corner == 2 || corner == 4 || corner == 5 ? 1 : 0);
  vec2 line = 2.0 * vec2(ivec2(cell % kCells, cell / kCells) + side) / float(kCells) - 1.0;
  p = box.xy + box.zw * vec2(placed(line.x, middle.x), placed(line.y, middle.y));
  vec4 world = world_from_ground * vec4(p, 0.0, 1.0);
  vec3 n = world_from_ground[2].xyz, v = normalize(eye.xyz - world.xyz);
  key_at = key_map_point(world.xyz, n);
  diffuse_rest = ambient_light(world.xyz, n, v);
  diffuse_key = shadowing_light(world.xyz, n, v);
  sky = 0.4 * reflected_sky(n, v, vec3(0.04), finish);  // less than of a body, so that dark floors keep their hue
  rise = clamp(reflect(-v, n).z, 0.0, 1.0);
  far = smoothstep(0.25, 1.0, length(p - fade.xy) * fade.z);
  gl_Position = clip_from_view * (view_from_world * world);
  gl_ClipDistance[0] = clip_distance_of(world);
}
