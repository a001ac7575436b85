#version 410 core
#include "frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;  // zero if visible from everywhere; w is a fraction of the size
layout(location = 2) in vec4 rgba;    // sRGB, straight alpha
uniform mat4 world_from_model;
uniform float toward_eye;
uniform float diameter;               // [pixel of marks]
uniform float outline_width;          // [pixel of marks]
uniform float facing;                 // +1 for points that face the eye, -1 for points that face away, 0 for all
flat out vec4 tint;
flat out float radius;                // [pixel]
flat out float rim_width;             // [pixel]

// A position outside the view, where points are dropped without being clipped.
const vec4 kNowhere = vec4(1.5, 1.5, 0.0, 1.0);

void main() {
  vec4 p = world_from_model * vec4(position, 1.0);
  vec3 n = mat3(world_from_model) * normal.xyz;
  float toward = dot(n, eye.xyz - p.xyz);
  float d = diameter * normal.w * eye.w;
  tint = rgba;
  radius = 0.5 * d;
  rim_width = outline_width * eye.w;
  gl_PointSize = d + 1.0;
  vec3 v = drawn_nearer((view_from_world * p).xyz, toward_eye);
  gl_Position = clip_from_view * vec4(v, 1.0);
  gl_ClipDistance[0] = clip_distance_of(p);
  if (facing * toward < 0.0) gl_Position = kNowhere;
}
