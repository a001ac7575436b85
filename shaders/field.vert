#version 410 core
// The receptive fields of taxels on the skin. A buffer texture holds the colours of each taxel.
#include "frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 from_center;  // its length is the distance from the centre as a fraction of the radius
layout(location = 2) in vec3 normal;       // of the skin, in the frame of the disc
layout(location = 3) in float taxel;
uniform usamplerBuffer styles;             // one texel of four words for each taxel, in the order of FieldStyle in C++
uniform mat4 world_from_model;
uniform float toward_eye;
out vec3 place;
out vec3 normal_D;
flat out vec4 fill, ring;  // sRGB, straight alpha
flat out float width;      // of the ring [pixel]

void main() {
  vec4 p = world_from_model * vec4(position, 1.0);
  gl_ClipDistance[0] = clip_distance_of(p);
  gl_Position = clip_from_view * vec4(drawn_nearer((view_from_world * p).xyz, toward_eye), 1.0);
  place = from_center;
  normal_D = normal;
  uvec4 style = texelFetch(styles, int(taxel + 0.5));
  fill = unpackUnorm4x8(style.x);
  ring = unpackUnorm4x8(style.y);
  width = uintBitsToFloat(style.z) * eye.w;
}
