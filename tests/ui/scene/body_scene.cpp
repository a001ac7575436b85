#include "ui/scene/body_scene.h"

namespace taxel::test {

ui::SceneInput bodies(const std::vector<PlacedBody>& placed) {
  auto scene = std::make_shared<SimScene>();
  auto frame = std::make_shared<SimFrame>();
  for (const PlacedBody& body : placed) {
    SceneGeom& geom = scene->geoms.emplace_back();
    geom.name = geom.body = "body";
    geom.mesh = body.mesh;
    geom.rgba = kBodyColor;
    frame->geom_poses.push_back(body.X_WG);
  }
  frame->scene = scene;
  ui::SceneInput input;
  input.frame = frame;
  input.overlays.grid = false;
  return input;
}

TriMeshPtr joined(const TriMesh& a, const TriMesh& b, const dvec3& shift, bool cavity) {
  std::vector<dvec3> vertices = a.vertices();
  std::vector<ivec3> faces = a.faces();
  for (const dvec3& v : b.vertices()) vertices.push_back(v + shift);
  for (const ivec3& f : b.faces()) {
    const ivec3 moved = f + ivec3(a.vertex_count());
    faces.push_back(cavity ? ivec3(moved.x, moved.z, moved.y) : moved);
  }
  return std::make_shared<const TriMesh>(vertices, faces);
}

}  // namespace taxel::test
