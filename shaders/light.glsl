// Irradiance on a matte surface with normal n (world), seen along v (towards the eye).
vec3 irradiance(vec3 n, vec3 v) {
  vec3 hemisphere = mix(ground_light.rgb, sky_light.rgb, 0.5 + 0.5 * n.z);
  float key = key_light.w * max(0.0, 0.15 + 0.85 * dot(n, key_light.xyz));  // a large, soft source
  float head = sky_light.w * max(0.0, dot(n, v));
  return hemisphere + vec3(1.0, 0.98, 0.95) * key + vec3(head);
}
