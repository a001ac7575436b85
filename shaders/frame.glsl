// Uniforms that all shaders of one frame share, with the layout of FrameUniforms in C++.
layout(std140) uniform Frame {
  mat4 view_from_world;
  mat4 clip_from_view;
  vec4 eye;              // world [m]; w: pixels to a pixel of marks, which grow with the interface
  vec4 viewport;         // width, height [pixel], 1 / width, 1 / height
  vec4 key_light;        // towards the light, world; w: irradiance
  vec4 sky_light;        // hemisphere from above, linear; w: headlight
  vec4 ground_light;     // hemisphere from below, linear; w: near plane [m]
  vec4 clip_plane;       // points with dot(clip_plane, (p_W, 1)) < 0 are clipped, if `clipped` is 1
};

// Returns a point of the camera's frame that is drawn nearer by a fraction of its depth, at the same place on the screen.
// Without perspective, the depth is that of the target, 2.75 half heights of the view.
vec3 drawn_nearer(vec3 v, float part) {
  return clip_from_view[2][3] == 0.0 ? vec3(v.xy, v.z + part * 2.75 / clip_from_view[1][1]) : v * (1.0 - part);
}

// Some drivers clip by gl_ClipDistance even if clipping is disabled, so each draw also sets this uniform.
uniform float clipped;   // 1 if the plane clips, 0 if not
float clip_distance_of(vec4 p_W) { return clipped > 0.5 ? dot(clip_plane, p_W) : 1.0; }
