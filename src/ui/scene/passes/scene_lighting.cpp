#include "ui/scene/passes/scene_lighting.h"

#include <algorithm>
#include <cmath>

#include "ui/scene/scene_parts.h"

namespace taxel::ui {
namespace {

constexpr glm::vec3 kStudioSky{0.50f, 0.52f, 0.55f}, kStudioGround{0.24f, 0.23f, 0.22f};
constexpr float kSkyTint = 0.35f;        // part of the file's sky in the colour of the ambient light
constexpr float kBounce = 0.5f;          // part of the floor's colour in the light from below
constexpr float kMaxIrradiance = 1.45f;  // of a surface that faces all lights; more would wash out white bodies
constexpr float kSameDirection = 0.85f;  // cosine between lights that share a shadow
constexpr float kSoftShadow = 0.4f;      // of the studio's soft shadow on the ground: the lights cast shadows, too
constexpr float kFacing = 0.85f;         // mean cosine at which lights meet a surface

float brightness_of(const glm::vec3& c) {
  return glm::dot(c, glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

/// Returns a light of MuJoCo, whose colours are sums of display values, in linear light.
LitSource source_of(const SceneLight& light, const SimFrame& frame) {
  dvec3 p_W = light.p_W, direction_W = light.direction_W;
  if (const auto body = static_cast<std::size_t>(light.body); body < frame.mark_poses.bodies.size()) {
    const Pose& X_WB = frame.mark_poses.bodies[body];
    p_W = X_WB * light.p_B;
    direction_W = X_WB.rotate(light.direction_B);
  }
  LitSource source;
  source.diffuse = linear_from_srgb(light.diffuse);
  source.specular = linear_from_srgb(light.specular);
  const glm::vec3 direction(glm::normalize(direction_W));
  if (light.kind == LightKind::directional) {
    source.at = glm::vec4(-direction, 0);
    return source;
  }
  source.at = glm::vec4(glm::vec3(p_W), 1);
  if (light.kind == LightKind::spot && light.cutoff_deg < 90) {
    source.axis = glm::vec4(direction, std::cos(glm::radians(light.cutoff_deg)));
    source.exponent = light.exponent;
  }
  return source;
}

/// Returns the direction from the middle of a scene towards a light.
glm::vec3 direction_to(const LitSource& source, const Aabb& box) {
  const glm::vec3 towards = glm::vec3(source.at) - source.at.w * glm::vec3(box.empty() ? dvec3(0) : box.center());
  const float length = glm::length(towards);
  return length > 0 ? towards / length : glm::vec3(0, 0, 1);
}

struct Ranked {
  LitSource source;
  bool casts = false;
};

/// Returns the lights of the file, the brightest caster of shadows first.
std::vector<Ranked> ranked_sources(const SceneLook& look, const SimFrame& frame) {
  std::vector<Ranked> all;
  for (const SceneLight& light : look.lights) all.push_back({source_of(light, frame), light.casts_shadow});
  const auto before = [](const Ranked& a, const Ranked& b) {
    if (a.casts != b.casts) return a.casts;
    return brightness_of(a.source.diffuse) > brightness_of(b.source.diffuse);
  };
  std::stable_sort(all.begin(), all.end(), before);
  return all;
}

/// Sets the colours of the sky and the ambient light.
void set_ambient(const SceneLook& look, const glm::vec3& floor, SceneLighting& lighting) {
  glm::vec3 ambient(0);
  if (look.headlight) ambient += look.headlight->ambient;
  for (const SceneLight& light : look.lights) ambient += light.ambient;
  ambient = linear_from_srgb(glm::min(ambient, glm::vec3(1)));
  glm::vec3 tint(1);
  if (look.sky) {
    const int face = look.sky->width;  // faces in OpenGL's order; MuJoCo's third one is above
    lighting.sky_high = mean_color(*look.sky, 2 * face, 3 * face);
    lighting.sky_low = mean_color(*look.sky, face / 2 - 1, face / 2 + 1);
    const glm::vec3 color = linear_from_srgb(0.5f * (lighting.sky_high + lighting.sky_low));
    const float peak = std::max({color.x, color.y, color.z});
    if (peak > 0) tint = glm::mix(glm::vec3(1), color / peak, kSkyTint);
  }
  lighting.sky = kStudioSky * tint + ambient;
  lighting.ground = glm::mix(kStudioGround, floor, kBounce) + ambient;
}

/// Dims all lights together, so that a surface that faces them is not washed out.
void dim_together(SceneLighting& lighting) {
  float sum = 0;
  for (const LitSource& source : lighting.sources) sum += kFacing * brightness_of(source.diffuse);
  const float room = std::max(kMaxIrradiance - brightness_of(lighting.sky), 0.3f);
  if (sum <= room) return;
  for (LitSource& source : lighting.sources) {
    source.diffuse *= room / sum;
    source.specular *= room / sum;
  }
}

}  // namespace

glm::vec3 mean_color(const SceneTexture& image, int first, int last) {
  constexpr int kMaxSamples = 64;  // along each side: the mean is computed in each frame
  first = std::max(first, 0);
  last = std::min(last, image.height);
  const int down = std::max((last - first) / kMaxSamples, 1), along = std::max(image.width / kMaxSamples, 1);
  const auto channels = static_cast<std::size_t>(image.channels), width = static_cast<std::size_t>(image.width);
  glm::vec3 sum(0);
  int count = 0;
  for (int row = first; row < last; row += down) {
    for (int column = 0; column < image.width; column += along, ++count) {
      const std::uint8_t* p =
          &image.pixels[channels * (static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column))];
      sum += channels >= 3 ? glm::vec3(p[0], p[1], p[2]) : glm::vec3(p[0]);
    }
  }
  return count == 0 ? sum : sum / (255.0f * static_cast<float>(count));
}

SceneLighting scene_lighting(const SceneInput& input, const Look& look, const glm::vec3& floor) {
  const SceneLook& file = *input.frame->scene->look;
  SceneLighting lighting;
  std::vector<Ranked> ranked = ranked_sources(file, *input.frame);
  if (ranked.empty()) {
    LitSource key;
    key.at = glm::vec4(glm::normalize(look.key_direction), 0);
    key.diffuse = key.specular = glm::vec3(look.key);
    ranked.push_back({key, true});
  }
  const std::size_t room = kMaxLights - (file.headlight ? 1 : 0);
  set_ambient(file, floor, lighting);
  for (const Ranked& light : ranked) {
    if (lighting.sources.size() < room) {
      lighting.sources.push_back(light.source);
    } else {
      lighting.sky += 0.25f * light.source.diffuse;
    }
  }
  const Aabb box = scene_bounds(input);
  lighting.shadow_direction = direction_to(lighting.sources.front(), box);
  const auto shares = [&](const LitSource& source) {
    return ranked.front().casts && glm::dot(direction_to(source, box), lighting.shadow_direction) > kSameDirection;
  };
  lighting.key_count = static_cast<int>(
      std::stable_partition(lighting.sources.begin(), lighting.sources.end(), shares) - lighting.sources.begin());
  if (file.headlight) {
    LitSource head;
    head.at = glm::vec4(0, 0, 0, kAtEye);
    head.diffuse = linear_from_srgb(file.headlight->diffuse);
    head.specular = linear_from_srgb(file.headlight->specular);
    lighting.sources.push_back(head);
  }
  dim_together(lighting);
  return lighting;
}

Look lit_look(const Look& look, const SceneLighting& lighting) {
  Look lit = look;
  lit.shadow *= kSoftShadow;
  lit.key_direction = lighting.shadow_direction;
  lit.sky = lighting.sky;
  lit.ground = lighting.ground;
  lit.key = 0;
  lit.headlight = 0;
  for (const LitSource& source : lighting.sources)
    (source.at.w == kAtEye ? lit.headlight : lit.key) += brightness_of(source.diffuse);
  return lit;
}

}  // namespace taxel::ui
