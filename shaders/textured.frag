#version 410 core
#include "frame.glsl"
#include "key_shadow.glsl"
#include "light.glsl"
#include "near_contact.glsl"
#include "body.glsl"
#include "textured.glsl"
out vec4 color;  // premultiplied

void main() {
  color = vec4(body_color() * light_near_contact(p_W), 1.0) * base.a;
  if (!gl_FrontFacing && inside.a > 0.0) color = inside;
}
