// Light on a surface of a user's scene: the lights of its file, and an analytic sky whose prefiltered diffuse and
// specular light has a closed form. All colours are linear. Diffuse light is smooth enough to be computed at vertices.
// Needs frame.glsl and key_shadow.glsl.
const int kMaxLights = 4;

// Returns the colour on the display: a soft shoulder above 0.7, and a square root instead of the curve of sRGB, from which
// it differs by less than 4 %. The tone mapper of color.glsl takes twice the time of everything else on a floor.
vec3 displayed(vec3 linear) {
  float peak = max(linear.r, max(linear.g, linear.b));
  return sqrt(linear / (1.0 + 0.55 * max(peak - 0.7, 0.0)));
}

// Returns the fraction of the first light that reaches a point, at its place in the map of key_shadow.glsl, by one read
// that compares four texels. All casters are nearer than the far end of the map, at 1.
float first_light_at(vec3 at) { return key_offset > 0.0 ? texture(key_map, vec3(at.xy, min(at.z, 1.0))) : 1.0; }

struct Light {
  vec4 at;       // w 0: direction towards the light; w 1: position [m]; w 2: at the eye
  vec4 axis;     // direction of a spot, and the cosine of its cutoff; -2 for other lights
  vec4 diffuse;  // colour; w: exponent of a spot
  vec3 specular;
};
uniform Light lights[kMaxLights];
uniform int light_count;
uniform int key_count;             // lights from about the same direction, of which the first one casts the shadow
uniform vec3 head_specular;        // colour of the highlights of the light at the eye

vec3 towards(Light light, vec3 p, vec3 v) {
  return light.at.w > 1.5 ? v : normalize(light.at.xyz - light.at.w * p);
}

// Returns the fraction of a light's intensity in direction l, towards the light.
float within_spot(Light light, vec3 l) {
  if (light.axis.w < -1.5) return 1.0;
  float along = dot(-l, light.axis.xyz);
  return smoothstep(light.axis.w, mix(light.axis.w, 1.0, 0.15), along) * pow(max(along, 1e-3), light.diffuse.w);
}

vec3 diffuse_of(Light light, vec3 p, vec3 n, vec3 v) {
  vec3 l = towards(light, p, v);
  return clamp(dot(n, l), 0.0, 1.0) * within_spot(light, l) * light.diffuse.rgb;
}

// Returns the diffuse light on a surface, without the lights that cast the shadow.
vec3 ambient_light(vec3 p, vec3 n, vec3 v) {
  vec3 sum = mix(ground_light.rgb, sky_light.rgb, 0.5 + 0.5 * n.z);
  for (int i = key_count; i < light_count; ++i) sum += diffuse_of(lights[i], p, n, v);
  return sum;
}

// Returns the diffuse light of the lights that cast the shadow.
vec3 shadowing_light(vec3 p, vec3 n, vec3 v) {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < key_count; ++i) sum += diffuse_of(lights[i], p, n, v);
  return sum;
}

// Returns the radiance of the sky in direction r, blurred as a surface of this roughness reflects it: bright above, a
// soft horizon, and a brighter band at half height, as of the lamps of a photographer's studio.
vec3 sky_radiance(vec3 r, float roughness) {
  float width = mix(0.12, 0.9, roughness);
  vec3 sky = mix(ground_light.rgb, 1.9 * sky_light.rgb, smoothstep(-width, width, r.z));
  float spread = mix(0.10, 0.60, roughness), off = (r.z - 0.5) / spread;
  return sky + (0.22 / spread) / (1.0 + off * off * (1.0 + off * off)) * sky_light.rgb;
}

// Returns the fraction of the sky's light that a rough surface reflects (Karis 2014, "Physically based shading on
// mobile", after Lazarov 2013).
vec3 sky_reflectance(vec3 f0, float roughness, float cosine) {
  vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
  float a = min(r.x * r.x, exp2(-9.28 * cosine)) * r.x + r.y;
  return f0 * (r.z - 1.04 * a) + r.w + 1.04 * a;
}

// Returns the sky's light that a surface reflects towards v.
vec3 reflected_sky(vec3 n, vec3 v, vec3 albedo, vec4 finish) {
  const float dielectric = 0.04;  // the tone mapper expects this reflection
  vec3 f0 = mix(vec3(dielectric), albedo, finish.z);
  return sky_radiance(reflect(-v, n), finish.x) * sky_reflectance(f0, finish.x, clamp(dot(n, v), 0.0, 1.0));
}

// Returns the highlight for the cosines of the half vector with the normal and with the light: GGX, whose visibility is
// approximated as by Karis.
float highlight(float nh, float lh, float roughness) {
  float alpha = max(roughness * roughness, 0.01), alpha2 = alpha * alpha, d = nh * nh * (alpha2 - 1.0) + 1.0;
  return alpha2 / (4.0 * d * d * max(lh * lh, 0.1) * (roughness + 0.5));
}
