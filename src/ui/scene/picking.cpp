#include "ui/scene/picking.h"

#include <algorithm>

#include "core/base/math.h"
#include "core/mesh/query/triangle.h"
#include "ui/scene/scene_parts.h"

namespace taxel::ui {
namespace {

constexpr double kDepthTolerance = 4e-3;  // fraction of the distance; marks on a body are drawn in front of it

/// The pointer in one frame.
struct Pointer {
  const SceneInput& input;
  const Camera& camera;
  dvec2 at;
  int width, height;
  double reach;
  Ray ray_W;
  double solid;  ///< distance at which solid bodies end the ray [m]

  /// Returns the tolerance of a distance along the ray [m].
  [[nodiscard]] double slack(double distance) const { return kDepthTolerance * camera.depth_scale(distance); }
};

/// Picks the nearest taxel centre that faces the eye and is not behind a solid body.
void pick_taxel(const Pointer& p, const SensorView& view, double& nearest, Pick& out) {
  for (int k = 0; k < view.model->taxel_count(); ++k) {
    if (view.hidden(k)) continue;
    const Taxel& taxel = view.model->layout.taxels[static_cast<std::size_t>(k)];
    const dvec3 center = view.X_WM * taxel.center;
    if (glm::dot(view.X_WM.rotate(taxel.normal), p.ray_W.origin - center) <= 0) continue;
    if (p.input.clip && p.input.clip->hides(center)) continue;
    const dvec3 pixel = p.camera.project(center, p.width, p.height);
    const double away = glm::length(dvec2(pixel) - p.at), distance = glm::length(center - p.ray_W.origin);
    if (pixel.z <= 0 || away > nearest || distance - p.slack(distance) > p.solid) continue;
    nearest = away;
    out.sensor = view.index;
    out.taxel = k;
    out.position_W = center;
    out.distance = distance;
  }
}

/// Picks the nearest contact polygon of a sensor before `t_max`. Returns true if there is one.
bool pick_polygon(const SensorView& view, const Ray& ray_M, double t_max, Pick& out) {
  if (view.state == nullptr) return false;
  const RayTriangleTest test(ray_M);
  bool found = false;
  for (std::size_t s = 0; s < view.state->surfaces.size(); ++s) {
    const ContactSurface& surface = view.state->surfaces[s];
    for (std::size_t i = 0; i < surface.polygons.size(); ++i) {
      const ContactPolygon& polygon = surface.polygons[i];
      const auto vertex = [&](int v) { return surface.vertices[static_cast<std::size_t>(polygon.first + v)]; };
      for (int v = 2; v < polygon.count; ++v) {
        const auto hit = test(vertex(0), vertex(v - 1), vertex(v), t_max);
        if (!hit) continue;
        t_max = hit->t;
        found = true;
        out.sensor = view.index;
        out.surface = static_cast<int>(s);
        out.polygon = static_cast<int>(i);
        out.distance = hit->t;
        const dvec3 at = ray_M.origin + hit->t * ray_M.direction;
        out.pressure = std::max(0.0, polygon.pressure + glm::dot(polygon.gradient, at - polygon.centroid));
      }
    }
  }
  return found;
}

/// Picks the skin under the pointer and its nearest sample. Returns true if the skin is nearer than `t_max`.
bool pick_skin(const Pointer& p, const SensorView& view, const Ray& ray_M, double t_max, Pick& out) {
  const auto hit = view.model->skin->cast(ray_M);
  if (!hit || hit->t > t_max) return false;
  const dvec3 at = ray_M.origin + hit->t * ray_M.direction;
  out.sensor = view.index;
  out.distance = hit->t;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < view.model->samples.size(); ++i) {
    const SurfaceSample& sample = view.model->samples[i];
    const double squared = glm::dot(sample.position - at, sample.position - at);
    if (squared >= nearest || glm::dot(sample.normal, ray_M.direction) >= 0) continue;
    nearest = squared;
    out.sample = static_cast<int>(i);
  }
  if (out.sample < 0) return true;
  const dvec3 sample_W = view.X_WM * view.model->samples[static_cast<std::size_t>(out.sample)].position;
  if (glm::length(dvec2(p.camera.project(sample_W, p.width, p.height)) - p.at) > p.reach) out.sample = -1;
  return true;
}

}  // namespace

