#version 410 core
#include "frame.glsl"
#include "color.glsl"
#include "key_shadow.glsl"
#include "light.glsl"

in vec3 p_W;
in vec3 normal_W;
in vec3 key_at;
in vec3 diffuse_key, diffuse_rest;
uniform vec4 base;    // albedo, linear; opacity
uniform vec4 finish;  // roughness, reflectance of lights, metallic, emission
uniform vec4 inside;  // colour of the inside of bodies that a plane cuts open, sRGB; alpha 0 without a plane
out vec4 color;       // premultiplied

void main() {
  vec3 v = normalize(eye.xyz - p_W), n = normalize(normal_W);
  float cosine = dot(n, v);
  if (cosine < 0.0) n = cosine < -0.2 ? -n : normalize(n - 1.02 * cosine * v);  // from inside, or at an outline
  float key = key_light_at(key_at, diffuse_key.g > 0.002);
  vec3 l = towards(lights[0], p_W, v), h = normalize(l + v);
  vec3 f0 = mix(vec3(finish.y), base.rgb, finish.z);
  vec3 shine = key * clamp(dot(n, l), 0.0, 1.0) * within_spot(lights[0], l) *
               highlight(clamp(dot(n, h), 0.0, 1.0), dot(l, h), finish.x) * lights[0].specular;
  cosine = clamp(dot(n, v), 0.0, 1.0);
  shine += cosine * highlight(cosine, 1.0, finish.x) * head_specular;
  vec3 matte = base.rgb * (1.0 - finish.z) * (diffuse_rest + key * diffuse_key);
  vec3 light = matte + f0 * shine + reflected_sky(n, v, base.rgb, finish) + finish.w * base.rgb;
  color = vec4(display(light), 1.0) * base.a;
  if (!gl_FrontFacing && inside.a > 0.0) color = inside;
}
