#version 410 core
#include "frame.glsl"

layout(location = 0) in vec2 position;  // in the clip plane [m]
uniform mat4 world_from_plane;
uniform float toward_eye;
out vec2 p;

void main() {
  p = position;
  vec3 v = drawn_nearer((view_from_world * (world_from_plane * vec4(position, 0.0, 1.0))).xyz, toward_eye);
  gl_Position = clip_from_view * vec4(v, 1.0);
}
