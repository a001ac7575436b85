#include "ui/scene/scene_renderer.h"

#include <optional>

#include "ui/gl/framebuffer.h"
#include "ui/gl/offscreen_context.h"
#include "ui/scene/marks/marks.h"
#include "ui/scene/paint/gpu_mesh.h"
#include "ui/scene/passes/passes.h"
#include "ui/scene/passes/scene_passes.h"

namespace taxel::ui {
namespace {

constexpr int kHardwareSamples = 4;
constexpr int kKeyTexels = 2048, kSoftwareKeyTexels = 512;             // texels along each side of the key light's map
constexpr int kSceneKeyTexels = 2048, kSoftwareSceneKeyTexels = 1024;  // the same for scenes with a look
constexpr int kMaxFacesInSoftware = 120'000;  // largest number of faces of a mesh, for smooth orbiting

constexpr double kOcclusionRadius = 0.05;  // as a fraction of the object's size

/// The input that decides the content of a frame.
struct RenderKey {
  SceneInput input;
  Camera camera;
  int width = 0, height = 0;
  bool operator==(const RenderKey&) const = default;
};

/// The input that decides the shadows. They remain valid while only the camera moves.
struct ShadowKey {
  std::vector<PlacedMesh> places;  // places of the casters; the one without a mesh is the ground
  glm::vec3 light{0};
  bool has_look = false;  ///< the scene casts the shadow of its own first light
  bool operator==(const ShadowKey&) const = default;
};

/// Lets OpenGL process vertices and draw no pixels.
class DrawNothing {
 public:
  explicit DrawNothing(bool on) : on_(on) {
    if (on_) glEnable(GL_RASTERIZER_DISCARD);
  }
  ~DrawNothing() {
    if (on_) glDisable(GL_RASTERIZER_DISCARD);
  }
  DrawNothing(const DrawNothing&) = delete;
  DrawNothing& operator=(const DrawNothing&) = delete;

 private:
  bool on_;
};

/// Restores the bound framebuffer and the viewport.
class KeepTarget {
 public:
  KeepTarget() {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer_);
    glGetIntegerv(GL_VIEWPORT, viewport_);
  }
  ~KeepTarget() {
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(framebuffer_));
    glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
    glBindVertexArray(0);
    glUseProgram(0);
  }
  KeepTarget(const KeepTarget&) = delete;
  KeepTarget& operator=(const KeepTarget&) = delete;

 private:
  GLint framebuffer_ = 0;
  GLint viewport_[4] = {};
};

/// Returns whether the materials, lights and sky of a user's file are known.
bool has_look(const SceneInput& input) {
  return input.frame && input.frame->scene && input.frame->scene->look;
}

/// Returns the box within which the bodies of a scene shade each other: a room around a robot would leave few texels
/// of the map of shadows for the robot.
Aabb shadowed_box(const SceneInput& input) {
  constexpr double kExtents = 1.5;
  Aabb box = scene_bounds(input);
  const SceneOverview& overview = input.frame->scene->marks.overview;
  const Aabb near{overview.center_W - kExtents * overview.extent, overview.center_W + kExtents * overview.extent};
  if (!(overview.extent > 0) || !box.overlaps(near)) return box;
  box.lo = glm::max(box.lo, near.lo);
  box.hi = glm::min(box.hi, near.hi);
  return box;
}

RenderEffort effort_of_driver() {
  return gl::software_renderer() ? RenderEffort::software : RenderEffort::gpu;
}

}  // namespace

struct SceneRenderer::Impl {
  Impl(const gl::ShaderReader& shaders, RenderEffort effort)
      : software(effort == RenderEffort::software),
        ground(shaders),
        meshes(shaders, software ? kSoftwareKeyTexels : kKeyTexels),
        scene(shaders, software ? kSoftwareSceneKeyTexels : kSceneKeyTexels),
        cuts(shaders),
        occlusion(shaders),
        occluded(!software),
        segments(shaders),
        points(shaders),
        sensors(shaders),
        cache(software ? kMaxFacesInSoftware : 0) {}

