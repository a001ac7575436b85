#version 410 core
// Light is computed per vertex: on matte bodies the difference is invisible, and a software renderer takes half the
// time.
#include "frame.glsl"
#include "color.glsl"
#include "key_shadow.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 world_from_mesh;
uniform vec3 albedo;       // linear
out vec3 shade;            // sRGB
out vec3 shade_unlit;      // sRGB, colour without the key light
out vec3 key_at;           // place in the map of the key light
out float facing;          // cosine between normal and eye; negative if seen from inside
out vec3 p_W;
out vec3 normal_W;          // towards the eye
out float upward;

// Returns the irradiance on a matte surface with normal n, seen along v (towards the eye), without the key light.
vec3 ambient(vec3 n, vec3 v) {
  vec3 hemisphere = mix(ground_light.rgb, sky_light.rgb, 0.5 + 0.5 * n.z);
  return hemisphere + vec3(sky_light.w * max(0.0, dot(n, v)));
}

vec3 key(vec3 n) {
  return vec3(1.0, 0.98, 0.95) * key_light.w * max(0.0, 0.15 + 0.85 * dot(n, key_light.xyz));  // a large, soft source
}

void main() {
  vec4 p = world_from_mesh * vec4(position, 1.0);
  vec3 n = mat3(world_from_mesh) * normal;
  vec3 v = normalize(eye.xyz - p.xyz);
  facing = dot(n, v);
  vec3 towards = facing < 0.0 ? -n : n;
  vec3 unlit = ambient(towards, v);
  shade = display(albedo * (unlit + key(towards)));
  shade_unlit = display(albedo * unlit);
  key_at = key_map_point(p.xyz, n);
  p_W = p.xyz;
  normal_W = towards;
  upward = n.z;
  gl_Position = clip_from_view * (view_from_world * p);
  gl_ClipDistance[0] = clip_distance_of(p);
}
