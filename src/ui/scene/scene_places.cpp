#include "ui/scene/scene_places.h"

#include <algorithm>

namespace taxel::ui {
namespace {

/// Calls visit(name, pose) for each part of one kind, except the body of the world.
template <class Visit>
void visit_bodies(const SimFrame& frame, const Visit& visit) {
  const std::vector<SceneBody>& bodies = frame.scene->controls.bodies;
  for (std::size_t b = 1; b < bodies.size() && b < frame.mark_poses.bodies.size(); ++b)
    visit(bodies[b].name, frame.mark_poses.bodies[b]);
}

template <class Visit>
void visit_geoms(const SceneInput& input, const Visit& visit) {
  const std::vector<SceneGeom>& geoms = input.frame->scene->geoms;
  for (std::size_t g = 0; g < geoms.size() && g < input.frame->geom_poses.size(); ++g)
    if (shows(input.overlays, geoms[g])) visit(geoms[g].name, input.frame->geom_poses[g]);
}

template <class Visit>
void visit_sites(const SceneInput& input, const Visit& visit) {
  for (const SceneSite& site : input.frame->scene->marks.sites) {
    const std::optional<Pose> X_WS = site_pose(*input.frame, site);
    if (X_WS && shows(input.overlays, site)) visit(site.name, *X_WS);
  }
}

template <class Visit>
void visit_joints(const SimFrame& frame, const Visit& visit) {
  for (const SceneJointPlace& joint : frame.scene->marks.joints) {
    const auto body = static_cast<std::size_t>(joint.body);
    if (body < frame.mark_poses.bodies.size()) visit(joint.name, frame.mark_poses.bodies[body] * joint.p_B);
  }
}

template <class Visit>
void visit_cameras(const SimFrame& frame, const Visit& visit) {
  const std::vector<SceneCamera>& cameras = frame.scene->marks.cameras;
  for (std::size_t c = 0; c < cameras.size() && c < frame.mark_poses.cameras.size(); ++c)
    visit(cameras[c].name, frame.mark_poses.cameras[c].p);
}

}  // namespace

std::optional<Pose> site_pose(const SimFrame& frame, const SceneSite& site) {
  const auto body = static_cast<std::size_t>(site.body);
  if (body >= frame.mark_poses.bodies.size()) return std::nullopt;
  return frame.mark_poses.bodies[body] * site.X_BS;
}

std::vector<Pose> shown_frames(const SceneInput& input) {
  std::vector<Pose> frames;
  if (!input.frame || !input.frame->scene) return frames;
  const auto add = [&](const std::string& /*name*/, const Pose& X_WF) { frames.push_back(X_WF); };
  switch (input.overlays.frames) {
    case FramesShown::none:
      break;
    case FramesShown::bodies:
      visit_bodies(*input.frame, add);
      break;
    case FramesShown::geoms:
      visit_geoms(input, add);
      break;
    case FramesShown::sites:
      visit_sites(input, add);
      break;
    case FramesShown::world:
      frames.emplace_back();
      break;
  }
  return frames;
}

std::vector<NamedPlace> labelled_places(const SceneInput& input) {
  std::vector<NamedPlace> places;
  if (!input.frame || !input.frame->scene) return places;
  const auto at = [&](const std::string& name, const dvec3& p_W) { places.push_back({&name, p_W}); };
  const auto at_origin = [&](const std::string& name, const Pose& X_WF) { at(name, X_WF.p); };
  switch (input.overlays.labels) {
    case LabelsShown::none:
      break;
    case LabelsShown::bodies:
      visit_bodies(*input.frame, at_origin);
      break;
    case LabelsShown::joints:
      visit_joints(*input.frame, at);
      break;
    case LabelsShown::geoms:
      visit_geoms(input, at_origin);
      break;
    case LabelsShown::sites:
      visit_sites(input, at_origin);
      break;
    case LabelsShown::cameras:
      visit_cameras(*input.frame, at);
      break;
  }
  return places;
}

}  // namespace taxel::ui
