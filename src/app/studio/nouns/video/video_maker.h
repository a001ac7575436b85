// Writes the recorded steps as images, one after the other, and as a video if ffmpeg is installed.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/nouns/video/video_plan.h"
#include "core/base/os/process.h"
#include "core/base/output/output_folder.h"

namespace taxel::studio {

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
