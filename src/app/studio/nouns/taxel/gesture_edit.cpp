#include "app/studio/nouns/taxel/gesture_edit.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "ui/scene/scene_parts.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

namespace {

/// Snapping steps while Ctrl is held; a tenth of each with Shift.
constexpr double kMoveStep = 1e-3, kTurnStepDeg = 5, kRadiusStep = 0.5e-3;  // [m], [degrees], [m]
constexpr double kFine = 0.1;
/// Smallest distance of the pointer from the centre [pixels]. Nearer to the centre, angles and ratios are imprecise.
constexpr double kLeastArm = 20;
constexpr double kLeastRatio = 0.02;

double snapped(double value, double step, const GestureInput& input) {
  if (!input.snap) return value;
  const double size = input.precise ? kFine * step : step;
  return size * std::round(value / size);
}

dvec3 axis_vector(int axis) {
  dvec3 v(0);
  v[axis] = 1;
  return v;
}

char axis_name(int axis) {
  return static_cast<char>('X' + axis);
}

/// Returns the changed taxels as one edit.
Edit edit_of(const ToolState& tool, const std::vector<Taxel>& taxels) {
  if (tool.adds) return AddTaxels{taxels, std::nullopt};
  SetTaxels set;
  for (std::size_t i = 0; i < taxels.size(); ++i) {
    const Taxel &before = tool.start[i], &after = taxels[i];
    TaxelChange change;
    change.id = after.id;
    if (after.center != before.center) change.center = after.center;
    if (after.normal != before.normal) change.normal = after.normal;
    if (after.radius != before.radius) change.radius = after.radius;
    set.changes.push_back(change);
  }
  return set;
}

void put_on(Taxel& taxel, const MeshIndex& skin, const SurfacePlace& place) {
  const SurfacePlace from = place_near(skin, taxel.center);
  taxel.normal = turned_with(taxel.normal, from.normal, place.normal);
  taxel.center = place.position;
}

/// Moves the active taxel to the pointer. The other taxels move by the same vector and back to the surface.
GestureEdit slide(const ToolState& tool, const GestureView& view) {
  const Taxel& active = tool.start.back();
  if (tool.input.pointer == tool.pointer_start) return {edit_of(tool, tool.start), "0.00 mm"};
  const dvec2 pixel = view.pixel_of(active.center) + tool.input.pointer - tool.pointer_start;
  std::optional<SurfacePlace> place = place_under(*view.skin, view.ray_M(pixel), !view.faces_eye(active));
  if (!place) return {};
  if (tool.input.snap) place = nearest_corner(*view.skin, *place);
  const dvec3 delta = place->position - active.center;
  std::vector<Taxel> taxels = tool.start;
  for (Taxel& taxel : taxels) put_on(taxel, *view.skin, place_near(*view.skin, taxel.center + delta));
  taxels.back() = active;
  put_on(taxels.back(), *view.skin, *place);
  return {edit_of(tool, taxels), fmt::format("{:.2f} mm along the surface", 1e3 * glm::length(delta))};
}

GestureEdit move_along(const ToolState& tool, const GestureView& view, int axis) {
  const double distance = distance_along(tool.input, tool.pointer_start, view, tool.start.back().center, axis);
  std::vector<Taxel> taxels = tool.start;
  for (Taxel& taxel : taxels) taxel.center += distance * axis_vector(axis);
  return {edit_of(tool, taxels), along_text(distance, axis)};
}

GestureEdit turn(const ToolState& tool, const GestureView& view, std::optional<double> typed) {
  const int axis = tool.input.axis;
  const dvec3 eye_M = view.X_WM.inverse() * view.camera.eye(), center = tool.start.back().center;
  const dvec3 sight = glm::normalize(eye_M - center), about = axis < 0 ? sight : axis_vector(axis);
  // The pointer goes around the centre; rows of pixels run downward, and an axis may point away from the eye.
  const dvec2 at = view.pixel_of(center);
  const auto angle = [&](const dvec2& pointer) { return std::atan2(at.y - pointer.y, pointer.x - at.x); };
  const double pulled = std::remainder(angle(tool.input.pointer) - angle(tool.pointer_start), 2 * glm::pi<double>());
  const double seen = glm::degrees(glm::dot(about, sight) < 0 ? -pulled : pulled);
  const double degrees = typed ? *typed : snapped(seen, kTurnStepDeg, tool.input);
  std::vector<Taxel> taxels = tool.start;
  for (Taxel& taxel : taxels)
    if (degrees != 0) taxel.normal = turned_about(taxel.normal, about, glm::radians(degrees));
  return {edit_of(tool, taxels), axis < 0 ? fmt::format("{:.2f}\u00b0", degrees)
                                          : fmt::format("{:.2f}\u00b0 about {}", degrees, axis_name(axis))};
}

GestureEdit resize(const ToolState& tool, const GestureView& view, std::optional<double> typed) {
  const dvec2 at = view.pixel_of(tool.start.back().center);
  const double arm = std::max(kLeastArm, glm::length(tool.pointer_start - at));
  const double pulled = glm::length(tool.input.pointer - at) - glm::length(tool.pointer_start - at);
  const double ratio = std::max(kLeastRatio, 1 + pulled / arm);
  std::vector<Taxel> taxels = tool.start;
  for (Taxel& taxel : taxels) {
    if (typed) {
      taxel.radius = shifted_decimal(*typed, -3);
    } else if (pulled != 0) {
      taxel.radius = std::max(snapped(ratio * taxel.radius, kRadiusStep, tool.input), kLeastRatio * taxel.radius);
    }
  }
  return {edit_of(tool, taxels), fmt::format("radius {:.3f} mm", 1e3 * taxels.back().radius)};
}

}  // namespace

