#version 410 core
#include "frame.glsl"
#include "key_shadow.glsl"
#include "light.glsl"
#include "body_vertex.glsl"

void main() {
  vec3 of_sky, of_head;
  place_vertex(of_sky, of_head);
  light_rest = light_rest + of_sky + of_head;
}
