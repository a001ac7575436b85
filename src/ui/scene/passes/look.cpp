#include "ui/scene/passes/look.h"

#include <cmath>

namespace taxel::ui {
namespace {

constexpr glm::vec4 rgba(unsigned rgb, float alpha) {
  return {static_cast<float>((rgb >> 16) & 255) / 255.0f, static_cast<float>((rgb >> 8) & 255) / 255.0f,
          static_cast<float>(rgb & 255) / 255.0f, alpha};
}
constexpr glm::vec3 opaque_color(unsigned value) {
  const glm::vec4 c = rgba(value, 1);
  return {c.x, c.y, c.z};
}

const Look kDarkLook{
    .background_top = opaque_color(0x2E3440),
    .background_bottom = opaque_color(0x191C22),
    .plane_fill = rgba(0x2A2F38, 1.0f),
    .grid_line = rgba(0x8A94A6, 0.34f),
    .axis_x = opaque_color(0xB8434E),
    .axis_y = opaque_color(0x6E9A3A),
    .axis_z = opaque_color(0x3F7FC9),
    .shadow = 0.62f,
    .skin_shadow = 0.55f,
    .key_direction = {0.42f, -0.38f, 0.82f},
    .key = 0.62f,
    .headlight = 0.22f,
    .sky = {0.34f, 0.37f, 0.42f},
    .ground = {0.13f, 0.12f, 0.11f},
    .skin_albedo = {0.74f, 0.52f, 0.40f},
    .skin_front_alpha = {0.30f, 0.78f},
    .skin_back_alpha = 0.20f,
    .skin_fill = rgba(0xD9B79C, 0.16f),
    .skin_outline = rgba(0xE9DDD2, 0.75f),
    .solid_outline = rgba(0xC6CFDA, 0.55f),
    .cut_inside = rgba(0x8A5F48, 1.0f),
    .cut_light = {0.50f, 0.22f},
    .cut_alpha = 0.72f,
    .measure = rgba(0xFFE08A, 1.0f),
    .probe_albedo = {0.40f, 0.52f, 0.66f},
    .probe_outline = rgba(0xA9C4E4, 0.75f),
    .mark_outline = rgba(0x0E1116, 0.90f),
    .ring_casing = rgba(0x1A100A, 0.60f),
    .unused_sample = rgba(0xC4B8AE, 0.16f),
    .ray_hit = rgba(0xF4F7FB, 0.55f),
    .ray_miss = rgba(0xAEB8C6, 0.16f),
    .path = rgba(0xFF3B46, 1.0f),
    .force = rgba(0xFFFFFF, 1.0f),
    .friction = rgba(0xFF6FD8, 1.0f),
    .selection = rgba(0xFFFFFF, 1.0f),
    .ghost = rgba(0xD0D8E4, 0.22f),
    .hand = rgba(0xFFB020, 1.0f),
    .weld = rgba(0xC792EA, 1.0f),
    .connection = rgba(0x5CCFE6, 1.0f),
    .wire = rgba(0xE9DDD2, 0.28f),
};

const Look kLightLook{
    .background_top = opaque_color(0xF7F9FB),
    .background_bottom = opaque_color(0xD9DFE6),
    .plane_fill = rgba(0xE4E8ED, 1.0f),
    .grid_line = rgba(0x6B7686, 0.42f),
    .axis_x = opaque_color(0xC8434E),
    .axis_y = opaque_color(0x5C8A2A),
    .axis_z = opaque_color(0x2F6FBC),
    .shadow = 0.36f,
    .skin_shadow = 0.42f,
    .key_direction = {0.42f, -0.38f, 0.82f},
    .key = 0.58f,
    .headlight = 0.20f,
    .sky = {0.46f, 0.48f, 0.51f},
    .ground = {0.24f, 0.23f, 0.22f},
    .skin_albedo = {0.68f, 0.48f, 0.37f},
    .skin_front_alpha = {0.30f, 0.80f},
    .skin_back_alpha = 0.22f,
    .skin_fill = rgba(0xB98A68, 0.20f),
    .skin_outline = rgba(0x5A4A40, 0.85f),
    .solid_outline = rgba(0x2A3038, 0.85f),
    .cut_inside = rgba(0xA87A60, 1.0f),
    .cut_light = {0.86f, 0.45f},
    .cut_alpha = 0.72f,
    .measure = rgba(0x7A4A00, 1.0f),
    .probe_albedo = {0.34f, 0.44f, 0.57f},
    .probe_outline = rgba(0x35557A, 0.85f),
    .mark_outline = rgba(0x1A1E24, 0.90f),
    .ring_casing = rgba(0x1A100A, 0.60f),
    .unused_sample = rgba(0x6E5F55, 0.20f),
    .ray_hit = rgba(0x10151C, 0.50f),
    .ray_miss = rgba(0x3A4452, 0.16f),
    .path = rgba(0xE01B2A, 1.0f),
    .force = rgba(0x14181E, 1.0f),
    .friction = rgba(0xB0218C, 1.0f),
    .selection = rgba(0x14181E, 1.0f),
    .ghost = rgba(0x30363F, 0.25f),
    .hand = rgba(0xB35C00, 1.0f),
    .weld = rgba(0x7A3FA0, 1.0f),
    .connection = rgba(0x0B6E88, 1.0f),
    .wire = rgba(0x4A3C34, 0.30f),
};

}  // namespace

const Look& look(bool dark) {
  return dark ? kDarkLook : kLightLook;
}

glm::vec3 linear_from_srgb(const glm::vec3& srgb) {
  glm::vec3 out;
  for (int i = 0; i < 3; ++i)
    out[i] = srgb[i] <= 0.04045f ? srgb[i] / 12.92f : std::pow((srgb[i] + 0.055f) / 1.055f, 2.4f);
  return out;
}

glm::vec3 srgb_from_linear(const glm::vec3& linear) {
  glm::vec3 out;
  for (int i = 0; i < 3; ++i)
    out[i] = linear[i] <= 0.0031308f ? 12.92f * linear[i] : 1.055f * std::pow(linear[i], 1 / 2.4f) - 0.055f;
  return out;
}

}  // namespace taxel::ui
