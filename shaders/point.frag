#version 410 core
flat in vec4 tint;
flat in float radius;
flat in float rim_width;
uniform float dim;
uniform vec4 outline;         // sRGB, straight alpha
out vec4 color;               // premultiplied

void main() {
  vec2 d = (gl_PointCoord - 0.5) * (2.0 * radius + 1.0);
  float r = length(d);
  bool middle = max(abs(d.x), abs(d.y)) <= 0.5;  // the central pixel always has the colour of the point
  float cover = middle ? 1.0 : clamp(radius + 0.5 - r, 0.0, 1.0) * min(radius, 1.0);
  float rim = rim_width > 0.0 ? clamp(r - (radius - rim_width) + 0.5, 0.0, 1.0) * outline.a : 0.0;
  float alpha = tint.a * cover * dim;
  color = vec4(mix(tint.rgb, outline.rgb, rim) * alpha, alpha);
}