  bool software;
  GroundPass ground;
  Backdrop backdrop;
  MeshPass meshes;
  ScenePass scene;
  CutPass cuts;
  AmbientOcclusion occlusion;
  bool occluded;
  SegmentPass segments;
  PointPass points;
  SensorMarks sensors;
  MeshCache cache;
  gl::Buffer frame_buffer, pixel_buffer;
  std::optional<gl::Framebuffer> target;
  std::optional<RenderKey> last;
  std::optional<ShadowKey> shadows;
  bool on_request = false;  ///< whether render() only prepares frames
  bool prepared = false;    ///< whether `last` was only prepared

  void make_shadows(const SceneInput& input, const MeshList& list, const Ground& floor, const Look& look);
  void make_scene_shadows(const SceneInput& input, const MeshList& list, const Ground& floor, const Look& look);
  void clear_target(bool background) const;
  void make_target(int width, int height, bool clipped);
  void draw_scene(const SceneInput& input, const Camera& camera, const Look& look, bool background = true);
  void draw_overlay(const Camera& camera, const Look& look, double scale);
  void draw(const RenderKey& key);
  void draw_user_scene(const SceneInput& input, const Camera& camera, const Look& look, bool background);
  void draw_marks(const SceneInput& input, const Camera& camera, const Look& look, const MeshList& list);
  void end_frame() {
    cache.end_frame();
    scene.end_frame();
    cuts.end_frame();
  }
};

void SceneRenderer::Impl::make_shadows(const SceneInput& input, const MeshList& list, const Ground& floor,
                                       const Look& look) {
  ShadowKey key{casters_of(list), look.key_direction};
  key.places.push_back({{}, floor.X_WP});
  if (shadows && *shadows == key) return;
  const Aabb box = scene_bounds(input), sensors_box = sensor_bounds(input);
  ground.make_shadow(floor, box, [&](const gl::Program& program) { meshes.draw_casters(program, list, GL_FRONT); });
  meshes.make_shadow(sensors_of(input, cache), sensors_box);
  meshes.make_key_shadow(list, box, sensors_box, look);
  shadows = std::move(key);
}

/// Does the same for a scene with a look, whose shadow is that of its first light.
void SceneRenderer::Impl::make_scene_shadows(const SceneInput& input, const MeshList& list, const Ground& floor,
                                             const Look& look) {
  ShadowKey key{casters_of(list), look.key_direction, true};
  key.places.push_back({{}, floor.X_WP});
  if (shadows && *shadows == key) return;
  const Aabb box = shadowed_box(input);
  ground.make_shadow(floor, box, [&](const gl::Program& program) { meshes.draw_casters(program, list, GL_FRONT); });
  scene.make_shadow(meshes, list, box);
  shadows = std::move(key);
}

