#version 410 core
#include "frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in float pressure;  // [Pa]
uniform mat4 world_from_model;
uniform float toward_eye;
out float p;

void main() {
  vec4 p_W = world_from_model * vec4(position, 1.0);
  vec3 v = drawn_nearer((view_from_world * p_W).xyz, toward_eye);
  gl_ClipDistance[0] = clip_distance_of(p_W);
  gl_Position = clip_from_view * vec4(v, 1.0);
  p = pressure;
}
