#version 410 core
#include "frame.glsl"
// The part of the ground on which a shadow may be.
uniform mat4 world_from_ground;
uniform vec4 box;      // low corner and size, ground frame [m]
uniform float toward_eye;
out vec2 uv;

void main() {
  uv = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  vec3 v = (view_from_world * (world_from_ground * vec4(box.xy + uv * box.zw, 0.0, 1.0))).xyz;
  gl_Position = clip_from_view * vec4(drawn_nearer(v, toward_eye), 1.0);
}
