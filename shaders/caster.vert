#version 410 core
#include "frame.glsl"

layout(location = 0) in vec3 position;
uniform mat4 world_from_mesh;
uniform vec4 plane;  // height of a point: dot(plane.xyz, p) + plane.w [m]
out float height;

void main() {
  vec4 p = world_from_mesh * vec4(position, 1.0);
  height = dot(plane.xyz, p.xyz) + plane.w;
  gl_Position = clip_from_view * (view_from_world * p);
}
