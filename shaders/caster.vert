#version 450 core
#include "frame.glsl"

layout(location = 0) in vec3 position;
uniform mat4 world_from_mesh;
uniform vec4 ground;  // plane: dot(ground.xyz, p) + ground.w = height [m]
out float height;     // above the ground [m]

void main() {
  vec4 p = world_from_mesh * vec4(position, 1.0);
  height = dot(ground.xyz, p.xyz) + ground.w;
  gl_Position = clip_from_view * (view_from_world * p);
}
