// The path of the finger, and the line between the points of the measure tool.
#include "ui/scene/marks/marks.h"

namespace taxel::ui {
namespace {

constexpr float kPathTowardEye = 0.004f, kPointsTowardEye = 0.005f, kHiddenPathDim = 0.28f;  // as in sensor_marks.cpp
constexpr float kPathWidth = 2.2f, kStraightWidth = 1.0f, kMeasureDiameter = 7, kSelectedWayPoint = 1.5f;

void draw_way_points(const ShownPath& path, const Look& look, PointPass& points) {
  std::vector<PointMark> marks;
  for (std::size_t i = 0; i < path.points_W.size(); ++i) {
    const bool selected = static_cast<int>(i) == path.selected;
    marks.push_back(point_mark(path.points_W[i], dvec3(0), selected ? kSelectedWayPoint : 1.0,
                               pack(selected ? look.selection : look.path)));
  }
  const PointStyle dots{.diameter = kMeasureDiameter, .outline = look.mark_outline, .outline_width = 1.2f};
  points.draw(marks, dots, {.toward_eye = kPointsTowardEye, .hidden = true, .dim = kHiddenPathDim});
  points.draw(marks, dots, {.toward_eye = kPointsTowardEye});
}

}  // namespace

std::vector<dvec3> drawn_path(const SceneInput& input) {
  if (!input.overlays.path || !input.frame || !input.frame->scene) return {};
  return input.path ? input.path->line_W : input.frame->scene->path_W;
}

void draw_path_marks(const SceneInput& input, const Look& look, SegmentPass& segments, PointPass& points) {
  if (!input.overlays.path || !input.frame || !input.frame->scene) return;
  const std::vector<dvec3> path = drawn_path(input);
  Segments lines;
  for (std::size_t i = 1; i < path.size(); ++i)
    lines.push_back(segment(path[i - 1], path[i], kPathWidth, pack(look.path)));
  segments.draw_lines(lines, {.toward_eye = kPathTowardEye, .hidden = true, .dim = kHiddenPathDim});
  segments.draw_lines(lines, {.toward_eye = kPathTowardEye});
  if (input.path) draw_way_points(*input.path, look, points);
}

void draw_measure_marks(const SceneInput& input, const Look& look, SegmentPass& segments, PointPass& points) {
  const std::uint32_t color = pack(look.measure);
  Segments lines;
  if (const MeasuredPtr& measured = input.measured) {
    const std::vector<dvec3>& path = measured->path;
    for (std::size_t i = 1; i < path.size(); ++i) lines.push_back(segment(path[i - 1], path[i], kPathWidth, color));
    lines.push_back(segment(measured->request.a, measured->request.b, kStraightWidth, color));
  }
  std::vector<PointMark> ends;
  for (const dvec3& p : input.measure_points) ends.push_back(point_mark(p, dvec3(0), 1.0, color));
  const PointStyle dots{.diameter = kMeasureDiameter, .outline = look.mark_outline, .outline_width = 1.2f};
  MarkState state{.toward_eye = kPointsTowardEye, .hidden = true, .dim = kHiddenPathDim};
  segments.draw_lines(lines, state);
  state = {.toward_eye = kPointsTowardEye};
  segments.draw_lines(lines, state);
  points.draw(ends, dots, state);
}

}  // namespace taxel::ui
