// What every shader of one picture shares; the layout of FrameUniforms in C++.
layout(std140, binding = 0) uniform Frame {
  mat4 view_from_world;
  mat4 clip_from_view;
  vec4 eye;              // world [m]; w: pixels to a pixel of marks, which grow with the interface
  vec4 viewport;         // width, height [pixel], 1 / width, 1 / height
  vec4 key_light;        // towards the light, world; w: irradiance
  vec4 sky_light;        // hemisphere from above, linear; w: headlight
  vec4 ground_light;     // hemisphere from below, linear; w: near plane [m]
  vec4 clip_plane;       // dot(clip_plane, (p_W, 1)) < 0: cut away, where that is asked for
};

// Some drivers clip by gl_ClipDistance whether that is switched on or not: so each draw says it as well.
uniform float clipped;   // 1: cut by the plane, 0: whole
float clip_distance_of(vec4 p_W) { return clipped > 0.5 ? dot(clip_plane, p_W) : 1.0; }
