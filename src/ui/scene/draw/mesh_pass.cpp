#include "ui/scene/draw/mesh_pass.h"

#include "ui/gl/state.h"

namespace taxel::ui {
namespace {

constexpr float kOutlineWidth = 1.5f, kCreaseWidth = 1.2f, kWireWidth = 1.0f;
constexpr float kTowardEye = 0.0015f;  // edges in front of their faces

}  // namespace

MeshList mesh_list(const SceneInput& input, const Look& look, MeshCache& cache) {
  MeshList list;
  std::vector<MeshItem>& skins = input.overlays.sensor_transparent ? list.skins : list.solids;
  for (const SensorView& view : sensor_views(input)) {
    skins.push_back({&cache.get(view.model->mesh), view.X_WM, look.skin_albedo});
  }
  if (!input.frame || !input.frame->scene) return list;
  const SimScene& scene = *input.frame->scene;
  for (std::size_t i = 0; i < scene.geoms.size() && i < input.frame->geom_poses.size(); ++i) {
    const SceneGeom& geom = scene.geoms[i];
    if (!geom.mesh || geom.plane || geom.sensor >= 0) continue;
    const glm::vec3 albedo = linear_from_srgb({geom.rgba[0], geom.rgba[1], geom.rgba[2]});
    list.solids.push_back({&cache.get(geom.mesh), input.frame->geom_poses[i], albedo});
  }
  return list;
}

MeshPass::MeshPass(const gl::ShaderReader& read)
    : solid_(read, "mesh.vert", "solid.frag"), skin_(read, "mesh.vert", "skin.frag") {}

void MeshPass::draw_casters(const gl::Program& program, const MeshList& list) const {
  for (const auto* items : {&list.solids, &list.skins}) {
    for (const MeshItem& item : *items) {
      program.set("world_from_mesh", matrix(item.X_WM));
      item.mesh->draw();
    }
  }
}

void MeshPass::draw_solids(const MeshList& list) const {
  gl::apply({});
  solid_.use();
  for (const MeshItem& item : list.solids) {
    solid_.set("world_from_mesh", matrix(item.X_WM));
    solid_.set("albedo", item.albedo);
    item.mesh->draw();
  }
}

void MeshPass::draw_skins(const MeshList& list, const Camera& camera, const Look& look) const {
  gl::apply({.depth_write = false, .blend = true});
  skin_.set("front_alpha", look.skin_front_alpha);
  skin_.set("back_alpha", look.skin_back_alpha);
  skin_.use();
  for (const MeshItem& item : list.skins) {
    skin_.set("world_from_mesh", matrix(item.X_WM));
    skin_.set("albedo", item.albedo);
    const dvec3 direction_W = glm::normalize(camera.target - camera.eye());
    item.mesh->draw_sorted(glm::vec3(item.X_WM.inverse().rotate(direction_W)));
  }
}

void MeshPass::draw_outlines(const std::vector<MeshItem>& items, const Camera& camera, const glm::vec4& color,
                             SegmentPass& segments) const {
  const std::uint32_t rgba = pack(color);
  for (const MeshItem& item : items) {
    const TriMesh& mesh = item.mesh->mesh();
    const std::vector<MeshEdge>& edges = item.mesh->edges();
    const VisibleEdges visible = visible_edges(mesh, edges, item.X_WM.inverse() * camera.eye());
    Segments lines;
    const auto add = [&](const std::vector<int>& numbers, float width) {
      for (const int i : numbers) {
        const MeshEdge& e = edges[static_cast<std::size_t>(i)];
        lines.push_back(segment(mesh.vertices()[static_cast<std::size_t>(e.a)],
                                mesh.vertices()[static_cast<std::size_t>(e.b)], width, rgba));
      }
    };
    add(visible.creases, kCreaseWidth);
    add(visible.outline, kOutlineWidth);
    segments.draw_lines(lines, {.world_from_model = matrix(item.X_WM), .toward_eye = kTowardEye});
  }
}

void MeshPass::draw_wires(const MeshList& list, const Look& look, SegmentPass& segments) const {
  const std::uint32_t rgba = pack(look.wire);
  for (const auto* items : {&list.solids, &list.skins}) {
    for (const MeshItem& item : *items) {
      Segments lines;
      for (const MeshEdge& e : item.mesh->edges()) {
        lines.push_back(segment(item.mesh->mesh().vertices()[static_cast<std::size_t>(e.a)],
                                item.mesh->mesh().vertices()[static_cast<std::size_t>(e.b)], kWireWidth, rgba));
      }
      segments.draw_lines(lines, {.world_from_model = matrix(item.X_WM), .toward_eye = kTowardEye});
    }
  }
}

}  // namespace taxel::ui
