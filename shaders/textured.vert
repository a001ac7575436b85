#version 410 core
#include "frame.glsl"
#include "key_shadow.glsl"
#include "light.glsl"
#include "body_vertex.glsl"

layout(location = 2) in vec2 texcoord;
out vec2 uv;
out vec3 light_mirrored;  // reflected without the colour of the body

void main() {
  vec3 of_sky, of_head;
  place_vertex(of_sky, of_head);
  light_mirrored = of_sky + of_head;
  uv = texcoord;
}
