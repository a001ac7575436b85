#include "ui/scene/section.h"

#include <fmt/format.h>

#include <array>
#include <map>
#include <optional>

#include "core/mesh/tri_mesh.h"

namespace taxel::ui {
namespace {

constexpr double kMissedRayLength = 0.3;  // length of a miss as a fraction of the allowed depth
constexpr double kSameSide = 1e-9;        // tolerance as a fraction of the sensor's size
constexpr double kMinSine = 0.2;          // two directions span a plane when they differ by more than some 12 degrees

/// Returns the direction in which the sensor travels, or the direction of the finger without a path.
dvec3 travel_direction(const SceneInput& input, const SensorView& view) {
  if (input.frame && input.frame->scene && input.frame->scene->path_W.size() > 1) {
    // The direction to the farthest point is used, because many paths end at their start.
    const std::vector<dvec3>& path = input.frame->scene->path_W;
    dvec3 d(0);
    for (const dvec3& p : path)
      if (glm::length(p - path.front()) > glm::length(d)) d = p - path.front();
    if (glm::length(d) > 0) return glm::normalize(d);
  }
  return view.X_WM.rotate(view.model->layout.frame.distal);
}

SectionPlane plane_through(const dvec3& origin_W, const dvec3& normal_W, const dvec3& travel_W) {
  SectionPlane plane;
  plane.origin_W = origin_W;
  plane.z = glm::normalize(normal_W);
  dvec3 up = dvec3(0, 0, 1) - plane.z.z * plane.z;
  if (glm::length(up) < kMinSine) up = glm::cross(plane.z, travel_W);  // a level plane has no upward direction
  plane.y = glm::normalize(up);
  plane.x = glm::cross(plane.y, plane.z);
  if (glm::dot(plane.x, travel_W) < 0) {
    plane.z = -plane.z;
    plane.x = -plane.x;
  }
  return plane;
}

SectionPlane section_plane(const SceneInput& input, const SensorView& view) {
  const dvec3 travel = travel_direction(input, view);
  const SensorFrame& frame = view.model->layout.frame;
  const dvec3 distal = view.X_WM.rotate(frame.distal), width = glm::cross(distal, view.X_WM.rotate(frame.pad));
  if (view.selected_taxel >= 0) {
    const Taxel& taxel = view.model->layout.taxels[static_cast<std::size_t>(view.selected_taxel)];
    const dvec3 normal = view.X_WM.rotate(glm::normalize(taxel.normal));
    for (const dvec3& along : {travel, distal, width}) {
      const dvec3 across = glm::cross(normal, along);
      if (glm::length(across) > kMinSine) return plane_through(view.X_WM * taxel.center, across, travel);
    }
  }
  dvec3 middle = view.model->mesh->bounds().center();
  if (view.state != nullptr) middle = center_of_pressure(*view.state).value_or(middle);
  return plane_through(view.X_WM * middle, width, travel);
}

/// Returns the area of a polygon, positive if it is counter-clockwise (shoelace formula).
double enclosed_area(const std::vector<dvec2>& p) {
  double twice = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const dvec2& a = p[i];
    const dvec2& b = p[i + 1 < p.size() ? i + 1 : 0];
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * twice;
}

/// Cuts a convex polygon by the plane at the points where its outline changes sides. Corners within `tolerance` of the
/// plane count as on the plane, so that neighbouring polygons, whose corners are separate, agree on the side.
void cut_polygon(const ContactSurface& surface, const ContactPolygon& polygon, const SectionPlane& plane,
                 const Pose& X_WM, double tolerance, std::vector<Section::ContactPiece>& out) {
  const auto height = [&](const dvec3& p) {
    const double h = plane.height(p);
    return std::abs(h) <= tolerance ? 0.0 : h;
  };
  Section::ContactPiece piece;
  int ends = 0;
  for (int i = 0; i < polygon.count && ends < 2; ++i) {
    const auto a = static_cast<std::size_t>(polygon.first + i);
    const auto b = static_cast<std::size_t>(polygon.first + (i + 1 < polygon.count ? i + 1 : 0));
    const dvec3 p = X_WM * surface.vertices[a], q = X_WM * surface.vertices[b];
    const double hp = height(p), hq = height(q);
    if ((hp < 0) == (hq < 0)) continue;
    const double s = hp / (hp - hq);
    (ends == 0 ? piece.a : piece.b) = plane.flat(p + s * (q - p));
    (ends == 0 ? piece.pressure_a : piece.pressure_b) =
        surface.pressure[a] + s * (surface.pressure[b] - surface.pressure[a]);
    ++ends;
  }
  if (ends == 2) out.push_back(piece);
}

void add_rays(const SensorView& view, double slab, Section& out) {
  const SensorModel& model = *view.model;
  std::vector<char> wanted(model.rays.size(), view.selected_taxel < 0 ? 1 : 0);
  if (view.selected_taxel >= 0) {
    const auto k = static_cast<std::size_t>(view.selected_taxel);
    for (int e = model.fields.first[k]; e < model.fields.first[k + 1]; ++e) {
      wanted[static_cast<std::size_t>(model.readout_table.ray_of_entry[static_cast<std::size_t>(e)])] = 1;
    }
  }
  const RigidTransform X(view.X_WM);
  for (std::size_t i = 0; i < model.rays.size() && i < view.state->hits.size(); ++i) {
    const SensorRay& ray = model.rays[i];
    const dvec3 origin = X(ray.origin);
    if (wanted[i] == 0 || std::abs(out.plane.height(origin)) > slab) continue;
    const RayHit& hit = view.state->hits[i];
    const bool met = hit.surface >= 0;
    const dvec3 end = X(ray.origin + (met ? hit.depth : kMissedRayLength * ray.max_depth) * ray.direction);
    out.rays.push_back({out.plane.flat(origin), out.plane.flat(end), met, hit.pressure});
  }
}

/// Looks at the contact and the rays that hit it, so closely that rays are seen: over the whole sensor they are shorter
/// than a few pixels.
void look_at_contact(Section& out) {
  constexpr double kRoom = 1.6;  // half width of the section, as a multiple of that of the contact
  std::vector<dvec2> points;
  for (const Section::ContactPiece& piece : out.contact) points.insert(points.end(), {piece.a, piece.b});
  for (const Section::RayPiece& ray : out.rays)
    if (ray.hit) points.insert(points.end(), {ray.from, ray.to});
  dvec2 low = points.front(), high = points.front();
  for (const dvec2& p : points) low = glm::min(low, p), high = glm::max(high, p);
  const double half = 0.5 * std::max(high.x - low.x, high.y - low.y);
  if (!(half > 0)) return;
  out.focus = 0.5 * (low + high);
  out.size = std::min(out.size, kRoom * half);
}

void add_samples(const SensorView& view, double slab, Section& out) {
  const RigidTransform X(view.X_WM);
  for (std::size_t i = 0; i < view.model->samples.size(); ++i) {
    const dvec3 p = X(view.model->samples[i].position);
    if (std::abs(out.plane.height(p)) > slab) continue;
    const std::vector<int>& taxels = view.model->taxels_of_sample[i];
    out.samples.push_back({out.plane.flat(p), taxels.empty() ? -1 : view.model->color(taxels.front())});
  }
}

void add_objects(const SceneInput& input, Section& out) {
  if (!input.frame || !input.frame->scene) return;
  const SimScene& scene = *input.frame->scene;
  for (std::size_t i = 0; i < scene.geoms.size() && i < input.frame->geom_poses.size(); ++i) {
    if (!scene.geoms[i].mesh || scene.geoms[i].sensor >= 0 || !shows(input.overlays, scene.geoms[i])) continue;
    const Pose& X_WG = input.frame->geom_poses[i];
    const Pose X_GW = X_WG.inverse();
    const auto pieces = slice_mesh(*scene.geoms[i].mesh, X_GW * out.plane.origin_W, X_GW.rotate(out.plane.z));
    for (auto& outline : join_outlines(pieces, out.plane, X_WG)) out.objects.push_back(std::move(outline));
  }
  for (const dvec3& p : scene.path_W) out.path.push_back(out.plane.flat(p));
}

}  // namespace

std::vector<Section::Outline> join_outlines(std::vector<std::pair<dvec3, dvec3>> pieces, const SectionPlane& plane,
                                            const Pose& X_WG) {
  // Polygons that touch the plane with only one corner give pieces without length.
  std::erase_if(pieces, [](const auto& piece) { return piece.first == piece.second; });
  const auto key = [](const dvec3& p) { return std::array<double, 3>{p.x, p.y, p.z}; };
  std::multimap<std::array<double, 3>, std::size_t> by_start;
  for (std::size_t i = 0; i < pieces.size(); ++i) by_start.emplace(key(pieces[i].first), i);
  std::map<std::array<double, 3>, int> ends;  // pieces that end at a point; open outlines begin where this is 0
  for (const auto& piece : pieces) ++ends[key(piece.second)];
  std::vector<char> used(pieces.size(), 0);
  std::vector<Section::Outline> out;
  const auto follow = [&](std::size_t first) {
    Section::Outline outline;
    std::optional<std::size_t> next = first;
    outline.points.push_back(plane.flat(X_WG * pieces[first].first));
    while (next) {
      used[*next] = 1;
      const dvec3& end = pieces[*next].second;
      outline.closed = key(end) == key(pieces[first].first);
      if (!outline.closed) outline.points.push_back(plane.flat(X_WG * end));
      next.reset();
      const auto [lo, hi] = by_start.equal_range(key(end));
      for (auto it = lo; it != hi && !outline.closed; ++it) {
        if (used[it->second] == 0) next = it->second;
      }
    }
    if (outline.closed) outline.area = enclosed_area(outline.points);
    out.push_back(std::move(outline));
  };
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (used[i] == 0 && !ends.contains(key(pieces[i].first))) follow(i);
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (used[i] == 0) follow(i);
  }
  return out;
}

