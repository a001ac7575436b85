#version 410 core
// The colour of the pressure at this fragment, from the table; exact and without light.
in float p;
uniform sampler2D color_table;  // 256 x 1
uniform vec2 range;             // lowest pressure [Pa], 1 / (highest - lowest)
uniform float dim;
out vec4 color;                 // premultiplied

void main() {
  float x = 255.0 * clamp((p - range.x) * range.y, 0.0, 1.0);
  int i = min(int(x), 254);
  vec3 below = texelFetch(color_table, ivec2(i, 0), 0).rgb, above = texelFetch(color_table, ivec2(i + 1, 0), 0).rgb;
  vec3 rgb = mix(below, above, x - float(i));
  color = vec4(rgb, 1.0) * dim;
}
