#version 410 core
// A body of a user's scene that touches a sensor. Its opaque part and its transparent part are drawn separately, so that
// the transparent part hides nothing. Behind it one sees the opaque inside of the object.
#include "frame.glsl"
#include "key_shadow.glsl"
#include "light.glsl"
#include "near_contact.glsl"
#include "body.glsl"
uniform float opaque;  // 1 for the opaque part, 0 for the transparent part
out vec4 color;        // premultiplied

void main() {
  float alpha = gl_FrontFacing ? alpha_near_contact(p_W) : 1.0;
  if ((alpha >= 1.0) != (opaque > 0.5)) discard;
  color = vec4(body_color() * (gl_FrontFacing ? 1.0 : kInside), 1.0) * alpha;
  if (!gl_FrontFacing && inside.a > 0.0) color = inside;
}
