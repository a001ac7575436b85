#version 410 core
#include "near_contact.glsl"
#include "solid.glsl"
out vec4 color;

void main() {
  color = vec4(matte_color(key_light_here()), 1.0);
  if (!gl_FrontFacing && inside.a > 0.0) color = inside;
}
