// Writes the recorded steps as images, one after the other, and as a video if ffmpeg is installed. A plan says before
// the first image which steps, how large, how many bytes, and whether all of it can be made.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/nouns/video/video_state.h"
#include "core/base/os/process.h"
#include "core/base/output.h"
#include "core/run/history/lanes.h"

namespace taxel::studio {

/// The frames of a video before the first one is made.
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

/// The result of making a video.
struct VideoMade {
  std::string text;
  bool complete = true;  ///< false if only the images were written
};

/// Makes a video of steps as the window displays them. Until the video is finished, no file has a requested name. A
/// maker that is destroyed earlier leaves no files.
class VideoMaker {
 public:
  /// Checks everything but the encoder: the plan, the folder, the room on the disk. Throws Error with the reason and
  /// the remedy. `shown` is the step that is displayed now.
  VideoMaker(VideoPlan plan, std::uint64_t shown);
  VideoMaker(const VideoMaker&) = delete;
  VideoMaker& operator=(const VideoMaker&) = delete;
  ~VideoMaker() = default;

  /// Path of the image with which the encoder is tried, or empty if the video needs no encoder. The caller writes an
  /// image of the video's size before the first call of is_ready().
  [[nodiscard]] std::string sample_file() const;
  /// Returns whether the encoder has encoded the sample; false while it runs. Throws Error with the reason and the
  /// remedy if there is no encoder or it fails.
  bool is_ready();

  [[nodiscard]] const VideoPlan& plan() const { return plan_; }
  [[nodiscard]] std::optional<std::uint64_t> wanted() const;           ///< step of the next image; empty if complete
  [[nodiscard]] double fraction() const;                               ///< fraction of the images before the next one
  [[nodiscard]] std::uint64_t shown_before() const { return shown_; }  ///< step displayed when the video began
  [[nodiscard]] std::string next_file() const;                         ///< path of the next image
  void taken() { ++taken_; }
  /// Begins to encode the images once all are written, or polls the encoder. Returns nothing while the encoder runs.
  /// Throws Error if the encoder fails.
  std::optional<VideoMade> finish();
  [[nodiscard]] ui::VideoProgress progress() const;

 private:
  [[nodiscard]] bool start_encoder(const std::string& images, const std::string& video);
  [[nodiscard]] std::string encoder_words() const;
  VideoMade keep_pictures(const std::string& why);

  VideoPlan plan_;
  std::string folder_name_;
  std::uint64_t shown_ = 0;
  std::size_t taken_ = 0;
  std::unique_ptr<OutputFolder> folder_;
  os::ChildProcess encoder_;
  bool is_tried_ = false;  ///< the encoder was tried, or is not needed
};

}  // namespace taxel::studio
