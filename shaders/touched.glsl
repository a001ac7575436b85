// A body of a user's scene that touches a sensor. Its opaque part and its transparent part are drawn separately, so that
// the transparent part hides nothing. Behind it one sees the opaque inside of the object. Needs body.glsl, and plain.glsl
// or textured.glsl.
uniform float opaque;  // 1 for the opaque part, 0 for the transparent part
out vec4 color;        // premultiplied

void main() {
  float distance = contact_distance(p_W), alpha = gl_FrontFacing ? alpha_at_distance(distance) : 1.0;
  if ((alpha >= 1.0) != (opaque > 0.5)) discard;
  vec3 shown = body_color() * light_at_distance(distance);
  color = vec4(shown * (gl_FrontFacing ? 1.0 : kInside), 1.0) * alpha;
  if (!gl_FrontFacing && inside.a > 0.0) color = inside;
}