Ray GestureView::ray_M(const dvec2& pixel) const {
  return in_frame(X_WM, camera.pixel_ray(pixel.x, pixel.y, width, height));
}

dvec2 GestureView::pixel_of(const dvec3& p_M) const {
  return {camera.project(X_WM * p_M, width, height)};
}

bool GestureView::faces_eye(const Taxel& taxel) const {
  return glm::dot(X_WM.rotate(taxel.normal), camera.eye() - X_WM * taxel.center) > 0;
}

std::optional<double> typed_number(const std::string& typed) {
  double value = 0;
  const char* const end = typed.data() + typed.size();
  const auto [at, error] = std::from_chars(typed.data(), end, value);
  if (error != std::errc() || at != end) return std::nullopt;
  return value;
}

double distance_along(const GestureInput& input, const dvec2& pointer_start, const GestureView& view, const dvec3& p_M,
                      int axis) {
  if (const std::optional<double> typed = typed_number(input.typed)) return shifted_decimal(*typed, -3);
  const dvec2 at = view.pixel_of(p_M);
  const auto along = [&](const dvec2& pointer) {
    return along_line(p_M, axis_vector(axis), view.ray_M(at + pointer - pointer_start));
  };
  return snapped_length(along(input.pointer) - along(pointer_start), input);
}

double snapped_length(double metres, const GestureInput& input) {
  return snapped(metres, kMoveStep, input);
}

std::string along_text(double metres, int axis) {
  return fmt::format("{:.3f} mm along {}", 1e3 * metres, axis_name(axis));
}

GestureEdit gesture_edit(const ToolState& tool, const GestureView& view) {
  if (tool.start.empty() || view.skin == nullptr) return {};
  const std::optional<double> typed = typed_number(tool.input.typed);
  switch (tool.tool) {
    case Tool::slide:
      return slide(tool, view);
    case Tool::move:
      if (tool.input.axis < 0 && !typed) return slide(tool, view);
      return move_along(tool, view, std::max(0, tool.input.axis));
    case Tool::turn:
      return turn(tool, view, typed);
    case Tool::resize:
      return resize(tool, view, typed);
    default:
      return {};
  }
}

}  // namespace taxel::ui