Section make_section(const SceneInput& input, const SensorView& view, double slab) {
  Section out;
  out.plane = section_plane(input, view);
  const Pose X_MW = view.X_WM.inverse();
  const auto pieces = slice_mesh(*view.model->mesh, X_MW * out.plane.origin_W, X_MW.rotate(out.plane.z));
  out.skin = join_outlines(pieces, out.plane, view.X_WM);
  add_objects(input, out);
  add_samples(view, slab, out);
  if (view.state != nullptr) {
    const double tolerance = kSameSide * view.model->mesh->bounds().diagonal();
    for (const ContactSurface& surface : view.state->surfaces) {
      for (const ContactPolygon& p : surface.polygons) {
        cut_polygon(surface, p, out.plane, view.X_WM, tolerance, out.contact);
      }
    }
    add_rays(view, slab, out);
  }
  const auto samples = static_cast<double>(std::max<std::size_t>(view.model->samples.size(), 1));
  out.spacing = std::sqrt(view.model->sampled_area / samples);
  out.size = 0.55 * view.model->mesh->bounds().diagonal();
  out.focus = out.plane.flat(view.X_WM * view.model->mesh->bounds().center());
  out.title = "along the finger";
  if (!out.contact.empty()) {
    out.title = "through the contact";
    look_at_contact(out);
  }
  if (view.selected_taxel >= 0) {
    const Taxel& taxel = view.model->layout.taxels[static_cast<std::size_t>(view.selected_taxel)];
    out.taxel = view.selected_taxel;
    out.color = view.model->color(out.taxel);
    out.normal = {glm::dot(view.X_WM.rotate(glm::normalize(taxel.normal)), out.plane.x),
                  glm::dot(view.X_WM.rotate(glm::normalize(taxel.normal)), out.plane.y)};
    out.radius = taxel.radius;
    out.focus = {0, 0};
    out.size = 1.7 * taxel.radius;
    out.title = fmt::format("through taxel {}", taxel.id);
  }
  return out;
}

}  // namespace taxel::ui