std::optional<Pick> pick(const SceneInput& input, const Camera& camera, double x, double y, int width, int height,
                         double reach) {
  const Ray ray = camera.pixel_ray(x, y, width, height);
  const auto shown = shown_part(input.clip, ray);
  auto solid = shown ? cast_geoms(input, shown->ray) : std::nullopt;
  if (solid) solid->t += shown->moved;
  const double end = solid ? solid->t : std::numeric_limits<double>::infinity();
  const Pointer pointer{input, camera, {x, y}, width, height, reach, ray, end};
  const std::vector<SensorView> views = sensor_views(input);

  Pick taxel, contact, skin;
  double nearest_taxel = reach, nearest_contact = end + pointer.slack(end), nearest_skin = end;
  bool on_contact = false, on_skin = false;
  for (const SensorView& view : views) {
    const Ray ray_M = in_frame(view.X_WM, ray);
    if (input.overlays.taxels) pick_taxel(pointer, view, nearest_taxel, taxel);
    if (input.overlays.contact_surface && pick_polygon(view, ray_M, nearest_contact, contact)) {
      nearest_contact = contact.distance;
      on_contact = true;
    }
    if (!shown) continue;
    const Ray shown_M = in_frame(view.X_WM, shown->ray);
    if (pick_skin(pointer, view, shown_M, nearest_skin - shown->moved, skin)) {
      skin.distance += shown->moved;
      nearest_skin = skin.distance;
      on_skin = true;
    }
  }
  if (taxel.taxel >= 0) return taxel;
  const bool seen = input.overlays.sensor_transparent || nearest_contact <= nearest_skin + pointer.slack(nearest_skin);
  Pick result;
  if (on_contact && seen) {
    result = contact;
  } else if (on_skin) {
    result = skin;
  } else if (solid) {
    result.geom = solid->geom;
    result.geom_name = input.frame->scene->geoms[static_cast<std::size_t>(solid->geom)].shown_name();
    result.distance = solid->t;
  } else {
    return std::nullopt;
  }
  result.position_W = ray.origin + result.distance * ray.direction;
  return result;
}

namespace {

/// Returns the normal with which a sample at `p` is compared: that of the taxel, or of the subtaxel with the smallest
/// Euclidean distance.
dvec3 normal_for(const Taxel& taxel, const dvec3& p) {
  const auto nearer = [&](const Subtaxel& a, const Subtaxel& b) {
    return glm::distance(a.center, p) < glm::distance(b.center, p);
  };
  const auto best = std::min_element(taxel.subtaxels.begin(), taxel.subtaxels.end(), nearer);
  return glm::normalize(best == taxel.subtaxels.end() ? taxel.normal : best->normal);
}

}  // namespace

std::vector<SampleUse> uses_of_sample(const SensorModel& model, int sample) {
  std::vector<SampleUse> uses;
  const SurfaceSample& at = model.samples[static_cast<std::size_t>(sample)];
  for (const int k : model.taxels_of_sample[static_cast<std::size_t>(sample)]) {
    const auto row = static_cast<std::size_t>(k);
    const auto begin = model.fields.entries.begin() + model.fields.first[row];
    const auto end = model.fields.entries.begin() + model.fields.first[row + 1];
    const auto entry = std::lower_bound(begin, end, sample, [](const auto& e, int s) { return e.sample < s; });
    if (entry == end || entry->sample != sample) continue;
    const double angle = angle_deg(at.normal, normal_for(model.layout.taxels[row], at.position));
    uses.push_back({k, entry->distance, angle, entry->weight});
  }
  return uses;
}

}  // namespace taxel::ui
