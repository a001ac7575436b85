#version 410 core
// An arrow: a shaft and a head by their distance functions, with a thin outline, so that it is visible on any
// background.
flat in vec4 tint;
flat in vec2 size;
noperspective in vec2 along;
uniform float dim;
uniform vec4 outline;  // sRGB, straight alpha
out vec4 color;        // premultiplied

// Returns the distance to the triangle with its tip at (0, 0) that opens towards -x, with length h and half width w.
float head_distance(vec2 q, float h, float w) {
  vec2 n = normalize(vec2(w, h));           // normal of its side
  float side = dot(vec2(q.x, abs(q.y)), n);
  return max(side, -q.x - h);
}

void main() {
  float w = size.y;
  float head = min(7.0 * w, size.x);
  float shaft_end = size.x - head;
  float shaft = length(vec2(along.x - clamp(along.x, 0.0, shaft_end), along.y)) - w;
  float d = min(shaft, head_distance(along - vec2(size.x, 0.0), head, 3.2 * w));
  float inner = clamp(0.5 - d, 0.0, 1.0), outer = clamp(1.5 - d, 0.0, 1.0) * outline.a;
  float alpha = max(inner, outer) * dim * tint.a;
  color = vec4(mix(outline.rgb, tint.rgb, inner) * alpha, alpha);
}
