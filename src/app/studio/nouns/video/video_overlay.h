// Time and legend, drawn into the images of a video.
#pragma once

#include <imgui.h>

#include <string>

#include "ui/scene/scene_input.h"

namespace taxel::ui {

/// The texts and colours of an image.
struct VideoNotes {
  std::string time;                      ///< such as "0.250 s"
  const PressureRange* range = nullptr;  ///< range of the legend, or null without a legend
  bool dark = true;
};

/// Draws the time into the lower left corner and the legend into the upper right one, in sizes that follow the image's.
void draw_video_notes(ImDrawList& list, int width, int height, const VideoNotes& notes);

}  // namespace taxel::ui
