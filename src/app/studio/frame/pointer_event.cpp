#include "app/studio/frame/pointer_event.h"

#include <imgui.h>

#include <cmath>

namespace taxel::ui {

static_assert(ImGuiMouseButton_Left == 0 && ImGuiMouseButton_Right == 1 && ImGuiMouseButton_Middle == 2);

PointerEvent read_pointer(const ViewPlace& place) {
  const ImGuiIO& io = ImGui::GetIO();
  PointerEvent event;
  event.at = {static_cast<double>(io.MousePos.x - place.rect.x0), static_cast<double>(io.MousePos.y - place.rect.y0)};
  event.delta = {static_cast<double>(io.MouseDelta.x), static_cast<double>(io.MouseDelta.y)};
  event.wheel = static_cast<double>(io.MouseWheel);
  event.hovered = ImGui::IsItemHovered();
  event.grabbed = ImGui::IsItemActive();
  event.any_down = ImGui::IsAnyMouseDown();
  event.ctrl = io.KeyCtrl;
  event.shift = io.KeyShift;
  event.alt = io.KeyAlt;
  for (int i = 0; i < 3; ++i) {
    ButtonState& button = event.buttons[static_cast<std::size_t>(i)];
    button.down = ImGui::IsMouseDown(i);
    button.pressed = ImGui::IsMouseClicked(i);
    button.double_pressed = ImGui::IsMouseDoubleClicked(i);
    button.released = ImGui::IsMouseReleased(i);
    button.moved = io.MouseDragMaxDistanceSqr[i] >= io.MouseDragThreshold * io.MouseDragThreshold;
  }
  return event;
}

bool is_pointer_resting() {
  return !ImGui::IsAnyMouseDown() && ImGui::IsItemHovered(ImGuiHoveredFlags_ForTooltip);
}

namespace {

/// A ray passes no more sheets than this on its way to one that looks away.
constexpr int kMostSheets = 64;
/// Sine squared of the angle below which lines count as parallel.
constexpr double kParallel = 1e-6;

dvec3 normal_of(const MeshIndex& skin, int face) {
  return skin.mesh().face_normals()[static_cast<std::size_t>(face)];
}

}  // namespace

std::optional<SurfacePlace> place_under(const MeshIndex& skin, const Ray& ray_M, bool away) {
  Ray ray = ray_M;
  int except = -1;
  for (int sheet = 0; sheet < kMostSheets; ++sheet) {
    const std::optional<MeshHit> hit = except < 0 ? skin.cast(ray) : skin.cast_except(ray, except);
    if (!hit) return std::nullopt;
    const dvec3 at = ray.origin + hit->t * ray.direction, normal = normal_of(skin, hit->face);
    // The point by its weights lies in the face to the last bits, one along the ray only to its length's.
    const TriMesh& mesh = skin.mesh();
    const dvec3& w = hit->barycentric;
    const dvec3 on_face =
        w.x * mesh.vertex(hit->face, 0) + w.y * mesh.vertex(hit->face, 1) + w.z * mesh.vertex(hit->face, 2);
    if ((glm::dot(normal, ray.direction) > 0) == away) return SurfacePlace{on_face, normal, hit->face};
    ray.origin = at;
    except = hit->face;
  }
  return std::nullopt;
}

SurfacePlace place_near(const MeshIndex& skin, const dvec3& p_M) {
  const SurfacePoint point = skin.closest_point(p_M);
  return {point.position, normal_of(skin, point.face), point.face};
}

SurfacePlace nearest_corner(const MeshIndex& skin, const SurfacePlace& place) {
  SurfacePlace best = place;
  double least = std::numeric_limits<double>::infinity();
  for (int corner = 0; corner < 3; ++corner) {
    const dvec3& vertex = skin.mesh().vertex(place.face, corner);
    const double away = glm::distance(vertex, place.position);
    if (away >= least) continue;
    least = away;
    best.position = vertex;
  }
  return best;
}

dvec3 turned_with(const dvec3& direction, const dvec3& from, const dvec3& to) {
  // Rodrigues' rotation about from x to, written without angles.
  const dvec3 v = glm::cross(from, to);
  const double c = glm::dot(from, to);
  if (1 + c < 1e-12) return -direction;
  return c * direction + glm::cross(v, direction) + glm::dot(v, direction) / (1 + c) * v;
}

dvec3 turned_about(const dvec3& direction, const dvec3& axis, double radians) {
  const double c = std::cos(radians), s = std::sin(radians);
  return c * direction + s * glm::cross(axis, direction) + (1 - c) * glm::dot(axis, direction) * axis;
}

double along_line(const dvec3& origin, const dvec3& direction, const Ray& ray) {
  const dvec3 w = origin - ray.origin;
  const double b = glm::dot(direction, ray.direction), parallel = 1 - b * b;
  if (parallel < kParallel) return 0;
  return (b * glm::dot(ray.direction, w) - glm::dot(direction, w)) / parallel;
}

}  // namespace taxel::ui
