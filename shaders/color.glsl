// Conversion of linear light to display colours. Colours of data are not converted, because they are already sRGB.

// Khronos PBR Neutral tone mapper (2024): preserves hue and value of base colours below 0.76, and compresses only
// highlights.
vec3 tone_map_neutral(vec3 color) {
  const float f90 = 0.04;
  const float shoulder = 0.8 - f90;
  float low = min(color.r, min(color.g, color.b));
  color -= low < 2.0 * f90 ? low - low * low / (4.0 * f90) : f90;
  float peak = max(color.r, max(color.g, color.b));
  float room = 1.0 - shoulder;
  float squeezed = 1.0 - room * room / (max(peak, shoulder) + room - shoulder);
  float shown = peak < shoulder ? peak : squeezed;
  color *= shown / max(peak, 1e-6);
  float white = peak < shoulder ? 0.0 : 1.0 - 1.0 / (0.15 * (peak - shown) + 1.0);
  return mix(color, vec3(shown), white);
}

// IEC 61966-2-1 transfer function. Three square roots replace the power; the error is below 0.3 of a level of 255.
vec3 srgb_from_linear(vec3 c) {
  vec3 s1 = sqrt(c), s2 = sqrt(s1), s3 = sqrt(s2);
  vec3 curve = 0.662002687 * s1 + 0.684122060 * s2 - 0.323583601 * s3 - 0.0225411470 * c;
  return mix(curve, 12.92 * c, lessThan(c, vec3(0.0031308)));
}

vec3 display(vec3 linear) { return srgb_from_linear(clamp(tone_map_neutral(max(linear, vec3(0.0))), 0.0, 1.0)); }

// Noise of half a level, which prevents bands in gradients (Jimenez 2014, interleaved gradient noise).
float dither(vec2 pixel) { return (fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0; }
