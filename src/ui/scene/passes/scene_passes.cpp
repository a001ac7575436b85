#include "ui/scene/passes/scene_passes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ui/scene/scene_parts.h"

namespace taxel::ui {
namespace {

constexpr GLuint kKeyUnit = 1, kImageUnit = 2, kMirrorUnit = 3, kSkyUnit = 4;
constexpr int kFloorVertices = 6 * 32 * 32;  // of the cells in floor.vert
constexpr double kFloorReach = 40;           // distances of the camera at which an infinite plane ends
constexpr float kSkinTowardEye = 5e-4f;  // of the depth, by which a skin is drawn nearer than a body that it touches
constexpr float kBehind = 0.3f;          // opacity of a plane that is seen from behind, as in MuJoCo's viewer

const SceneMaterial& material_of(const SceneMaterial* material) {
  static const SceneMaterial without;
  return material != nullptr ? *material : without;
}

/// Returns the matrix that reflects the world in the plane z = 0 of P.
glm::mat4 reflection_in(const Pose& X_WP) {
  const glm::mat4 X = matrix(X_WP);
  glm::mat4 flip(1);
  flip[2][2] = -1;
  return X * flip * matrix(X_WP.inverse());
}

bool is_behind(const Pose& X_WP, const dvec3& eye) {
  return (X_WP.inverse() * eye).z < 0;
}

/// Returns the mean colour of a plane's surface, linear.
glm::vec3 floor_color(const std::vector<FloorItem>& floors) {
  if (floors.empty()) return glm::vec3(0.15f);
  glm::vec3 color(floors.front().base);
  const SceneMaterial& material = material_of(floors.front().material);
  if (material.texture && !material.texture->cube)
    color *= linear_from_srgb(mean_color(*material.texture, 0, material.texture->height));
  return color;
}

std::vector<FloorItem> floors_of(const SceneInput& input) {
  std::vector<FloorItem> floors;
  const SimScene& scene = *input.frame->scene;
  for (std::size_t i = 0; i < scene.geoms.size() && i < input.frame->geom_poses.size(); ++i) {
    const SceneGeom& geom = scene.geoms[i];
    if (!geom.plane || !shows(input.overlays, geom)) continue;
    FloorItem floor{input.frame->geom_poses[i], geom.material.get()};
    floor.base = glm::vec4(linear_from_srgb({geom.rgba[0], geom.rgba[1], geom.rgba[2]}), geom.rgba[3]);
    floor.half_size = {geom.plane_size[0], geom.plane_size[1]};
    floors.push_back(floor);
  }
  return floors;
}

}  // namespace

glm::vec4 finish_of(const SceneMaterial& material) {
  const float exponent = 128 * std::clamp(material.shininess, 0.0f, 1.0f);
  float roughness = std::sqrt(std::sqrt(2 / (exponent + 2)));  // alpha^2 = 2 / (n + 2) of Blinn's exponent n
  if (material.specular <= 0) roughness = 1;
  if (material.roughness >= 0) roughness = material.roughness;
  return {std::clamp(roughness, 0.05f, 1.0f), 0.08f * std::clamp(material.specular, 0.0f, 1.0f),
          std::clamp(material.metallic, 0.0f, 1.0f), std::max(material.emission, 0.0f)};
}

glm::vec4 repeat_of(const SceneMaterial& material, const dvec2& half_size) {
  if (!material.texture || material.texture->cube) return glm::vec4(0);
  glm::vec2 scale = material.repeat;
  for (int i = 0; i < 2; ++i)
    if (!material.uniform && half_size[i] > 0) scale[i] /= static_cast<float>(half_size[i]);
  return {0.5f * scale.x, -0.5f * scale.y, -0.5f, -0.5f};
}

const gl::ImageTexture& TextureCache::get(const SceneTexturePtr& texture, bool linear) {
  Entry& entry = entries_[texture];
  if (!entry.image) {
    const auto kind = texture->cube ? gl::ImageTexture::Kind::cube : gl::ImageTexture::Kind::flat;
    entry.image = std::make_unique<gl::ImageTexture>(kind, texture->width, texture->height, texture->channels,
                                                     texture->pixels, linear);
  }
  entry.used = true;
  return *entry.image;
}

void TextureCache::end_frame() {
  std::erase_if(entries_, [](const auto& entry) { return !entry.second.used; });
  for (auto& [texture, entry] : entries_) entry.used = false;
}

ScenePass::ScenePass(const gl::ShaderReader& read, int key_texels)
    : body_(read, "body"),
      touched_(read, "body.vert", "touched_body.frag"),
      textured_(read, "textured"),
      touched_textured_(read, "textured.vert", "touched_textured.frag"),
      floor_(read, "floor"),
      plain_floor_(read, "floor.vert", "plain_floor.frag"),
      sky_(read, "screen.vert", "sky.frag"),
      shadow_(read, key_texels) {
  for (const gl::Program* program : {&textured_, &touched_textured_, &floor_})
    program->set("image", static_cast<int>(kImageUnit));
  floor_.set("mirrored", static_cast<int>(kMirrorUnit));
  sky_.set("sky", static_cast<int>(kSkyUnit));
}

void ScenePass::begin(const SceneInput& input, const Look& look) {
  file_ = input.frame->scene->look.get();
  floors_ = floors_of(input);
  lighting_ = scene_lighting(input, look, floor_color(floors_));
  mirror_ = -1;
}

void ScenePass::make_shadow(const MeshPass& meshes, const MeshList& list, const Aabb& box_W) {
  shadow_.make(box_W, box_W, lighting_.shadow_direction,
               [&](const gl::Program& program) { meshes.draw_casters(program, list, GL_BACK); });
}

void ScenePass::use_lights(const gl::Program& program) const {
  for (std::size_t i = 0; i < lighting_.sources.size(); ++i) {
    const LitSource& source = lighting_.sources[i];
    const auto set = [&](const char* member, const auto& value) {
      program.set(fmt::format("lights[{}].{}", i, member).c_str(), value);
    };
    set("at", source.at);
    set("axis", source.axis);
    set("diffuse", glm::vec4(source.diffuse, source.exponent));
    set("specular", source.specular);
  }
  program.set("light_count", static_cast<int>(lighting_.sources.size()));
  program.set("key_count", lighting_.key_count);
  program.set("key_direction", lighting_.shadow_direction);
  const LitSource& last = lighting_.sources.back();
  program.set("head_specular", last.at.w == kAtEye ? last.specular : glm::vec3(0));
  shadow_.use(program, kKeyUnit);
}

void ScenePass::set_item(const gl::Program& program, const MeshItem& item) {
  program.set("world_from_mesh", matrix(item.X_WM));
  program.set("base", glm::vec4(item.albedo, item.alpha));
  program.set("finish", finish_of(material_of(item.material)));
  program.set("toward_eye", item.sensor ? kSkinTowardEye : 0.0f);
  if (item.mesh->has_texture()) textures_.get(item.material->texture, true).bind(kImageUnit);
}

void ScenePass::begin_bodies(const gl::Program& program, bool clipped, const glm::vec4& inside,
                             const std::vector<glm::vec4>& contacts) const {
  set_clipped(clipped);
  program.set("clipped", clipped ? 1.0f : 0.0f);
  program.set("inside", inside);
  use_lights(program);
  use_contacts(program, contacts);
  program.use();
}

namespace {

void draw_whole(const MeshItem& item, const Camera& camera, bool clipped) {
  if (clipped || item.touched || may_be_within(item, camera)) {
    item.mesh->draw();
  } else {
    item.mesh->draw_without(GL_BACK);
  }
}

bool has_texture(const MeshItem& item) {
  return item.mesh->has_texture();
}

}  // namespace

void ScenePass::draw_parts(const MeshList& list, const Camera& camera, const glm::vec4& inside, bool clipped,
                           bool opaque) {
  const gl::Program* const programs[2][2] = {{&body_, &textured_}, {&touched_, &touched_textured_}};
  for (const bool touched : {false, true}) {
    if (!touched && !opaque) continue;  // only touched bodies have transparent parts
    for (const bool textured : {false, true}) {
      const auto is_drawn = [&](const MeshItem& item) {
        return item.touched == touched && has_texture(item) == textured;
      };
      if (std::none_of(list.solids.begin(), list.solids.end(), is_drawn)) continue;
      const gl::Program& program = *programs[touched ? 1 : 0][textured ? 1 : 0];
      begin_bodies(program, clipped, inside, list.contacts);
      program.set("opaque", opaque ? 1.0f : 0.0f);
      for (const MeshItem& item : list.solids) {
        if (!is_drawn(item)) continue;
        set_item(program, item);
        draw_whole(item, camera, clipped);
      }
    }
  }
  set_clipped(false);
}

void ScenePass::draw_solids(const MeshList& list, const Camera& camera, const Look& look, bool clipped) {
  gl::apply({});
  draw_parts(list, camera, clipped ? look.cut_inside : glm::vec4(0), clipped, true);
}

void ScenePass::draw_touched(const MeshList& list, const Camera& camera, const Look& look, bool clipped) {
  gl::apply({.depth_write = false, .blend = true});
  draw_parts(list, camera, clipped ? look.cut_inside : glm::vec4(0), clipped, false);
}

void ScenePass::draw_glass(std::vector<MeshItem> items, const Camera& camera, bool clipped) {
  if (items.empty()) return;
  const dvec3 direction_W = glm::normalize(camera.target - camera.eye());
  const auto depth = [&](const MeshItem& item) {
    return glm::dot(direction_W, item.X_WM * item.mesh->mesh().bounds().center());
  };
  std::stable_sort(items.begin(), items.end(),
                   [&](const MeshItem& a, const MeshItem& b) { return depth(a) > depth(b); });
  gl::apply({.depth_write = false, .blend = true});
  if (std::any_of(items.begin(), items.end(), has_texture)) begin_bodies(textured_, clipped, glm::vec4(0), {});
  begin_bodies(body_, clipped, glm::vec4(0), {});
  for (const MeshItem& item : items) {
    const gl::Program& program = has_texture(item) ? textured_ : body_;
    program.use();
    set_item(program, item);
    item.mesh->draw_blended(glm::vec3(item.X_WM.inverse().rotate(direction_W)));
  }
  set_clipped(false);
}

void ScenePass::make_reflection(const MeshList& list, const Camera& camera, const FrameUniforms& frame, int width,
                                int height) {
  for (std::size_t i = 0; i < floors_.size() && mirror_ < 0; ++i)
    if (material_of(floors_[i].material).reflectance > 0 && !is_behind(floors_[i].X_WP, camera.eye()))
      mirror_ = static_cast<int>(i);
  if (mirror_ < 0) return;
  const int w = std::max(width / 2, 1), h = std::max(height / 2, 1);
  if (!mirrored_ || mirrored_->width() != w || mirrored_->height() != h) {
    mirrored_.reset();
    mirrored_.emplace(w, h);
  }
  const Pose& X_WP = floors_[static_cast<std::size_t>(mirror_)].X_WP;
  const glm::mat4 reflect = reflection_in(X_WP);
  FrameUniforms seen = frame;
  seen.view_from_world = frame.view_from_world * reflect;
  const glm::vec4 eye = reflect * glm::vec4(glm::vec3(frame.eye), 1);
  seen.eye = glm::vec4(glm::vec3(eye), frame.eye.w);
  const glm::vec3 up(X_WP.rotate({0, 0, 1}));
  seen.clip_plane = glm::vec4(up, -glm::dot(up, glm::vec3(X_WP.p)));  // nothing below the plane is reflected
  bind_frame(mirrored_frame_, seen);
  mirrored_->bind();
  glClearColor(0, 0, 0, 0);
  glClearDepth(1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glFrontFace(GL_CW);
  gl::apply({});
  if (std::any_of(list.solids.begin(), list.solids.end(), has_texture)) begin_bodies(textured_, true, glm::vec4(0), {});
  begin_bodies(body_, true, glm::vec4(0), {});
  for (const auto* items : {&list.solids, &list.skins}) {
    for (const MeshItem& item : *items) {
      if (!item.casts) continue;
      const gl::Program& program = has_texture(item) ? textured_ : body_;
      program.use();
      set_item(program, item);
      item.mesh->draw_without(GL_BACK);
    }
  }
  set_clipped(false);
  glFrontFace(GL_CCW);
}

void ScenePass::draw_floor(const FloorItem& floor, const Camera& camera, bool mirrors) {
  const SceneMaterial& material = material_of(floor.material);
  const bool behind = is_behind(floor.X_WP, camera.eye()), textured = material.texture && !material.texture->cube;
  const gl::Program& program = textured || mirrors ? floor_ : plain_floor_;
  glm::vec4 base = floor.base;
  if (behind) base.w *= kBehind;
  const dvec3 target = floor.X_WP.inverse() * camera.target;
  const double reach = kFloorReach * camera.distance;
  dvec2 middle(0), half(floor.half_size);
  for (int k = 0; k < 2; ++k)
    if (!(half[k] > 0)) middle[k] = target[k], half[k] = reach;
  const bool infinite = half.x == reach || half.y == reach;
  program.set("world_from_ground", matrix(floor.X_WP));
  program.set("box", glm::vec4(glm::vec2(middle), glm::vec2(half)));
  program.set("middle", glm::vec2(glm::clamp((dvec2(target) - middle) / half, dvec2(-0.9), dvec2(0.9))));
  program.set("base", base);
  program.set("finish", finish_of(material));
  program.set("repeat", repeat_of(material, floor.half_size));
  program.set("fade", glm::vec4(target.x, target.y, infinite ? 1 / reach : 0, 0));
  program.set("haze", glm::vec4(file_->haze, file_->sky && infinite ? 1 : 0));
  program.set("reflectance", mirrors ? std::clamp(material.reflectance, 0.0f, 1.0f) : 0.0f);
  if (textured) textures_.get(material.texture, true).bind(kImageUnit);
  if (mirrors) {
    glActiveTexture(GL_TEXTURE0 + kMirrorUnit);
    glBindTexture(GL_TEXTURE_2D, mirrored_->texture());
  }
  program.use();
  const bool fades = infinite && !file_->sky;
  gl::apply({.depth_write = base.w >= 1, .blend = base.w < 1 || fades});
  glDrawArrays(GL_TRIANGLES, 0, kFloorVertices);
}

void ScenePass::draw_floors(const Camera& camera) {
  if (floors_.empty()) return;
  for (const gl::Program* program : {&floor_, &plain_floor_}) {
    use_lights(*program);
    program->set("clipped", 0.0f);
    program->set("sky_high", lighting_.sky_high);
    program->set("sky_low", lighting_.sky_low);
  }
  empty_.bind();
  for (std::size_t i = 0; i < floors_.size(); ++i) {
    const bool mirrors = mirror_ == static_cast<int>(i) && !is_behind(floors_[i].X_WP, camera.eye());
    draw_floor(floors_[i], camera, mirrors);
  }
}

bool ScenePass::draw_sky(const Camera& camera, int height) {
  if (!file_->sky || !file_->sky->cube) return false;
  gl::apply({.depth = GL_LEQUAL, .depth_write = false});
  const bool infinite = std::any_of(floors_.begin(), floors_.end(), [](const FloorItem& floor) {
    return !(floor.half_size.x > 0) || !(floor.half_size.y > 0);
  });
  sky_.set("haze", glm::vec4(file_->haze, infinite ? 1 : 0));
  const double tangent = std::tan(0.5 * glm::radians(camera.fov_deg));
  sky_.set("level", static_cast<float>(std::log2(std::max(file_->sky->width * tangent / height, 1.0))));
  sky_.set("tangent", static_cast<float>(tangent));
  textures_.get(file_->sky, false).bind(kSkyUnit);
  sky_.use();
  empty_.bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  return true;
}

}  // namespace taxel::ui
