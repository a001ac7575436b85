#include "ui/scene/scene_labels.h"

#include <fmt/format.h>

#include "ui/scene/draw/model_marks.h"
#include "ui/scene/scene_cast.h"
#include "ui/scene/sensor_view.h"

namespace taxel::ui {
namespace {

constexpr double kPastTip = 9;       // [pixel]
constexpr double kTolerance = 4e-3;  // of the distance: what lies on a body is not hidden by it

bool hidden(const SceneInput& input, const SensorView& view, const dvec3& eye_W, const dvec3& p_W) {
  const double distance = glm::length(p_W - eye_W);
  const Ray ray{eye_W, (p_W - eye_W) / distance, (1 - kTolerance) * distance};
  if (cast_geoms(input, ray)) return true;
  return !input.overlays.sensor_transparent && view.model->skin->cast(in_frame(view.X_WM, ray)).has_value();
}

}  // namespace

std::vector<SceneLabel> scene_labels(const SceneInput& input, const Camera& camera, int width, int height) {
  if (!input.overlays.taxel_labels) return {};
  std::vector<std::pair<double, SceneLabel>> found;
  const dvec3 eye = camera.eye();
  for (const SensorView& view : sensor_views(input)) {
    const double length = taxel_arrow_length(*view.model);
    for (int k = 0; k < view.model->taxel_count(); ++k) {
      const Taxel& taxel = view.model->layout.taxels[static_cast<std::size_t>(k)];
      const dvec3 center = view.X_WM * taxel.center, normal = view.X_WM.rotate(glm::normalize(taxel.normal));
      const dvec3 base = camera.project(center, width, height);
      const dvec3 tip = camera.project(center + length * normal, width, height);
      if (base.z <= 0 || tip.z <= 0) continue;
      const dvec2 along(tip - base);
      const double pixels = glm::length(along);
      const dvec2 direction = pixels > 1 ? along / pixels : dvec2(0, -1);
      SceneLabel label;
      label.text = fmt::format("{}", taxel.id);
      label.pixel = dvec2(tip) + kPastTip * direction;
      if (label.pixel.x < 0 || label.pixel.y < 0 || label.pixel.x > width || label.pixel.y > height) continue;
      label.occluded = glm::dot(normal, eye - center) <= 0 || hidden(input, view, eye, center);
      label.selected = view.selected(k);
      label.sensor = view.index;
      label.taxel = k;
      found.emplace_back(tip.z, std::move(label));
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<SceneLabel> out;
  for (auto& [depth, label] : found) out.push_back(std::move(label));
  return out;
}

}  // namespace taxel::ui
