#version 450 core
#include "frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 world_from_mesh;
out vec3 p_W;
out vec3 n_W;

void main() {
  vec4 p = world_from_mesh * vec4(position, 1.0);
  p_W = p.xyz;
  n_W = mat3(world_from_mesh) * normal;
  gl_Position = clip_from_view * (view_from_world * p);
}
