// Writes the recorded steps as images, one after the other, and as a video if ffmpeg is installed.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/features/video/video_state.h"
#include "core/base/os/process.h"
#include "core/base/output_folder.h"
#include "core/run/history/lanes.h"

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
  /// `path` is NAME.mp4 or NAME.gif, otherwise a folder for frame_000001.png and so on. Throws Error if the path cannot
  /// be written.
  VideoMaker(const std::string& path, const StepRange& steps, const ui::VideoState& settings, std::uint64_t shown);
  VideoMaker(const VideoMaker&) = delete;
  VideoMaker& operator=(const VideoMaker&) = delete;
  ~VideoMaker() = default;

  [[nodiscard]] std::optional<std::uint64_t> wanted() const;           ///< step of the next image; empty if complete
  [[nodiscard]] std::uint64_t shown_before() const { return shown_; }  ///< step displayed when the video began
  [[nodiscard]] bool of_window() const { return settings_.window; }
  [[nodiscard]] std::string next_file() const;  ///< path of the next image
  void taken() { ++taken_; }
  /// Begins to encode the images once all are written, or polls the encoder. Returns nothing while the encoder runs.
  /// Throws Error if the encoder fails.
  std::optional<VideoMade> finish();
  [[nodiscard]] ui::VideoProgress progress() const;

 private:
  [[nodiscard]] bool start_encoder();
  [[nodiscard]] std::string encoder_words() const;
  VideoMade keep_pictures(const std::string& why);

  std::string path_, folder_name_;
  std::vector<std::uint64_t> steps_;
  ui::VideoState settings_;
  std::uint64_t shown_ = 0;
  std::size_t taken_ = 0;
  std::unique_ptr<OutputFolder> folder_;
  os::ChildProcess encoder_;
};

}  // namespace taxel::studio
