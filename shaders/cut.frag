#version 410 core
// The face of a cut: unlit, hatched as in engineering drawings (ISO 128-50).
in vec2 p;              // in the clip plane [m]
uniform vec3 fill;      // sRGB
uniform vec3 line;
uniform vec2 across;    // dot(across, p) grows by 1 from one hatch line to the next [1/m]
uniform float alpha;
out vec4 color;         // premultiplied

void main() {
  float u = dot(across, p), du = fwidth(u);
  float pixels = abs(fract(u + 0.5) - 0.5) / du;                                    // distance from the nearest line
  float cover = clamp(1.2 - pixels, 0.0, 1.0) * clamp(1.5 - 5.0 * du, 0.0, 1.0);  // fades dense lines out
  color = vec4(mix(fill, line, cover), 1.0) * alpha;
}
