#version 410 core
#include "frame.glsl"
#include "segment.glsl"

uniform float width_scale;

flat out vec4 tint;
flat out vec2 size;            // length, half width of the shaft [pixel]
noperspective out vec2 along;  // from the tail along the arrow and across it [pixel]

void main() {
  Segment s = segment_at(gl_VertexID / 4);
  float width = width_scale * segment_width(s);
  vec4 a, b;
  gl_Position = kNowhere;
  tint = unpackUnorm4x8(s.rgba);
  size = vec2(0.0);
  along = vec2(0.0);
  vec2 corner = quad_corner(gl_VertexID);
  gl_ClipDistance[0] = clip_distance(corner.x > 0.5 ? s.b : s.a);
  if (!segment_ends(s, a, b)) return;
  vec2 pa = 0.5 * viewport.xy * a.xy / a.w, pb = 0.5 * viewport.xy * b.xy / b.w;
  vec2 d = pb - pa;
  float len = length(d);
  d = len > 1e-4 ? d / len : vec2(1.0, 0.0);
  float reach = 2.2 * width + 2.0;
  vec2 offset = reach * ((2.0 * corner.x - 1.0) * d + corner.y * vec2(-d.y, d.x));
  vec4 end = corner.x > 0.5 ? b : a;
  gl_Position = vec4(end.xy + offset * 2.0 * viewport.zw * end.w, end.zw);
  size = vec2(len, 0.5 * width);
  along = vec2(corner.x * len + (2.0 * corner.x - 1.0) * reach, corner.y * reach);
}
