#version 410 core
// Scalable ambient obscurance (McGuire, Mara, Luebke 2012): the fraction of the surroundings of a point that rises
// above its surface.
#include "frame.glsl"
#include "occlusion.glsl"

uniform float radius;  // [m]
out vec4 color;        // remaining light, and distance in front of the eye [m]

const int kSamples = 16;
const float kTurns = 7.0, kBias = 0.04, kStrength = 1.6;

// Returns the shorter of two vectors, which leads to a neighbour on the same surface.
vec3 shorter(vec3 a, vec3 b) { return abs(a.z) < abs(b.z) ? a : b; }

void main() {
  ivec2 at = 2 * ivec2(gl_FragCoord.xy);
  vec3 c = point_at(at);
  color = vec4(1.0, -c.z, 0.0, 1.0);
  if (depth_of(at) >= 1.0) return;
  vec3 dx = shorter(point_at(at + ivec2(1, 0)) - c, c - point_at(at - ivec2(1, 0)));
  vec3 dy = shorter(point_at(at + ivec2(0, 1)) - c, c - point_at(at - ivec2(0, 1)));
  vec3 n = normalize(cross(dx, dy));
  float reach = min(0.5 * viewport.y * clip_from_view[1][1] * radius / spread_at(-c.z), 0.25 * viewport.y);  // [pixel]
  ivec2 cell = ivec2(gl_FragCoord.xy) & 3;
  float turn = float((cell.x * 5 + cell.y * 3) & 15) * 0.3926991;  // differs within each block of 4 x 4, which the blur averages
  float sum = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    float part = (float(i) + 0.5) / float(kSamples), angle = 6.2831853 * kTurns * part + turn;
    vec3 v = point_at(at + ivec2(round(reach * part * vec2(cos(angle), sin(angle))))) - c;
    float vv = dot(v, v), near = max(1.0 - vv / (radius * radius), 0.0);
    sum += near * near * near * max(dot(v, n) - kBias * radius, 0.0) * radius / (vv + 1e-3 * radius * radius);
  }
  color.r = max(0.0, 1.0 - kStrength * sum / float(kSamples));
}
