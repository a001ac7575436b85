#version 410 core
flat in vec4 tint;
flat in vec2 size;
noperspective in vec2 along;
uniform float dim;  // brightness: 1, or less for hidden parts
out vec4 color;     // premultiplied

void main() {
  float outside = length(vec2(along.x - clamp(along.x, 0.0, size.x), along.y));
  float cover = clamp(size.y + 0.5 - outside, 0.0, min(1.0, 2.0 * size.y));
  float alpha = tint.a * cover * dim;
  color = vec4(tint.rgb * alpha, alpha);
}
