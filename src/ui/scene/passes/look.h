// The look of the 3-D view: colours and light, for a dark and a light window. Colours of surfaces and light are
// linear, those of lines and backgrounds sRGB.
#pragma once

#include <glm/glm.hpp>

namespace taxel::ui {

struct Look {
  // Background and ground, sRGB.
  glm::vec3 background_top, background_bottom;
  glm::vec4 plane_fill, grid_line;
  glm::vec3 axis_x, axis_y, axis_z;
  float shadow, skin_shadow;  // largest darkness on the ground, and of a sensor's shadow on other bodies
  // Light, linear.
  glm::vec3 key_direction;
  float key, headlight;
  glm::vec3 sky, ground;
  // The sensor's skin.
  glm::vec3 skin_albedo;
  glm::vec2 skin_front_alpha;  // opacity where the skin faces the eye, and at its outline
  float skin_back_alpha;
  glm::vec4 skin_fill, skin_outline, solid_outline;
  glm::vec4 cut_inside;  ///< inside of bodies that the clip plane cuts open and no cap closes
  glm::vec2 cut_light;   ///< brightness of caps and of their hatching
  float cut_alpha;       ///< opacity of a cap of a transparent skin
  glm::vec4 measure;
  glm::vec3 probe_albedo;
  glm::vec4 probe_outline;
  // Colours of the marks.
  glm::vec4 mark_outline;  // outline of taxels and arrows
  glm::vec4 ring_casing;   // line at the inner side of the rings of taxels
  glm::vec4 unused_sample;
  glm::vec4 ray_hit, ray_miss;
  glm::vec4 path, force, friction, selection;
  glm::vec4 ghost;             ///< contact surfaces of the previous step
  glm::vec4 hand;              ///< arrow from a grabbed body to the pointer
  glm::vec4 weld, connection;  ///< constraints between two bodies
  glm::vec4 wire;
};

const Look& look(bool dark);

/// Converts sRGB 0..1 to linear (IEC 61966-2-1).
glm::vec3 linear_from_srgb(const glm::vec3& srgb);
glm::vec3 srgb_from_linear(const glm::vec3& linear);

}  // namespace taxel::ui
