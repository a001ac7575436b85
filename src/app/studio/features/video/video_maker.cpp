#include "app/studio/features/video/video_maker.h"

#include <fmt/format.h>

#include <filesystem>

#include "core/base/error.h"
#include "core/base/files.h"

namespace taxel::studio {
namespace fs = std::filesystem;
namespace {

constexpr const char* kPictureName = "frame_{:06}.png";

bool is_video(const std::string& path) {
  return path.ends_with(".mp4") || path.ends_with(".gif");
}

/// Returns the arguments with which ffmpeg makes a video from the images in the folder `staging`.
std::vector<std::string> encoder_arguments(const std::string& path, const fs::path& staging, int rate) {
  const bool gif = path.ends_with(".gif");
  // A GIF gets its own palette. An MP4 gets even side lengths, as required by the pixel format that every player
  // supports.
  const std::string filter = gif ? "split[a][b];[a]palettegen[p];[b][p]paletteuse" : "pad=ceil(iw/2)*2:ceil(ih/2)*2";
  std::vector<std::string> arguments{"ffmpeg",
                                     "-nostdin",
                                     "-y",
                                     "-loglevel",
                                     "error",
                                     "-framerate",
                                     std::to_string(rate),
                                     "-i",
                                     (staging / "frame_%06d.png").string(),
                                     "-vf",
                                     filter};
  if (!gif) arguments.insert(arguments.end(), {"-pix_fmt", "yuv420p"});
  arguments.push_back((staging / (gif ? "video.gif" : "video.mp4")).string());
  return arguments;
}

}  // namespace

VideoMaker::VideoMaker(const std::string& path, const StepRange& steps, const ui::VideoState& settings,
                       std::uint64_t shown)
    : path_(path), settings_(settings), shown_(shown) {
  for (std::uint64_t step = steps.first; step <= steps.last; step += static_cast<std::uint64_t>(settings.every))
    steps_.push_back(step);
  folder_name_ = is_video(path) ? fs::path(path).replace_extension("").string() + "_frames" : path;
  folder_ = std::make_unique<OutputFolder>(folder_name_);
}

std::optional<std::uint64_t> VideoMaker::wanted() const {
  return taken_ < steps_.size() ? std::optional(steps_[taken_]) : std::nullopt;
}

std::string VideoMaker::next_file() const {
  return (folder_->staging() / fmt::format(fmt::runtime(kPictureName), taken_ + 1)).string();
}

ui::VideoProgress VideoMaker::progress() const {
  return {true, encoder_.runs(), taken_, steps_.size()};
}

/// Starts ffmpeg. Returns false if ffmpeg is not installed.
bool VideoMaker::start_encoder() {
  return encoder_.start(encoder_arguments(path_, folder_->staging(), settings_.rate),
                        folder_->staging() / "encoder.log");
}

/// Returns the last message of the encoder.
std::string VideoMaker::encoder_words() const {
  std::string text;
  try {
    text = read_file(folder_->staging() / "encoder.log");
  } catch (const Error&) {  // the encoder wrote no message
  }
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text.substr(text.find_last_of('\n') == std::string::npos ? 0 : text.find_last_of('\n') + 1);
}

VideoMade VideoMaker::keep_pictures(const std::string& why) {
  std::error_code ignored;
  for (const char* other : {"encoder.log", "video.mp4", "video.gif"}) fs::remove(folder_->staging() / other, ignored);
  // Images of a longer video in the folder would be mistaken for images of this video.
  for (std::size_t i = taken_ + 1;; ++i) {
    const std::string name = fmt::format(fmt::runtime(kPictureName), i);
    if (!fs::exists(fs::path(folder_name_) / name, ignored)) break;
    folder_->leave_out(name);
  }
  folder_->commit();
  const std::string where = fs::absolute(folder_name_).string();
  return {fmt::format("{}{} PNG frames are in {}", why, taken_, where), why.empty()};
}

std::optional<VideoMade> VideoMaker::finish() {
  if (!is_video(path_)) return keep_pictures("");
  if (!encoder_.runs()) {
    if (start_encoder()) return std::nullopt;
    return keep_pictures("ffmpeg not found: saved PNG frames instead of " + path_ + ". ");
  }
  const std::optional<int> status = encoder_.ended();
  if (!status) return std::nullopt;
  const fs::path made = folder_->staging() / (path_.ends_with(".gif") ? "video.gif" : "video.mp4");
  std::error_code failed;
  if (*status != 0 || !fs::exists(made, failed))
    return keep_pictures(fmt::format("ffmpeg failed ({}): saved PNG frames instead of {}. ", encoder_words(), path_));
  fs::rename(made, path_, failed);
  if (failed) throw Error(path_, fmt::format("cannot be written: {}", failed.message()));
  return VideoMade{fmt::format("Wrote {} with {} frames", fs::absolute(path_).string(), taken_), true};
}

}  // namespace taxel::studio
