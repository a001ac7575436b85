// The recorded steps as pictures, one after the other, and as a video where ffmpeg is installed.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/features/video/video_state.h"
#include "core/base/output_folder.h"
#include "core/run/history/lanes.h"

namespace taxel::studio {

/// What a video came to.
struct VideoMade {
  std::string text;
  bool complete = true;  ///< else there are only its pictures
};

/// Of steps, and of what is shown while they are. Until it is finished nothing lies under the names that were asked
/// for; destroyed before, it leaves nothing.
class VideoMaker {
 public:
  /// `path`: NAME.mp4 or NAME.gif, else a folder for frame_000001.png and so on. Throws Error where that cannot be
  /// written.
  VideoMaker(const std::string& path, const StepRange& steps, const ui::VideoState& settings, std::uint64_t shown);
  VideoMaker(const VideoMaker&) = delete;
  VideoMaker& operator=(const VideoMaker&) = delete;
  ~VideoMaker();

  [[nodiscard]] std::optional<std::uint64_t> wanted() const;  ///< step of the next picture; none: there are all
  [[nodiscard]] std::uint64_t shown_before() const { return shown_; }  ///< the step that was shown when it began
  [[nodiscard]] bool of_window() const { return settings_.window; }
  [[nodiscard]] std::string next_file() const;  ///< where the next picture is to be written
  void taken() { ++taken_; }
  /// When there are all pictures: begins to encode them, or looks how far that is. None: it goes on. Throws Error where
  /// the encoder fails.
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
  pid_t encoder_ = 0;  ///< its process; 0: none runs
};

}  // namespace taxel::studio
