#version 410 core

in vec2 p;
uniform vec2 center;
uniform vec2 reach;  // 1 / radius, 1 / cell [1/m]; every tenth line is a major one
uniform vec4 fill;   // sRGB, straight alpha
uniform vec4 line;
out vec4 color;      // premultiplied

// Returns the coverage of lines one pixel wide at the whole numbers of u, whose change per pixel is `du`. Lines fade
// out if they are too dense.
float grid_lines(vec2 u, vec2 du) {
  vec2 pixels = abs(fract(u + 0.5) - 0.5) / du;
  vec2 cover = clamp(1.0 - pixels, 0.0, 1.0) * clamp(1.3 - 8.0 * du, 0.0, 1.0);
  return max(cover.x, cover.y);
}

void main() {
  vec2 u = p * reach.y;
  vec2 du = fwidth(u);
  float cover = line.a * max(0.45 * grid_lines(u, du), grid_lines(0.1 * u, 0.1 * du));
  vec2 d = (p - center) * reach.x;
  float fade = clamp(1.25 - 1.25 * dot(d, d), 0.0, 1.0);
  color = fade * (vec4(line.rgb * cover, cover) + vec4(fill.rgb, 1.0) * (fill.a * (1.0 - cover)));
}
