// The taxels that have an arrow and an id in the view, and their discs that glow with readings.
#include <algorithm>
#include <string_view>
#include <tuple>

#include "core/layout/words.h"
#include "ui/scene/marks/marks.h"
#include "ui/scene/scene_parts.h"

namespace taxel::ui {
namespace {

constexpr double kSightTolerance = 4e-3;  // a point this close to a body, as a fraction of its distance, is visible

/// A taxel that may get an arrow. Smaller ranks come first.
struct MarkCandidate {
  std::size_t view = 0;
  int taxel = 0;
  int order = 0;       ///< 0 if the pointer is on the taxel, 1 if it is selected, 2 if it only responds
  double reading = 0;  ///< reading as a fraction of its range
  [[nodiscard]] auto rank() const { return std::tuple(order, -reading, view, taxel); }
};

double reading_part(const SceneInput& input, const SensorView& view, int taxel) {
  const auto k = static_cast<std::size_t>(taxel);
  if (view.state == nullptr || k >= view.state->readings.size() || !(input.reading_range.hi > 0)) return 0;
  return view.state->readings[k] / input.reading_range.hi;
}

std::vector<std::vector<int>> all_but_hidden(const std::vector<SensorView>& views) {
  std::vector<std::vector<int>> marked(views.size());
  for (std::size_t v = 0; v < views.size(); ++v)
    for (int k = 0; k < views[v].model->taxel_count(); ++k)
      if (!views[v].hidden(k)) marked[v].push_back(k);
  return marked;
}

}  // namespace

bool is_responding(const SceneInput& input, const SensorView& view, int taxel) {
  return reading_part(input, view, taxel) > kRespondingPart;
}

bool is_hovered(const SceneInput& input, const SensorView& view, int taxel) {
  return taxel >= 0 && input.hovered_taxel == taxel && input.hovered_sensor == view.index;
}

std::vector<std::vector<int>> marked_taxels(const SceneInput& input, const std::vector<SensorView>& views) {
  if (input.overlays.all_taxels) return all_but_hidden(views);
  std::vector<MarkCandidate> candidates;
  for (std::size_t v = 0; v < views.size(); ++v) {
    const SensorView& view = views[v];
    for (int k = 0; k < view.model->taxel_count(); ++k) {
      if (view.hidden(k)) continue;
      const int order = is_hovered(input, view, k) ? 0 : view.selected(k) ? 1 : 2;
      if (order < 2 || is_responding(input, view, k)) candidates.push_back({v, k, order, reading_part(input, view, k)});
    }
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const MarkCandidate& a, const MarkCandidate& b) { return a.rank() < b.rank(); });
  if (candidates.size() > kMaxMarkedTaxels) candidates.resize(kMaxMarkedTaxels);
  std::vector<std::vector<int>> marked(views.size());
  for (const MarkCandidate& c : candidates) marked[c.view].push_back(c.taxel);
  for (std::vector<int>& taxels : marked) std::sort(taxels.begin(), taxels.end());
  return marked;
}

Sighting sighting(const SceneInput& input, const std::vector<SensorView>& views, const SensorView& view, int taxel,
                  const dvec3& eye_W) {
  const Taxel& t = view.model->layout.taxels[static_cast<std::size_t>(taxel)];
  const dvec3 p_W = view.X_WM * (t.center + kSightLift * t.radius * glm::normalize(t.normal));
  const double distance = glm::length(p_W - eye_W);
  const Ray ray{eye_W, (p_W - eye_W) / distance, (1 - kSightTolerance) * distance};
  if (cast_geoms(input, ray)) return Sighting::hidden;
  bool behind = glm::dot(view.X_WM.rotate(t.normal), eye_W - p_W) <= 0;
  for (std::size_t v = 0; v < views.size() && !behind; ++v)
    behind = views[v].model->skin->cast(in_frame(views[v].X_WM, ray)).has_value();
  if (!behind) return Sighting::clear;
  return input.overlays.sensor_transparent ? Sighting::behind : Sighting::hidden;
}

namespace {

/// Returns whether the range of the readings, which is in the unit of the selected sensor, is valid for a sensor.
bool has_unit_of_range(const SceneInput& input, const std::vector<SensorView>& views, const SensorView& view) {
  const auto unit = [](const SensorView& of) {
    return std::string_view(reading_unit(of.model->layout.readout.aggregate));
  };
  return std::all_of(views.begin(), views.end(), [&](const SensorView& other) {
    return other.index != input.selected_sensor || unit(other) == unit(view);
  });
}

bool is_behind_another(const std::vector<SensorView>& views, const SensorView& view, int taxel, const dvec3& eye_W) {
  const Taxel& t = view.model->layout.taxels[static_cast<std::size_t>(taxel)];
  const dvec3 p_W = view.X_WM * (t.center + kSightLift * t.radius * glm::normalize(t.normal));
  const double distance = glm::length(p_W - eye_W);
  const Ray ray{eye_W, (p_W - eye_W) / distance, distance};
  return std::any_of(views.begin(), views.end(), [&](const SensorView& other) {
    return other.index != view.index && other.model->skin->cast(in_frame(other.X_WM, ray)).has_value();
  });
}

}  // namespace

DiscMarks disc_marks(const SceneInput& input, const std::vector<SensorView>& views, const SensorView& view,
                     const dvec3& eye_W, float dim) {
  DiscMarks out;
  const Overlays& show = input.overlays;
  if (!show.receptive_fields || !show.reading_discs || view.state == nullptr || !(input.reading_range.hi > 0))
    return out;
  if (!has_unit_of_range(input, views, view)) return out;
  const std::vector<double>& readings = view.state->readings;
  for (int k = 0; k < view.model->taxel_count() && k < static_cast<int>(readings.size()); ++k)
    if (readings[at(k)] > 0 && !view.hidden(k)) out.taxels.push_back(k);
  std::stable_sort(out.taxels.begin(), out.taxels.end(),
                   [&](int a, int b) { return readings[at(a)] < readings[at(b)]; });
  for (const int k : out.taxels) {
    const double reading = readings[at(k)];
    const bool behind = views.size() > 1 && is_behind_another(views, view, k, eye_W);
    const float alpha = (behind ? dim : 1.0f) * disc_alpha(reading / input.reading_range.hi);
    out.fills.push_back(pack(glm::vec4(input.reading_range.color(reading), alpha)));
  }
  return out;
}

}  // namespace taxel::ui
