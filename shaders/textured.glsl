// A body with a texture, which multiplies its colour. Needs body.glsl.
in vec2 uv;
in vec3 light_mirrored;  // reflected without the colour of the body
uniform sampler2D image; // linear

vec3 body_color() {
  vec3 texel = texture(image, uv).rgb;
  vec3 mirrored = light_mirrored * mix(vec3(1.0), texel, finish.z);
  return color_in_light(base.rgb * texel, light_key * texel, light_rest * texel + mirrored);
}
