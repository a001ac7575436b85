#version 450 core
// Light is worked out per vertex: on matte bodies nobody sees the difference, and a software renderer takes half the
// time.
#include "frame.glsl"
#include "color.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 world_from_mesh;
uniform vec3 albedo;       // linear
out vec3 shade;            // sRGB
out float facing;          // cosine between normal and eye; negative: seen from inside
out vec3 p_W;
out float upward;

// Irradiance on a matte surface with normal n, seen along v (towards the eye).
vec3 irradiance(vec3 n, vec3 v) {
  vec3 hemisphere = mix(ground_light.rgb, sky_light.rgb, 0.5 + 0.5 * n.z);
  float key = key_light.w * max(0.0, 0.15 + 0.85 * dot(n, key_light.xyz));  // a large, soft source
  float head = sky_light.w * max(0.0, dot(n, v));
  return hemisphere + vec3(1.0, 0.98, 0.95) * key + vec3(head);
}

void main() {
  vec4 p = world_from_mesh * vec4(position, 1.0);
  vec3 n = mat3(world_from_mesh) * normal;
  vec3 v = normalize(eye.xyz - p.xyz);
  facing = dot(n, v);
  shade = display(albedo * irradiance(facing < 0.0 ? -n : n, v));
  p_W = p.xyz;
  upward = n.z;
  gl_Position = clip_from_view * (view_from_world * p);
  gl_ClipDistance[0] = clip_distance_of(p);
}
