// The lit bodies of a scene.
#include "ui/scene/passes/passes.h"

#include <fmt/format.h>

#include "ui/gl/program.h"
#include "ui/scene/paint/mark_pass.h"
#include "ui/scene/scene_parts.h"

namespace taxel::ui {
namespace {

constexpr float kOutlineWidth = 1.5f, kCreaseWidth = 1.2f, kWireWidth = 1.0f, kSelectedWidth = 3.0f;
constexpr float kSeenThrough = 0.3f;          // of the alpha of lines that shine through
constexpr std::size_t kMaxCasts = 3000;       // for longer outlines no ray is cast
constexpr double kGrazing = 0.03;             // of the skin's size: how far before its outline a ray may touch it
constexpr float kEdgeTowardEye = 0.004f;      // edges in front of their faces
constexpr double kObjectShadowHeight = 0.14;  // of the sensors' size, at which their shadow is a third as dark

/// Returns true if the skin clearly hides a point of its own outline.
bool lies_behind(const MeshIndex& skin, const dvec3& eye, const dvec3& p) {
  const double distance = glm::length(p - eye), nearer = distance - kGrazing * skin.mesh().bounds().diagonal();
  return nearer > 0 && skin.cast({eye, (p - eye) / distance, nearer}).has_value();
}

/// Outlines the item if it belongs to the selected body.
void mark_selected(MeshItem& item, const SceneGeom& geom, const SceneInput& input, const Look& look) {
  item.selected = input.selected_body >= 0 && geom.body_index == input.selected_body;
  if (item.selected) item.outline = look.selection;
}

/// Returns whether a body may reach into the spheres with twice the radii of the contacts.
bool is_near(const std::vector<glm::vec4>& contacts, const TriMesh& mesh, const Pose& X_WM) {
  constexpr double kReach = 2;  // of the radius, as in shaders/near_contact.glsl
  return std::any_of(contacts.begin(), contacts.end(), [&](const glm::vec4& contact) {
    const dvec3 center = X_WM.inverse() * dvec3(contact);
    const dvec3 nearest = glm::clamp(center, mesh.bounds().lo, mesh.bounds().hi);
    return glm::distance(center, nearest) < kReach * static_cast<double>(contact.w);
  });
}

/// Adds the sites. They only mark places, so they cast no shadow, and transparent sites hide nothing.
void add_sites(const SceneInput& input, const Look& look, MeshCache& cache, MeshList& list) {
  for (const SceneSite& site : input.frame->scene->marks.sites) {
    const std::optional<Pose> X_WS = site_pose(*input.frame, site);
    if (!X_WS || !shows(input.overlays, site)) continue;
    const glm::vec3 albedo = linear_from_srgb({site.rgba[0], site.rgba[1], site.rgba[2]});
    MeshItem item{&cache.get(site.mesh), *X_WS, albedo, look.solid_outline};
    item.casts = false;
    (site.rgba[3] < 1 ? list.skins : list.solids).push_back(item);
  }
}

/// Adds the scene around the edited layout as transparent bodies that cast no shadow.
void add_surroundings(const SceneInput& input, const Look& look, MeshCache& cache, MeshList& list) {
  if (input.frame || !input.surroundings) return;
  constexpr float kOutlineAlpha = 0.35f;  // of the outlines of solid bodies
  const SimFrame& frame = *input.surroundings->frame;
  const std::vector<SceneGeom>& geoms = frame.scene->geoms;
  for (std::size_t g = 0; g < geoms.size() && g < frame.geom_poses.size(); ++g) {
    const SceneGeom& geom = geoms[g];
    if (!geom.mesh || geom.plane || geom.body_index == input.surroundings->body) continue;
    if (!input.overlays.geom_groups.at(static_cast<std::size_t>(geom.group))) continue;
    MeshItem item{&cache.get(geom.mesh), input.surroundings->X_MW * frame.geom_poses[g],
                  linear_from_srgb({geom.rgba[0], geom.rgba[1], geom.rgba[2]}), look.solid_outline};
    item.outline.a *= kOutlineAlpha;
    item.casts = false;
    list.skins.push_back(item);
  }
}

}  // namespace

bool may_be_within(const MeshItem& item, const Camera& camera) {
  const dvec3 eye = item.X_WM.inverse() * camera.eye(), around(2 * camera.near_plane());  // its corners lie farther
  return item.mesh->mesh().bounds().overlaps({eye - around, eye + around});
}

MeshList mesh_list(const SceneInput& input, const Look& look, MeshCache& cache) {
  MeshList list;
  const std::vector<SensorView> views = sensor_views(input);
  const bool transparent = !shows_opaque_skins(input);
  std::vector<MeshItem>& skins = transparent ? list.skins : list.solids;
  for (const SensorView& view : views) {
    const glm::vec3 albedo = shows_coverage(input, view.model) ? linear_from_srgb(kUncoveredColor) : look.skin_albedo;
    skins.push_back({&cache.get(view.model->mesh), view.X_WM, albedo, look.skin_outline, true,
                     transparent ? view.model->skin.get() : nullptr});
  }
  add_surroundings(input, look, cache, list);
  if (!input.frame && input.probe && input.probe->mesh) {  // transparent, because it hides the contact
    MeshItem probe{&cache.get(input.probe->mesh), input.probe->X_MG, look.probe_albedo, look.probe_outline};
    probe.casts = false;  // a tool that follows the pointer
    list.skins.push_back(probe);
  }
  if (!input.frame || !input.frame->scene) return list;
  list.contacts = contact_spheres(input, kMaxContacts);
  const SimScene& scene = *input.frame->scene;
  for (std::size_t i = 0; i < scene.geoms.size() && i < input.frame->geom_poses.size(); ++i) {
    const SceneGeom& geom = scene.geoms[i];
    const auto sensor = static_cast<std::size_t>(std::max(geom.sensor, 0));
    if (geom.sensor >= 0 && sensor < skins.size()) mark_selected(skins[sensor], geom, input, look);
    if (!geom.mesh || geom.plane || geom.sensor >= 0 || !shows(input.overlays, geom)) continue;
    const glm::vec3 albedo = linear_from_srgb({geom.rgba[0], geom.rgba[1], geom.rgba[2]});
    const TextureCoordsPtr& texture = scene.look ? geom.texture_coords : nullptr;
    MeshItem item{&cache.get(geom.mesh, texture), input.frame->geom_poses[i], albedo, look.solid_outline};
    item.material = geom.material.get();
    item.alpha = geom.rgba[3];
    const bool glass = scene.look && item.alpha < 1;
    item.casts = !glass;
    item.touched = !glass && is_near(list.contacts, *geom.mesh, item.X_WM);
    mark_selected(item, geom, input, look);
    (glass ? list.glass : list.solids).push_back(item);
  }
  add_sites(input, look, cache, list);
  return list;
}

std::vector<PlacedMesh> casters_of(const MeshList& list) {
  std::vector<PlacedMesh> out;
  for (const auto* items : {&list.solids, &list.skins}) {
    for (const MeshItem& item : *items) {
      if (item.casts) out.push_back({item.mesh->shared_mesh(), item.X_WM});
    }
  }
  return out;
}

MeshList sensors_of(const SceneInput& input, MeshCache& cache) {
  MeshList list;
  for (const SensorView& view : sensor_views(input)) {
    list.skins.push_back({&cache.get(view.model->mesh), view.X_WM, glm::vec3(0), glm::vec4(0), true});
  }
  return list;
}

MeshPass::MeshPass(const gl::ShaderReader& read, int key_texels)
    : solid_(read, "mesh.vert", "solid.frag"),
      touched_(read, "mesh.vert", "touched.frag"),
      silicone_(read, "mesh.vert", "silicone.frag"),
      skin_(read, "mesh.vert", "skin.frag"),
      caster_(read, "caster.vert", "height.frag"),
      shadow_(read),
      key_shadow_(read, key_texels) {}

void MeshPass::make_shadow(const MeshList& sensors, const Aabb& box_W) {
  if (!shadow_.begin(Pose{}, box_W, 1)) return;
  const Aabb& box = shadow_.casters();
  const double range = box.diagonal();
  caster_.set("plane", glm::vec4(0, 0, 1, -box.lo.z));
  caster_.set("range", static_cast<float>(range));
  gl::apply({.depth = GL_ALWAYS, .depth_write = false, .blend = true});
  glBlendEquation(GL_MIN);
  caster_.use();
  draw_casters(caster_, sensors, GL_FRONT);  // the lowest sensor decides
  shadow_.blur();
  for (const gl::Program* program : {&solid_, &touched_}) {  // skins cast this shadow and do not receive it
    program->set("heights_box", glm::vec4(shadow_.box().x, shadow_.box().y, 1 / shadow_.box().z, 1 / shadow_.box().w));
    program->set("heights_scale", glm::vec3(box.lo.z, range, 1.0 / (kObjectShadowHeight * range)));
  }
}

void MeshPass::make_key_shadow(const MeshList& list, const Aabb& box_W, const Aabb& sensors_W, const Look& look) {
  Aabb shown = box_W;
  if (!sensors_W.empty()) {  // a table under a finger would leave few texels for the finger
    const dvec3 around(sensors_W.diagonal());
    shown.lo = glm::max(shown.lo, sensors_W.lo - around);
    shown.hi = glm::min(shown.hi, sensors_W.hi + around);
  }
  key_shadow_.make(shown, box_W, look.key_direction,
                   [&](const gl::Program& program) { draw_casters(program, list, GL_BACK); });
}

void MeshPass::draw_casters(const gl::Program& program, const MeshList& list, GLenum hidden) const {
  for (const auto* items : {&list.solids, &list.skins}) {
    for (const MeshItem& item : *items) {
      if (!item.casts) continue;
      program.set("world_from_mesh", matrix(item.X_WM));
      item.mesh->draw_without(hidden);
    }
  }
}

void use_contacts(const gl::Program& program, const std::vector<glm::vec4>& contacts) {
  program.set("contact_count", static_cast<int>(contacts.size()));
  for (std::size_t i = 0; i < contacts.size(); ++i) program.set(fmt::format("contacts[{}]", i).c_str(), contacts[i]);
}

void MeshPass::begin_solids(const gl::Program& program, const MeshList& list, const Look& look, bool clipped) const {
  program.set("clipped", clipped ? 1.0f : 0.0f);
  program.set("inside", clipped ? look.cut_inside : glm::vec4(0));
  key_shadow_.use(program, 1);
  use_contacts(program, list.contacts);
}

void MeshPass::draw_solid(const gl::Program& program, const MeshItem& item, const Camera& camera, const Look& look,
                          bool clipped) const {
  program.use();
  program.set("world_from_mesh", matrix(item.X_WM));
  program.set("albedo", item.albedo);
  program.set("strength", item.sensor || !(shadow_.box().z > 0) ? 0.0f : look.skin_shadow);
  if (clipped || item.touched || may_be_within(item, camera)) {
    item.mesh->draw();
  } else {
    item.mesh->draw_without(GL_BACK);
  }
}

void MeshPass::draw_solids(const MeshList& list, const Camera& camera, const Look& look, bool clipped) const {
  gl::apply({});
  set_clipped(clipped);
  shadow_.bind(0);
  for (const gl::Program* program : {&solid_, &touched_, &silicone_}) begin_solids(*program, list, look, clipped);
  touched_.set("opaque", 1.0f);
  for (const MeshItem& item : list.solids)
    draw_solid(item.sensor ? silicone_ : item.touched ? touched_ : solid_, item, camera, look, clipped);
  set_clipped(false);
}

void MeshPass::draw_touched(const MeshList& list, const Camera& camera, const Look& look, bool clipped) const {
  if (std::none_of(list.solids.begin(), list.solids.end(), [](const MeshItem& item) { return item.touched; })) return;
  gl::apply({.depth_write = false, .blend = true});
  set_clipped(clipped);
  shadow_.bind(0);
  begin_solids(touched_, list, look, clipped);
  touched_.set("opaque", 0.0f);
  for (const MeshItem& item : list.solids)
    if (item.touched) draw_solid(touched_, item, camera, look, clipped);
  set_clipped(false);
}

void MeshPass::draw_skins(const MeshList& list, const Camera& camera, const Look& look, bool clipped) const {
  gl::apply({.depth_write = false, .blend = true});
  set_clipped(clipped);
  skin_.set("clipped", clipped ? 1.0f : 0.0f);
  skin_.set("front_alpha", look.skin_front_alpha);
  skin_.set("back_alpha", look.skin_back_alpha);
  skin_.use();
  for (const MeshItem& item : list.skins) {
    skin_.set("world_from_mesh", matrix(item.X_WM));
    skin_.set("albedo", item.albedo);
    const dvec3 direction_W = glm::normalize(camera.target - camera.eye());
    item.mesh->draw_blended(glm::vec3(item.X_WM.inverse().rotate(direction_W)));
  }
  set_clipped(false);
}

void MeshPass::draw_outlines(const std::vector<MeshItem>& items, const Camera& camera, SegmentPass& segments,
                             bool clipped) const {
  for (const MeshItem& item : items) {
    if (!item.mesh->has_outlines()) continue;
    const TriMesh& mesh = item.mesh->mesh();
    const std::vector<MeshEdge>& edges = item.mesh->edges();
    const dvec3 eye = item.X_WM.inverse() * camera.eye();
    const VisibleEdges visible = visible_edges(mesh, edges, eye);
    const std::uint32_t full = pack(item.outline);
    const std::uint32_t dim = pack(glm::vec4(glm::vec3(item.outline), kSeenThrough * item.outline.a));
    const float width = item.selected ? kSelectedWidth : kOutlineWidth;
    Segments lines;
    const auto vertex = [&](int v) { return mesh.vertices()[static_cast<std::size_t>(v)]; };
    for (const int i : visible.creases) {
      const MeshEdge& e = edges[static_cast<std::size_t>(i)];
      lines.push_back(segment(vertex(e.a), vertex(e.b), kCreaseWidth, item.transparent != nullptr ? dim : full));
    }
    const bool many = visible.outline.size() > kMaxCasts;
    for (const int i : visible.outline) {
      const MeshEdge& e = edges[static_cast<std::size_t>(i)];
      const bool behind = item.transparent != nullptr &&
                          (many || lies_behind(*item.transparent, eye, 0.5 * (vertex(e.a) + vertex(e.b))));
      lines.push_back(segment(vertex(e.a), vertex(e.b), width, behind ? dim : full));
    }
    segments.draw_lines(lines,
                        {.world_from_model = matrix(item.X_WM), .toward_eye = kEdgeTowardEye, .clipped = clipped});
  }
}

void MeshPass::draw_wires(const MeshList& list, const Look& look, SegmentPass& segments, bool clipped) const {
  for (const auto* items : {&list.solids, &list.skins}) {
    for (const MeshItem& item : *items) {
      segments.draw_lines(item.mesh->wires(kWireWidth, pack(look.wire)),
                          {.world_from_model = matrix(item.X_WM), .toward_eye = kEdgeTowardEye, .clipped = clipped});
    }
  }
}

}  // namespace taxel::ui
