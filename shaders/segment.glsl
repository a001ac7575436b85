// Straight segments on the screen, read from a buffer: four vertices each, without vertex attributes. A buffer texture
// holds them, because OpenGL 4.1 has no storage buffers.
struct Segment {
  vec3 a;
  uint normal;  // three signed bytes, zero if visible from everywhere; last byte: width in tenths of a pixel of marks
  vec3 b;
  uint rgba;    // sRGB, straight alpha
};
uniform usamplerBuffer segments;  // two texels of four words each, in the order of Segment in C++

Segment segment_at(int i) {
  uvec4 first = texelFetch(segments, 2 * i), second = texelFetch(segments, 2 * i + 1);
  return Segment(uintBitsToFloat(first.xyz), first.w, uintBitsToFloat(second.xyz), second.w);
}

uniform mat4 world_from_model;
uniform float toward_eye;  // fraction of the depth by which it is drawn nearer, at the same place on the screen

uniform float facing;      // +1 for segments that face the eye, -1 for segments that face away, 0 for all

float segment_width(Segment s) { return 12.7 * unpackSnorm4x8(s.normal).w * eye.w; }  // [pixel]

// Position of all four corners of a segment that is not drawn: it has no area and needs no clipping. In a software
// renderer, one vertex outside the view makes its whole batch take the slow path that clips.
const vec4 kNowhere = vec4(0.0, 0.0, 0.0, 1.0);

// Returns the ends of a segment in clip coordinates, clipped at the near plane. Returns false if the whole segment is
// behind the near plane or faces the wrong side.
bool segment_ends(Segment s, out vec4 a_clip, out vec4 b_clip) {
  vec3 toward = eye.xyz - (world_from_model * vec4(s.a, 1.0)).xyz;
  if (facing * dot(mat3(world_from_model) * unpackSnorm4x8(s.normal).xyz, toward) < 0.0) return false;
  vec3 a = (view_from_world * (world_from_model * vec4(s.a, 1.0))).xyz;
  vec3 b = (view_from_world * (world_from_model * vec4(s.b, 1.0))).xyz;
  float near = -ground_light.w;
  if (a.z > near && b.z > near) return false;
  if (a.z > near) a = mix(b, a, (near - b.z) / (a.z - b.z));
  if (b.z > near) b = mix(a, b, (near - a.z) / (b.z - a.z));
  a_clip = clip_from_view * vec4(drawn_nearer(a, toward_eye), 1.0);
  b_clip = clip_from_view * vec4(drawn_nearer(b, toward_eye), 1.0);
  return true;
}

// Returns the distance of an end from the clip plane, positive if it is visible.
float clip_distance(vec3 end) { return clip_distance_of(world_from_model * vec4(end, 1.0)); }

// Returns corner 0..3 of a quad as (end 0 or 1, side -1 or +1).
vec2 quad_corner(int vertex) { return vec2(vertex & 1, 2 * ((vertex >> 1) & 1) - 1); }
