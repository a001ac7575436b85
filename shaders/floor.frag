#version 410 core
#include "frame.glsl"
#include "key_shadow.glsl"
#include "light.glsl"

in vec2 p;
in vec3 key_at;
in vec3 diffuse_key, diffuse_rest;
in vec3 sky;
in float rise;
in float far;  // 1 where an infinite plane ends
uniform vec4 base;           // albedo, linear; opacity
uniform vec4 finish;         // roughness, reflectance of lights, metallic, emission
uniform vec4 repeat;         // scale and offset of texture coordinates; scale 0 without a texture
uniform sampler2D image;     // linear
uniform sampler2D mirrored;  // the scene in the plane, premultiplied display colours
uniform float reflectance;
uniform vec3 sky_high, sky_low;  // sRGB
uniform vec4 haze;           // sRGB; alpha 0: the plane fades out instead
out vec4 color;              // premultiplied

void main() {
  vec3 albedo = base.rgb;
  if (repeat.x > 0.0) albedo *= texture(image, p * repeat.xy + repeat.zw).rgb;
  float key = first_light_at(key_at);
  vec3 shown = displayed(albedo * (diffuse_rest + key * diffuse_key + finish.w) + sky);
  if (reflectance > 0.0) {
    vec4 seen = texture(mirrored, gl_FragCoord.xy * viewport.zw);
    shown = mix(shown, seen.rgb + (1.0 - seen.a) * mix(sky_low, sky_high, rise), reflectance);
  }
  shown = mix(shown, haze.rgb, haze.a * far);
  color = vec4(shown, 1.0) * (base.a * (1.0 - (1.0 - haze.a) * far));
}
