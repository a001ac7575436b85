#version 410 core
#include "frame.glsl"
#include "color.glsl"
#include "key_shadow.glsl"

in vec2 p;
in vec3 key_at;
in vec3 diffuse_key, diffuse_rest;
in vec3 sky;
in float rise;
uniform vec4 base;           // albedo, linear; opacity
uniform vec4 finish;         // roughness, reflectance of lights, metallic, emission
uniform vec4 repeat;         // scale and offset of texture coordinates; scale 0 without a texture
uniform sampler2D image;     // linear
uniform sampler2D mirrored;  // the scene in the plane, premultiplied display colours
uniform float reflectance;
uniform vec3 sky_high, sky_low;  // sRGB
uniform vec4 fade;           // middle of an infinite plane [m], 1 / distance at which it ends [1/m]; 0 if finite
uniform vec4 haze;           // sRGB; alpha 0: the plane fades out instead
out vec4 color;              // premultiplied

void main() {
  vec3 albedo = base.rgb;
  if (repeat.x > 0.0) albedo *= texture(image, p * repeat.xy + repeat.zw).rgb;
  vec2 at = abs(key_at.xy - 0.5);
  // All casters are nearer to the light than the far end of the map, at 1.
  float key = key_light_at(vec3(key_at.xy, min(key_at.z, 1.0)), max(at.x, at.y) < 0.5);
  vec3 shown = display(albedo * (diffuse_rest + key * diffuse_key + finish.w) + sky);
  if (reflectance > 0.0) {
    vec4 seen = texture(mirrored, gl_FragCoord.xy * viewport.zw);
    shown = mix(shown, seen.rgb + (1.0 - seen.a) * mix(sky_low, sky_high, rise), reflectance);
  }
  float far = smoothstep(0.25, 1.0, length(p - fade.xy) * fade.z);
  if (haze.a > 0.0) {
    shown = mix(shown, haze.rgb, far);
    far = 0.0;
  }
  color = vec4(shown + dither(gl_FragCoord.xy), 1.0) * (base.a * (1.0 - far));
}
