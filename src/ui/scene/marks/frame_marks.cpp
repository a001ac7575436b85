// The axes of the frames of a scene.
#include "ui/scene/marks/marks.h"

#include "ui/scene/scene_parts.h"

namespace taxel::ui {
namespace {

constexpr float kAxisWidth = 2.6f, kAxisTowardEye = 0.002f, kHiddenAxisDim = 0.6f;
constexpr double kPartOfScene = 0.1;  // fraction of the scene's size, if the size of bodies is unknown

}  // namespace

void draw_frame_marks(const SceneInput& input, const Look& look, SegmentPass& segments) {
  const std::vector<Pose> frames = shown_frames(input);
  if (frames.empty()) return;
  const double told = input.frame->scene->marks.mean_size;
  const double size = told > 0 ? told : kPartOfScene * scene_bounds(input).diagonal();
  const double length = input.overlays.frames == FramesShown::world ? 2 * size : size;
  const std::array<std::uint32_t, 3> colors{pack(look.axis_x), pack(look.axis_y), pack(look.axis_z)};
  Segments lines;
  for (const Pose& X_WF : frames) {
    const dmat3 axes = X_WF.rotation();
    for (int i = 0; i < 3; ++i)
      lines.push_back(segment(X_WF.p, X_WF.p + length * axes[i], kAxisWidth, colors.at(static_cast<std::size_t>(i))));
  }
  segments.draw_lines(lines, {.toward_eye = kAxisTowardEye, .hidden = true, .dim = kHiddenAxisDim});
  segments.draw_lines(lines, {.toward_eye = kAxisTowardEye});
}

}  // namespace taxel::ui
