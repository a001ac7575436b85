// The sheen of silicone: a broad soft highlight, a fainter one that is wider still, and light that grazes the outline.
// Needs frame.glsl.

// Returns the sheen of a surface with unit normal n, seen along v (towards the eye), of which the fraction `lit` gets
// the key light.
float silicone_sheen(vec3 n, vec3 v, float lit) {
  float nh = max(dot(n, normalize(key_light.xyz + v)), 0.0), grazing = 1.0 - max(dot(n, v), 0.0);
  float nh4 = nh * nh * nh * nh, nh16 = nh4 * nh4 * nh4 * nh4;
  float sky = 0.5 + 0.5 * n.z;
  return lit * (0.30 * nh16 * nh16 * nh4 + 0.10 * nh4) + sky * 0.16 * grazing * grazing * grazing;
}

// Returns a colour under a sheen. Both are added like transparencies, so that no light is cut off.
vec3 with_sheen(vec3 color, float sheen) { return 1.0 - (1.0 - color) * (1.0 - sheen * vec3(1.0, 0.985, 0.96)); }
