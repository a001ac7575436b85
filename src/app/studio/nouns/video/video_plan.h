// The frames of a video before the first one is made: which steps, how large, how many bytes, and whether all of it can
// be made.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/studio/nouns/video/video_state.h"
#include "core/run/history/lanes.h"

namespace taxel::studio {

struct VideoPlan {
  std::string path;                  ///< NAME.mp4 or NAME.gif, or a folder of images
  std::vector<std::uint64_t> steps;  ///< recorded step of each frame
  int width = 0, height = 0;         ///< [pixels]
  int rate = 50;                     ///< frames per second
  bool window = false;               ///< the whole window instead of the 3-D view
  bool annotated = false;            ///< with time and legend
  bool orbit = false;                ///< with a camera that turns once around the contact
};

/// Returns the format that a path names: .mp4, .gif, or images for any other name.
[[nodiscard]] ui::VideoFormat format_of(const std::string& path);
/// Returns the path with the extension of another format.
[[nodiscard]] std::string with_format(const std::string& path, ui::VideoFormat format);

/// Returns the plan of a video with these settings, of the steps of a run.
[[nodiscard]] VideoPlan plan_video(const std::string& path, const StepRange& steps, const ui::VideoState& settings);
/// Returns the plan of a film for a talk: 8 s of 30 frames, with time and legend, around the contact, in the size that
/// the settings name, or otherwise in 1920 x 1080 pixels. A run of few steps is shown slowly.
[[nodiscard]] VideoPlan plan_film(const std::string& path, const StepRange& steps, const ui::VideoState& settings);

/// Returns an upper estimate of the bytes on the disk while the video is made: all images, and the video.
[[nodiscard]] double estimated_bytes(const VideoPlan& plan);
/// Returns one line about a plan: "31 frames, 0.6 s, 1280 x 720 pixels, at most 28 MiB".
[[nodiscard]] std::string plan_text(const VideoPlan& plan);

/// Throws Error with the reason and the remedy if the plan cannot be carried out with this much room on the disk.
void check_plan(const VideoPlan& plan, double free_bytes);

}  // namespace taxel::studio
