// What every shader of one picture shares; the layout of FrameUniforms in C++.
layout(std140, binding = 0) uniform Frame {
  mat4 view_from_world;
  mat4 clip_from_view;
  vec4 eye;              // world [m]
  vec4 viewport;         // width, height [pixel], 1 / width, 1 / height
  vec4 key_light;        // towards the light, world; w: irradiance
  vec4 sky_light;        // hemisphere from above, linear; w: headlight
  vec4 ground_light;     // hemisphere from below, linear; w: near plane [m]
};
