// Writes the recorded steps as images, as a WebP film, or as a video of ffmpeg if that is installed. A plan says before
// the first image which steps, how large, how many bytes, and whether all of it can be made.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/host/webp.h"
#include "app/studio/nouns/video/image_queue.h"
#include "app/studio/nouns/video/video_state.h"
#include "core/base/os/process.h"
#include "core/base/output.h"
#include "core/run/history/lanes.h"

namespace taxel::studio {

/// The frames of a video before the first one is made.
struct VideoPlan {
  std::string path;                  ///< NAME.webp, NAME.mp4 or NAME.gif, or a folder of images
  std::vector<std::uint64_t> steps;  ///< recorded step of each frame
  int width = 0, height = 0;         ///< [pixels]
  int rate = 50;                     ///< frames per second
  bool window = false;               ///< the whole window instead of the 3-D view
  double timestep = 0;               ///< simulated time of a step [s]; 0 if unknown
  bool annotated = false;            ///< with time and legend
  bool bars = false;                 ///< with the readings of the taxels as bars
  bool orbit = false;                ///< with a camera that turns once around the contact
};

/// Returns the format that a path names: .webp, .mp4, .gif, or images for any other name.
[[nodiscard]] ui::VideoFormat format_of(const std::string& path);
/// Returns whether a format is made by ffmpeg.
[[nodiscard]] bool needs_encoder(ui::VideoFormat format);
/// Returns the path with the extension of another format.
[[nodiscard]] std::string with_format(const std::string& path, ui::VideoFormat format);

/// Returns the steps that the settings choose of VideoSource: those with contact or of the period, or all if there are
/// none.
[[nodiscard]] StepRange chosen_steps(const ui::VideoState& settings);
/// Returns the plan of a video with these settings, of the steps of a run.
[[nodiscard]] VideoPlan plan_video(const std::string& path, const StepRange& steps, const ui::VideoState& settings);
/// Returns the plan of a film for a talk: 8 s of 30 frames, with time and legend, around the contact, in the size that
/// the settings name, or otherwise in 1920 x 1080 pixels. A run of few steps is shown slowly.
[[nodiscard]] VideoPlan plan_film(const std::string& path, const StepRange& steps, const ui::VideoState& settings);

/// Returns an upper estimate of the bytes on the disk while the video is made: all images, and the video.
[[nodiscard]] double estimated_bytes(const VideoPlan& plan);
/// Returns one line about a plan: "31 frames, 0.6 s in real time, 1280 x 720 pixels, at most 28 MB".
[[nodiscard]] std::string plan_text(const VideoPlan& plan);

/// Returns why a plan cannot be carried out, with the remedy; empty if nothing but the disk is in the way.
/// `has_encoder`: whether ffmpeg is installed.
[[nodiscard]] std::string why_no_video(const VideoPlan& plan, bool has_encoder);
/// Returns why no video can be made with the settings, with the remedy; empty if it can.
[[nodiscard]] std::string why_no_video(const ui::VideoState& settings, const std::string& path);
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
  /// Checks the plan, the folder, the room on the disk, and whether ffmpeg is installed if the format needs it. Throws
  /// Error with the reason and the remedy. `shown` is the step that is displayed now. The executor, on which images are
  /// encoded, must live longer than the maker.
  VideoMaker(VideoPlan plan, std::uint64_t shown, JobExecutor& executor);
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
  /// Whether the next image can be added now. Otherwise the earlier ones are still being encoded.
  [[nodiscard]] bool has_room() const { return queue_->has_room(); }
  /// Adds the next image, which a worker encodes. Throws Error if an earlier image could not be encoded or written.
  void add(gl::RgbImage image);
  /// Ends the video once all images are encoded, or begins or polls ffmpeg. Returns nothing while something is encoded.
  /// Throws Error if that fails.
  std::optional<VideoMade> finish();
  [[nodiscard]] ui::VideoProgress progress() const;

 private:
  void write_image(const gl::RgbImage& image);
  [[nodiscard]] int begin_ms(std::size_t image) const;
  [[nodiscard]] bool start_encoder(const std::string& images, const std::string& video);
  [[nodiscard]] std::string encoder_words() const;
  VideoMade keep_pictures(const std::string& why);
  VideoMade write_film();
  std::optional<VideoMade> run_encoder();

  VideoPlan plan_;
  std::string folder_name_;
  std::uint64_t shown_ = 0;
  std::size_t taken_ = 0;
  std::size_t written_ = 0;               ///< number of encoded images; changed by a worker
  std::unique_ptr<OutputFolder> folder_;  ///< folder of images; null for a WebP film
  std::unique_ptr<WebpFilm> film_;        ///< WebP film, or null; used by a worker
  os::ChildProcess encoder_;
  bool is_tried_ = false;              ///< the encoder was tried, or is not needed
  std::unique_ptr<ImageQueue> queue_;  ///< the last member: its destructor waits for the worker
};

}  // namespace taxel::studio
