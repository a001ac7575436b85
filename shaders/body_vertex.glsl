// A vertex of a body of a user's scene. Diffuse light and the reflected sky, which are smooth, are computed here, and the
// highlight of the first light in each pixel. Needs frame.glsl, key_shadow.glsl and light.glsl.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 world_from_mesh;
uniform float toward_eye;
uniform vec4 base;    // albedo, linear; opacity
uniform vec4 finish;  // roughness, reflectance of lights, metallic, emission
out vec3 normal_W, towards_eye;
out vec3 p_W;
out vec3 key_at;             // place in the map of the key light
out vec3 light_key, light_rest;  // leaving the surface

// Sets the outputs of a vertex. Sets light_rest without light that is reflected in the sky, and highlights, which it
// returns in two parts.
void place_vertex(out vec3 of_sky, out vec3 of_head) {
  vec4 p = world_from_mesh * vec4(position, 1.0);
  p_W = p.xyz;
  normal_W = mat3(world_from_mesh) * normal;
  key_at = key_map_point(p.xyz, normal_W);
  towards_eye = normalize(eye.xyz - p.xyz);
  float cosine = dot(normal_W, towards_eye);
  if (cosine < 0.0) normal_W = cosine < -0.2 ? -normal_W : normalize(normal_W - 1.02 * cosine * towards_eye);
  cosine = max(dot(normal_W, towards_eye), 0.0);
  vec3 matte = base.rgb * (1.0 - finish.z), f0 = mix(vec3(finish.y), base.rgb, finish.z);
  light_key = matte * shadowing_light(p.xyz, normal_W, towards_eye);
  light_rest = matte * ambient_light(p.xyz, normal_W, towards_eye) + finish.w * base.rgb;
  of_sky = reflected_sky(normal_W, towards_eye, base.rgb, finish);
  of_head = f0 * cosine * highlight(cosine, 1.0, finish.x) * head_specular;
  gl_Position = clip_from_view * vec4(drawn_nearer((view_from_world * p).xyz, toward_eye), 1.0);
  gl_ClipDistance[0] = clip_distance_of(p);
}
