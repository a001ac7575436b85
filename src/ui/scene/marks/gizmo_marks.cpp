// The gizmo as flat marks on the screen.
#include "ui/scene/marks/marks.h"

namespace taxel::ui {
namespace {

/// A stroke of the letters X, Y and Z, in a box of -1..1 with y up.
struct Stroke {
  int letter;
  dvec2 a, b;
};
constexpr std::array<Stroke, 8> kStrokes{{{0, {-0.75, -1}, {0.75, 1}},
                                          {0, {-0.75, 1}, {0.75, -1}},
                                          {1, {-0.75, 1}, {0, 0.05}},
                                          {1, {0.75, 1}, {0, 0.05}},
                                          {1, {0, 0.05}, {0, -1}},
                                          {2, {-0.7, 1}, {0.7, 1}},
                                          {2, {0.7, 1}, {-0.7, -1}},
                                          {2, {-0.7, -1}, {0.7, -1}}}};

}  // namespace

void draw_gizmo(SegmentPass& segments, PointPass& points, const Camera& camera, const Look& look, const dvec2& view) {
  const std::array<glm::vec3, 3> axis_color{look.axis_x, look.axis_y, look.axis_z};
  const auto flip = [&](const dvec2& pixel) { return dvec3(pixel.x, view.y - pixel.y, 0); };  // GL's rows go up
  MarkState flat;
  flat.depth_test = false;
  const dvec3 middle = flip(gizmo_center(view));
  for (const GizmoBall& ball : gizmo_balls(camera, view)) {
    const dvec3 p = flip(ball.pixel);
    const auto depth = static_cast<float>(0.5 + 0.5 * ball.toward);
    const glm::vec3 color = axis_color[static_cast<std::size_t>(ball.axis / 2)];
    const glm::vec3 shaded = glm::mix(0.55f * color + 0.45f * look.background_top, color, depth);
    PointStyle style{.diameter = static_cast<float>(2 * kGizmoBallRadius)};
    PointMark mark = point_mark(p, dvec3(0), 1.0, pack(shaded));
    if (ball.positive()) {
      const std::array<Segment, 1> shaft{segment(middle, p, 2.2f, pack(shaded))};
      segments.draw_lines(shaft, flat);
    } else {
      style = {.diameter = static_cast<float>(1.6 * kGizmoBallRadius),
               .outline = glm::vec4(shaded, 1),
               .outline_width = 1.5f};
      mark.rgba = pack(glm::mix(look.background_top, shaded, 0.35f));
    }
    points.draw(std::span<const PointMark>(&mark, 1), style, flat);
    if (!ball.positive()) continue;
    Segments letter;
    for (const Stroke& s : kStrokes) {
      const dvec2 size(4.0, 4.2);
      if (s.letter == ball.axis / 2) {
        letter.push_back(segment(p + dvec3(size * s.a, 0), p + dvec3(size * s.b, 0), 1.7f, pack(glm::vec3(1))));
      }
    }
    segments.draw_lines(letter, flat);
  }
}

}  // namespace taxel::ui