void SceneRenderer::Impl::clear_target(bool background) const {
  target->bind();
  glClearColor(0, 0, 0, background ? 1.0f : 0.0f);
  glClearDepth(1);
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void SceneRenderer::Impl::draw_scene(const SceneInput& input, const Camera& camera, const Look& look, bool background) {
  if (has_look(input)) return draw_user_scene(input, camera, look, background);
  const MeshList list = mesh_list(input, look, cache);
  set_clipped(false);
  const SceneGround plane = scene_ground(input);
  const Ground floor{plane.X_WP, plane.plane};
  if (!prepared) make_shadows(input, list, floor, look);

  clear_target(background);
  bind_frame(frame_buffer, perspective_frame(camera, look, target->width(), target->height(), input.scale, input.clip));
  glEnable(GL_PROGRAM_POINT_SIZE);
  const bool keep_backdrop = background && software && !floor.filled && !prepared;
  if (keep_backdrop) backdrop.fill(*target, ground, floor, camera, look, input.overlays.grid, input.scale, segments);
  meshes.draw_solids(list, camera, look, input.clip.has_value());
  if (occluded && !prepared) {
    const Aabb object = sensor_bounds(input);
    occlusion.draw(*target, kOcclusionRadius * (object.empty() ? scene_bounds(input) : object).diagonal());
  }
  if (background && !keep_backdrop) {
    ground.draw_background(look);
    ground.draw(floor, camera, look, input.overlays.grid, segments);
  }
  if (background) ground.draw_shadow(floor, look);
  meshes.draw_outlines(list.solids, camera, segments, input.clip.has_value());
  draw_marks(input, camera, look, list);
}

/// Draws cuts, the transparent parts of touched objects, transparent skins, and all marks. A touched object is drawn
/// over the marks on opaque skins behind it, and before transparent skins, which are usually in front of it.
void SceneRenderer::Impl::draw_marks(const SceneInput& input, const Camera& camera, const Look& look,
                                     const MeshList& list) {
  const bool clipped = input.clip.has_value(), skins_first = list.skins.empty();
  const auto draw_touched = [&] {
    has_look(input) ? scene.draw_touched(list, camera, look, clipped)
                    : meshes.draw_touched(list, camera, look, clipped);
  };
  if (!skins_first) draw_touched();
  if (clipped) cuts.draw(list.solids, 1, *input.clip, camera, look, segments);
  meshes.draw_skins(list, camera, look, clipped);
  meshes.draw_outlines(list.skins, camera, segments, clipped);
  if (input.overlays.wireframe) meshes.draw_wires(list, look, segments, clipped);
  if (clipped) cuts.draw(list.skins, look.cut_alpha, *input.clip, camera, look, segments);
  sensors.draw_on_skin(input, camera, look, target->height(), segments, points);
  if (skins_first) draw_touched();
  sensors.draw_above(input, camera, look, target->height(), segments, points);
  draw_frame_marks(input, look, segments);
  draw_hand_marks(input, camera, look, segments, points);
  set_clipped(false);
}

/// Draws a user's scene with the materials, lights, planes and sky of its file.
void SceneRenderer::Impl::draw_user_scene(const SceneInput& input, const Camera& camera, const Look& studio,
                                          bool background) {
  const MeshList list = mesh_list(input, studio, cache);
  set_clipped(false);
  scene.begin(input, studio);
  const Look look = lit_look(studio, scene.lighting());
  const SceneGround plane = scene_ground(input);
  const Ground floor{plane.X_WP, plane.plane};
  const bool grid = background && input.overlays.scene_grid, clipped = input.clip.has_value();
  if (!prepared) make_scene_shadows(input, list, floor, look);
  const FrameUniforms frame =
      perspective_frame(camera, look, target->width(), target->height(), input.scale, input.clip);
  if (background && !prepared) scene.make_reflection(list, camera, frame, target->width(), target->height());
  clear_target(background);
  bind_frame(frame_buffer, frame);
  glEnable(GL_PROGRAM_POINT_SIZE);
  scene.draw_solids(list, camera, look, clipped);
  if (occluded && !prepared) occlusion.draw(*target, kOcclusionRadius * scene_bounds(input).diagonal());
  if (background) {
    scene.draw_floors(camera);
    if (!scene.draw_sky(camera, target->height())) ground.draw_background(studio);
    if (grid) ground.draw({floor.X_WP, false}, camera, look, true, segments);
    if (floor.filled || grid) ground.draw_shadow(floor, look);
  }
  scene.draw_glass(list.glass, camera, clipped);
  std::vector<MeshItem> selected;
  std::copy_if(list.solids.begin(), list.solids.end(), std::back_inserter(selected),
               [](const MeshItem& item) { return item.selected; });
  meshes.draw_outlines(selected, camera, segments, clipped);
  draw_marks(input, camera, look, list);
}

/// Creates the framebuffer and sets GL's state. Only cuts need a stencil.
void SceneRenderer::Impl::make_target(int width, int height, bool clipped) {
  if (!target || target->width() != width || target->height() != height || target->stencil() != clipped) {
    target.reset();
    target.emplace(width, height, software ? 0 : kHardwareSamples, clipped);
  }
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_STENCIL_TEST);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

void SceneRenderer::Impl::draw_overlay(const Camera& camera, const Look& look, double scale) {
  const int width = target->width(), height = target->height();
  bind_frame(pixel_buffer, pixel_frame(width, height, scale));
  draw_gizmo(segments, points, camera, look, dvec2(width, height) / scale);
}

/// Draws a frame, or only prepares it.
void SceneRenderer::Impl::draw(const RenderKey& key) {
  const KeepTarget keep;
  last.reset();  // an unfinished frame must not be reused
  const SceneInput& input = key.input;
  make_target(key.width, key.height, input.clip.has_value());
  const Look& colors = look(input.dark);
  {
    const DrawNothing nothing(prepared);
    draw_scene(input, key.camera, colors);
    if (!prepared && input.has_gizmo) draw_overlay(key.camera, colors, input.scale);
  }
  if (!prepared) target->resolve();
  glFlush();  // a software renderer draws the frame while the panels are laid out
  end_frame();
}

SceneRenderer::SceneRenderer(const gl::ShaderReader& shaders, std::optional<RenderEffort> effort)
    : impl_(std::make_unique<Impl>(shaders, effort.value_or(effort_of_driver()))) {}
SceneRenderer::~SceneRenderer() = default;

void SceneRenderer::render(const SceneInput& input, const Camera& camera, int width, int height) {
  RenderKey key{input, camera, std::max(width, 1), std::max(height, 1)};
  if (impl_->last && *impl_->last == key) return;
  impl_->prepared = impl_->on_request;
  impl_->draw(key);
  impl_->last = std::move(key);
}

void SceneRenderer::draw_prepared() const {
  if (!impl_->last || !impl_->prepared) return;
  impl_->prepared = false;
  RenderKey key = std::move(*impl_->last);
  impl_->draw(key);
  impl_->last = std::move(key);
}

void SceneRenderer::set_draws_on_request(bool on) {
  impl_->on_request = on;
}

gl::RgbaImage SceneRenderer::cut_out(const SceneInput& input, const Camera& camera, int width, int height) {
  const KeepTarget keep;
  impl_->last.reset();
  impl_->prepared = false;
  impl_->make_target(std::max(width, 1), std::max(height, 1), input.clip.has_value());
  impl_->draw_scene(input, camera, look(input.dark), false);
  impl_->target->resolve();
  impl_->end_frame();
  return impl_->target->read_with_alpha();
}

gl::RgbImage SceneRenderer::image(const SceneInput& input, const Camera& camera, int width, int height,
                                  const std::function<void()>& draw_over) {
  const KeepTarget keep;
  impl_->last.reset();
  impl_->prepared = false;
  impl_->make_target(std::max(width, 1), std::max(height, 1), input.clip.has_value());
  impl_->draw_scene(input, camera, look(input.dark));
  impl_->target->resolve();
  impl_->target->bind_resolved();
  draw_over();
  impl_->end_frame();
  return impl_->target->read();
}

unsigned SceneRenderer::texture() const {
  return impl_->target ? impl_->target->texture() : 0;
}
gl::RgbImage SceneRenderer::picture() const {
  draw_prepared();
  return impl_->target ? impl_->target->read() : gl::RgbImage{};
}
FieldNumbers SceneRenderer::field_numbers() const {
  return impl_->last ? impl_->sensors.numbers() : FieldNumbers{};
}
RenderEffort SceneRenderer::effort() const {
  return impl_->software ? RenderEffort::software : RenderEffort::gpu;
}

void SceneRenderer::set_ambient_occlusion(bool on) {
  impl_->occluded = on;
  impl_->last.reset();
}

}  // namespace taxel::ui
