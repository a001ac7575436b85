// Time, force, legend and bars that are drawn into the images of a video.
#pragma once

#include <imgui.h>

#include <optional>
#include <string>
#include <vector>

#include "app/studio/nouns/bars/pressure_bars.h"
#include "ui/widgets/pressure_legend.h"

namespace taxel::ui {

/// The texts, colours and bars of an image.
struct VideoNotes {
  std::string time;                    ///< such as "0.250 s"; empty to draw none
  std::string force;                   ///< such as "force 1.25 N", below the time; empty to draw none
  std::optional<LegendScales> legend;  ///< ranges of the legend; empty to draw none
  std::vector<BarGroup> bars;          ///< readings of the sensors; empty to draw none
  Selection selection;                 ///< its sensor gives the axis of the bars its unit
  bool dark = true;
};

/// The places of the notes in an image [pixels]; empty for notes that are not drawn.
struct VideoPlates {
  Rect time, legend, bars;
};

/// Draws notes for an image of this size: time and force into the lower left corner, the bars to the right of it, and
/// the legend into the upper right corner, in sizes that follow the image's. They do not overlap: a legend or bars for
/// which a small image has no room are left out.
VideoPlates draw_video_notes(ImDrawList& list, ImVec2 image, const VideoNotes& notes);

}  // namespace taxel::ui
