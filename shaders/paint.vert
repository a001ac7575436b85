#version 410 core
#include "frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec4 rgba;  // sRGB, straight alpha
uniform mat4 world_from_model;
uniform float toward_eye;
flat out vec4 tint;

void main() {
  vec4 p = world_from_model * vec4(position, 1.0);
  vec3 v = drawn_nearer((view_from_world * p).xyz, toward_eye);
  gl_ClipDistance[0] = clip_distance_of(p);
  gl_Position = clip_from_view * vec4(v, 1.0);
  tint = rgba;
}
