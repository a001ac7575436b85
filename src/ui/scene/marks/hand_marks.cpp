// Marks of a grabbed body, and of the constraints between bodies.
#include "ui/scene/marks/marks.h"

#include <array>
#include <cmath>

namespace taxel::ui {
namespace {

constexpr float kHandWidth = 3.0f, kHeldWidth = 2.0f, kGrabbedDiameter = 8, kHeldDiameter = 6;
constexpr float kSpringTowardEye = 0.006f, kHiddenSpringDim = 0.5f;
constexpr double kArcPart = 0.12;  // radius as a fraction of the distance to the eye
constexpr int kArcPieces = 24;

/// Returns an arc around the grabbed point, from the orientation of the grabbed body to that of the pointer.
Segments arc(const PerturbShown& hand, double radius, std::uint32_t color) {
  const dquat q = hand.target_turn_W.w < 0 ? -hand.target_turn_W : hand.target_turn_W;
  const dvec3 sine(q.x, q.y, q.z);
  const double angle = 2 * std::atan2(glm::length(sine), q.w);
  Segments lines;
  if (!(angle > 0)) return lines;
  const dvec3 axis = glm::normalize(sine), arm = radius * any_perpendicular(axis);
  dvec3 from = hand.grabbed_W + arm;
  for (int i = 1; i <= kArcPieces; ++i) {
    const dvec3 to = hand.grabbed_W + glm::angleAxis(angle * i / kArcPieces, axis) * arm;
    lines.push_back(segment(from, to, kHandWidth, color));
    from = to;
  }
  lines.push_back(segment(hand.grabbed_W - axis * radius, hand.grabbed_W + axis * radius, kHeldWidth, color));
  return lines;
}

void draw_hand(const PerturbShown& hand, const Camera& camera, const Look& look, SegmentPass& segments,
               PointPass& points) {
  const std::uint32_t color = pack(look.hand);
  const MarkState state{.toward_eye = kSpringTowardEye, .depth_test = false};
  if (hand.kind == Perturb::Kind::turn) {
    segments.draw_lines(arc(hand, kArcPart * camera.depth_scale(glm::length(hand.grabbed_W - camera.eye())), color),
                        state);
  } else {
    const std::array<Segment, 1> pull{segment(hand.grabbed_W, hand.target_W, kHandWidth, color)};
    segments.draw_arrows(pull, state, look.mark_outline);
  }
  const std::array<PointMark, 1> grabbed{point_mark(hand.grabbed_W, dvec3(0), 1.0, color)};
  points.draw(grabbed, {.diameter = kGrabbedDiameter, .outline = look.mark_outline, .outline_width = 1.4f}, state);
}

}  // namespace

void draw_hand_marks(const SceneInput& input, const Camera& camera, const Look& look, SegmentPass& segments,
                     PointPass& points) {
  if (!input.frame) return;
  if (input.overlays.constraints && !input.frame->constraint_points.empty()) {
    Segments lines;
    std::vector<PointMark> ends;
    for (const ConstraintPoints& held : input.frame->constraint_points) {
      const std::uint32_t color = pack(held.weld ? look.weld : look.connection);
      lines.push_back(segment(held.a_W, held.b_W, kHeldWidth, color));
      for (const dvec3& p : {held.a_W, held.b_W}) ends.push_back(point_mark(p, dvec3(0), 1.0, color));
    }
    const PointStyle dots{.diameter = kHeldDiameter, .outline = look.mark_outline, .outline_width = 1.0f};
    const MarkState behind{.toward_eye = kSpringTowardEye, .hidden = true, .dim = kHiddenSpringDim};
    segments.draw_lines(lines, behind);
    points.draw(ends, dots, behind);
    segments.draw_lines(lines, {.toward_eye = kSpringTowardEye});
    points.draw(ends, dots, {.toward_eye = kSpringTowardEye});
  }
  if (input.frame->perturbed) draw_hand(*input.frame->perturbed, camera, look, segments, points);
}

}  // namespace taxel::ui
