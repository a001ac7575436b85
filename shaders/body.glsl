// The light that a body of a user's scene sends to the eye. Needs frame.glsl and light.glsl.
in vec3 normal_W, towards_eye;
in vec3 key_at;
in vec3 p_W;
in vec3 light_key, light_rest;  // leaving the surface
uniform vec4 base;          // albedo, linear; opacity
uniform vec4 finish;        // roughness, reflectance of lights, metallic, emission
uniform vec3 key_direction; // towards the first light
uniform vec4 inside;        // colour of the inside of bodies that a plane cuts open, sRGB; alpha 0 without a plane

// Returns the colour of a body of this albedo far from contacts, sRGB, with the light that leaves its surface.
vec3 color_in_light(vec3 albedo, vec3 from_key, vec3 from_rest) {
  float key = first_light_at(key_at);
  vec3 n = normalize(normal_W), h = normalize(key_direction + towards_eye);
  float facing = clamp(3.0 * dot(n, key_direction), 0.0, 1.0);
  float shine = facing * highlight(clamp(dot(n, h), 0.0, 1.0), dot(key_direction, h), finish.x);
  vec3 f0 = mix(vec3(finish.y), albedo, finish.z);
  vec3 light = from_rest + key * (from_key + shine * f0 * lights[0].specular);
  return displayed(light);
}
