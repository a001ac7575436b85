#version 410 core
// A body of a user's scene. Diffuse light is computed here, reflections in each pixel.
#include "frame.glsl"
#include "key_shadow.glsl"
#include "light.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 world_from_mesh;
uniform float toward_eye;
out vec3 p_W;
out vec3 normal_W;
out vec3 key_at;  // place in the map of the key light
out vec3 diffuse_key, diffuse_rest;

void main() {
  vec4 p = world_from_mesh * vec4(position, 1.0);
  p_W = p.xyz;
  normal_W = mat3(world_from_mesh) * normal;
  key_at = key_map_point(p.xyz, normal_W);
  vec3 v = normalize(eye.xyz - p_W);
  vec3 n = dot(normal_W, v) < 0.0 ? -normal_W : normal_W;
  diffuse_rest = ambient_light(p_W, n, v);
  diffuse_key = shadowing_light(p_W, n, v);
  gl_Position = clip_from_view * vec4(drawn_nearer((view_from_world * p).xyz, toward_eye), 1.0);
  gl_ClipDistance[0] = clip_distance_of(p);
}
