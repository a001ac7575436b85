#version 410 core
// A receptive field, whose border is found in each pixel: where the distance from the centre is the radius, or where the
// normal of the skin is at the angle limit. Both are divided by their change from pixel to pixel, so that lines have the
// same width everywhere and smooth edges.
in vec3 place;
in vec3 normal_D;
flat in vec4 fill, ring;
flat in float width;
uniform float min_cosine;
uniform float at_rim;    // opacity of the fill at the rim as a fraction of that in the middle
uniform vec4 casing;     // line at the inner side of the ring, sRGB, straight alpha
uniform float dim;       // factor of alpha
uniform float multiply;  // 1 if the fill's colour multiplies the skin's colour, 0 if it covers the skin
out vec4 color;          // premultiplied

float change(float x) { return max(length(vec2(dFdx(x), dFdy(x))), 1e-7); }

void main() {
  float away = length(place), cosine = normal_D.z * inversesqrt(max(dot(normal_D, normal_D), 1e-12));
  float inside = min((1.0 - away) / change(away), (cosine - min_cosine) / change(cosine));  // [pixel]
  float cover = clamp(inside + 0.5, 0.0, 1.0);
  if (multiply > 0.5) {
    color = vec4(mix(vec3(1.0), fill.rgb, cover * fill.a), 1.0);
    return;
  }
  float line = clamp(width + 0.5 - inside, 0.0, 1.0) * cover;
  float edge = casing.a * clamp(width + 1.5 - inside, 0.0, 1.0) * cover * min(width, 1.0);
  float alpha = fill.a * (1.0 - (1.0 - at_rim) * away * away) * cover;
  color = vec4(fill.rgb, 1.0) * alpha;
  color = mix(color, vec4(casing.rgb, 1.0), edge * ring.a);
  color = mix(color, vec4(ring.rgb, 1.0), line * ring.a) * dim;
}
