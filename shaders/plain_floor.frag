#version 410 core
// A plane of a user's scene without texture and reflection: floor.frag without the reads of images, which a software
// renderer makes even if their results are not used.
#include "frame.glsl"
#include "key_shadow.glsl"
#include "light.glsl"

in vec3 key_at;
in vec3 diffuse_key, diffuse_rest;
in vec3 sky;
in float far;         // 1 where an infinite plane ends
uniform vec4 base;    // albedo, linear; opacity
uniform vec4 finish;  // roughness, reflectance of lights, metallic, emission
uniform vec4 haze;    // sRGB; alpha 0: the plane fades out instead
out vec4 color;       // premultiplied

void main() {
  float key = first_light_at(key_at);
  vec3 shown = displayed(base.rgb * (diffuse_rest + key * diffuse_key + finish.w) + sky);
  shown = mix(shown, haze.rgb, haze.a * far);
  color = vec4(shown, 1.0) * (base.a * (1.0 - (1.0 - haze.a) * far));
}
