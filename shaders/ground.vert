#version 450 core
#include "frame.glsl"

uniform mat4 world_from_ground;
uniform vec2 center;   // of what is drawn, in the ground's frame [m]
uniform float radius;  // where the grid has faded away [m]
out vec2 p;            // in the ground's frame [m]

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  p = center + radius * corner;
  gl_Position = clip_from_view * (view_from_world * (world_from_ground * vec4(p, 0.0, 1.0)));
}
