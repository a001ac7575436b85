#version 410 core
#include "frame.glsl"

uniform mat4 world_from_ground;
uniform vec2 center;   // centre of the drawn scene, in the ground's frame [m]
uniform vec2 reach;    // 1 / radius at which the grid is invisible [1/m]
out vec2 p;            // position in the ground's frame [m]

const float kSides = 24.0;

// A fan around the centre: vertex 0 is the centre, and the others are outside the circle.
void main() {
  float angle = 6.283185307 * float(gl_VertexID) / kSides;
  float out_of_circle = 1.0087;  // 1 / cos(pi / kSides)
  p = center + (gl_VertexID == 0 ? 0.0 : out_of_circle / reach.x) * vec2(cos(angle), sin(angle));
  gl_Position = clip_from_view * (view_from_world * (world_from_ground * vec4(p, 0.0, 1.0)));
}
